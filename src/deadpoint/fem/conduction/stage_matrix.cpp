#include "deadpoint/fem/conduction/stage_matrix.hpp"

#include "deadpoint/fem/conduction/coarse_matrices.hpp"
#include "deadpoint/fem/conduction/terms/film_points.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/conduction/terms/material_maps.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/fem/space/shell_matrix.hpp"
#include "deadpoint/fem/space/vectors.hpp"

#include <cmath>
#include <ml_utils.h>

namespace deadpoint::fem {
namespace {

// Of a multigrid hierarchy, in the ratio of step sizes. Beyond, the bounds of its smoother may not hold any more.
constexpr double largest_reuse = 2.5;
// Below the value of the shortest step: the mass dominates the matrix [s].
constexpr double shortest_factor = 1e-7;

// Options that the user gave to PETSc take precedence.
void default_option(const char* name, const char* value)
{
    PetscBool given = PETSC_FALSE;
    DEADPOINT_PETSC(PetscOptionsHasName(nullptr, nullptr, name, &given));
    if (!given)
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, name, value));
}

void set_default_options()
{
    // Aggregates ignore weak couplings across films, which would only make them worse.
    default_option("-heat_pc_ml_Threshold", "0.01");
    // Reuses aggregates and their interpolation, which are half of a hierarchy's cost; see prepare().
    default_option("-heat_pc_ml_reuse_interpolation", "true");
    // Chebyshev reaches the memory's bandwidth (Gauss-Seidel does not) and is the same on any number of ranks.
    default_option("-heat_mg_levels_ksp_type", "chebyshev");
    default_option("-heat_mg_levels_ksp_max_it", "2");
    default_option("-heat_mg_levels_pc_type", "jacobi");
    // If films are far stiffer than the metal, too low a bound makes the preconditioner indefinite.
    default_option("-heat_mg_levels_ksp_chebyshev_esteig", "0,0.1,0,1.2");
    default_option("-heat_mg_levels_esteig_ksp_type", "cg");
}

PC preconditioner_of(KSP solver)
{
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver, &preconditioner));
    return preconditioner;
}

// Makes the next multigrid hierarchy a function of its matrices alone, so that a resumed run can build it again:
// without what smoothers keep of the last one, and with the same random vectors, from which ML estimates eigenvalues.
void begin_anew(KSP solver)
{
    const PC multigrid = preconditioner_of(solver);
    DEADPOINT_PETSC(PCSetType(multigrid, PCNONE));
    DEADPOINT_PETSC(PCSetType(multigrid, PCML));
    DEADPOINT_PETSC(PCSetUseAmat(multigrid, PETSC_FALSE));
    DEADPOINT_PETSC(PCSetFromOptions(multigrid));
    ML_set_random_seed(1 + rank());
}

}  // namespace

StageMatrix::StageMatrix(const Discretisation& space, const HeatMatrices& matrices, const MaterialMaps& maps,
                         const PrescribedTemperatures& prescribed, const FilmPoints& films, double longest)
    : space_(space), matrices_(matrices), maps_(maps), prescribed_(prescribed), films_(films), longest_(longest)
{
    DEADPOINT_PETSC(MatDuplicate(matrices_.stiffness(), MAT_COPY_VALUES, system_.out()));
    DEADPOINT_PETSC(MatSetOption(system_, MAT_SYMMETRIC, PETSC_TRUE));
    shell_ = std::make_unique<ShellMatrix>(space_.last - space_.first, space_.total,
                                           [this](Vec in, Vec out) { multiply(in, out); });
    DEADPOINT_PETSC(MatSetOption(*shell_, MAT_SYMMETRIC, PETSC_TRUE));
    create_solver();
}

void StageMatrix::create_solver()
{
    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    if (maps_.vary()) {  // the tangent is not symmetric, so conjugate gradients cannot solve it
        for (const Mat matrix : {Mat(system_), Mat(*shell_)})
            DEADPOINT_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_FALSE));
        maps_.mark_tangents();
        DEADPOINT_PETSC(KSPSetType(solver_, KSPBCGS));
    }
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
    DEADPOINT_PETSC(PCSetType(preconditioner_of(solver_), PCML));
    set_default_options();
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "heat_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
    DEADPOINT_PETSC(KSPSetOperators(solver_, *shell_, system_));
}

StageMatrix::~StageMatrix() = default;

bool StageMatrix::follows_temperature() const { return films_.some() || maps_.vary(); }

void StageMatrix::reset(double longest)
{
    longest_ = longest;
    factor_ = multigrid_factor_ = -1;
    coarse_.reset();
}

// Aggregates and interpolation of the multigrid, from a matrix that conduction rules, where coarse levels matter; they
// serve every step size. So do two sets of coarse matrices, where nothing but the factor changes.
void StageMatrix::prepare()
{
    if (coarse_)
        return;
    begin_anew(solver_);
    coarse_ = std::make_unique<CoarseMatrices>();
    DEADPOINT_PETSC(KSPSetReusePreconditioner(solver_, PETSC_FALSE));
    for (const double factor : {longest_, shortest_factor}) {
        fill(factor, nullptr, nullptr);
        DEADPOINT_PETSC(PCSetUp(preconditioner_of(solver_)));  // KSPSetUp does this only the first time
        if (follows_temperature())
            break;
        coarse_->keep(preconditioner_of(solver_), factor);
    }
}

bool StageMatrix::combine(double factor, Vec temperature)
{
    prepare();
    fill(factor, matrices_.films(), temperature);
    factor_ = factor;
    const bool near = factor < largest_reuse * multigrid_factor_ && multigrid_factor_ < largest_reuse * factor;
    // A temperature-dependent matrix changes little per step, so the old multigrid remains usable.
    const bool anew = follows_temperature() && !near;
    DEADPOINT_PETSC(KSPSetReusePreconditioner(solver_, anew ? PETSC_FALSE : PETSC_TRUE));
    if (follows_temperature() && near)
        return false;
    multigrid_factor_ = factor;
    if (follows_temperature() && temperature) {
        prepare_preconditioner_temperature(temperature);
        DEADPOINT_PETSC(VecCopy(temperature, origin_));
    }
    if (coarse_->complete())
        coarse_->follow(preconditioner_of(solver_), factor);
    return true;
}

Vec StageMatrix::prepare_preconditioner_temperature(Vec pattern)
{
    if (follows_temperature() && !origin_)
        origin_ = duplicate(pattern);
    return origin_;
}

// system = M + factor (K + K_films), with tangents at a temperature if one is given.
void StageMatrix::fill(double factor, Mat films, Vec temperature)
{
    DEADPOINT_PETSC(MatCopy(matrices_.stiffness(), system_, SAME_NONZERO_PATTERN));
    if (films)
        DEADPOINT_PETSC(MatAXPY(system_, 1, films, SAME_NONZERO_PATTERN));
    maps_.add_conduction_tangent(system_, temperature);
    DEADPOINT_PETSC(MatScale(system_, factor));
    maps_.add_capacity(system_, temperature);
    const auto& held = prescribed_.unknowns();
    if (prescribed_.some())
        DEADPOINT_PETSC(
            MatZeroRowsColumns(system_, static_cast<PetscInt>(held.size()), held.data(), 1, nullptr, nullptr));
}

// The first use of a multigrid completes its set-up.
void StageMatrix::set_up(Vec any, Vec work)
{
    DEADPOINT_PETSC(KSPSetUp(solver_));
    DEADPOINT_PETSC(PCApply(preconditioner_of(solver_), any, work));
}

// Heat that falls with temperature adds a few rank-one terms to the matrix; the preconditioner may ignore them.
void StageMatrix::multiply(Vec in, Vec out) const
{
    DEADPOINT_PETSC(MatMult(system_, in, out));
    if (!low_rank_)
        return;
    for (const auto& [coefficient, load] : low_rank_->others) {
        PetscScalar product = 0;
        DEADPOINT_PETSC(VecDot(*load, in, &product));
        DEADPOINT_PETSC(VecAXPY(out, -coefficient * product, *load));
    }
    films_.multiply_rooms(factor_, in, out);
    const auto& slopes = low_rank_->source_slopes;
    if (slopes.empty())
        return;
    std::vector<const SparseFunctional*> loads;
    for (const auto& load : source_loads_)
        loads.push_back(&load);
    const auto products = evaluate(loads, in);
    for (std::size_t r = 0; r < products.size(); ++r)
        add_to(out, source_loads_[r], -factor_ * slopes[r] * products[r]);
}

int StageMatrix::solve(Vec right, Vec solution, const heat::LowRank<OwnedVec>& low_rank, heat::SolveTolerance tolerance,
                       const char* what)
{
    const double scale = std::sqrt(static_cast<double>(space_.total));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, tolerance.relative, tolerance.absolute * scale, 1e10, 2000));
    low_rank_ = &low_rank;
    return shell_->use([&] { return fem::solve(solver_, right, solution, what); });
}

int StageMatrix::solve_from_guess(Vec right, Vec solution, double relative, const char* what)
{
    low_rank_ = nullptr;
    DEADPOINT_PETSC(KSPSetTolerances(solver_, relative, 1e-300, 1e10, 2000));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
    const int iterations = shell_->use([&] { return fem::solve(solver_, right, solution, what); });
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
    return iterations;
}

}  // namespace deadpoint::fem
