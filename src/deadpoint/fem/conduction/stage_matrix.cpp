#include "deadpoint/fem/conduction/stage_matrix.hpp"

#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/algebra/shell_matrix.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/multigrid/coarse_matrices.hpp"
#include "deadpoint/fem/conduction/multigrid/float_cycle.hpp"
#include "deadpoint/fem/conduction/multigrid/next_correction.hpp"
#include "deadpoint/fem/conduction/terms/film_points.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/conduction/terms/material_maps.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"

#include <algorithm>
#include <cmath>
#ifdef PETSC_HAVE_ML
#include <ml_utils.h>
#endif

namespace deadpoint::fem {
namespace {

// Largest ratio of step sizes that share a multigrid hierarchy. Beyond, the bounds of its smoother may fail.
constexpr double largest_reuse = 2.5;
// Below the value of the shortest step: the mass dominates the matrix [s].
constexpr double shortest_factor = 1e-7;
constexpr double largest_growth = 1e10;  // of a residual, before a solve counts as failed
constexpr int most_iterations = 2000;

// Aggregates by Trilinos' ML take fewer iterations; PETSc's own stand in where PETSc was built without it.
#ifdef PETSC_HAVE_ML
constexpr PCType hierarchy = PCML;
#else
constexpr PCType hierarchy = PCGAMG;
#endif

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
    // Aggregates ignore weak couplings across films, which would only make them worse. Aggregates and their
    // interpolation, which are half of a hierarchy's cost, are used again; see prepare().
#ifdef PETSC_HAVE_ML
    default_option("-heat_cycle_pc_ml_Threshold", "0.01");
    default_option("-heat_cycle_pc_ml_reuse_interpolation", "true");
#endif
    default_option("-heat_cycle_pc_gamg_threshold", "0.01");
    default_option("-heat_cycle_pc_gamg_reuse_interpolation", "true");
    // The library's smoothers are not used; these need no set-up.
    default_option("-heat_cycle_mg_levels_ksp_type", "richardson");
    default_option("-heat_cycle_mg_levels_pc_type", "jacobi");
}

PC preconditioner_of(KSP solver)
{
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver, &preconditioner));
    return preconditioner;
}

PetscErrorCode report(const std::exception& error)
{
    return PetscError(PETSC_COMM_SELF, __LINE__, "multigrid", __FILE__, PETSC_ERR_LIB, PETSC_ERROR_INITIAL, "%s",
                      error.what());
}

}  // namespace

StageMatrix::StageMatrix(const Discretisation& space, const HeatMatrices& matrices, const MaterialMaps& maps,
                         const PrescribedTemperatures& prescribed, const FilmPoints& films, double longest)
    : space_(space), matrices_(matrices), maps_(maps), prescribed_(prescribed), films_(films), longest_(longest)
{
    DEADPOINT_PETSC(MatDuplicate(matrices_.stiffness(), MAT_SHARE_NONZERO_PATTERN, system_.out()));
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
    const PC preconditioner = preconditioner_of(solver_);
    DEADPOINT_PETSC(PCSetType(preconditioner, PCSHELL));
    DEADPOINT_PETSC(PCShellSetContext(preconditioner, this));
    DEADPOINT_PETSC(PCShellSetApply(preconditioner, &StageMatrix::apply_cycle));
    DEADPOINT_PETSC(PCShellSetView(preconditioner, &StageMatrix::view_cycle));
    set_default_options();
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "heat_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
    DEADPOINT_PETSC(KSPSetOperators(solver_, *shell_, system_));
    choose_test();
}

// Where options leave conjugate gradients and the cycle.
void StageMatrix::choose_test()
{
    PetscBool conjugate = PETSC_FALSE, cycles = PETSC_FALSE;
    DEADPOINT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(KSP(solver_)), KSPCG, &conjugate));
    DEADPOINT_PETSC(
        PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner_of(solver_)), PCSHELL, &cycles));
    predicts_ = conjugate == PETSC_TRUE && cycles == PETSC_TRUE;
    if (!predicts_)
        return;
    DEADPOINT_PETSC(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
    DEADPOINT_PETSC(KSPSetConvergenceTest(solver_, &StageMatrix::test, this, nullptr));
}

// A correction, B times the residual, is about as large as the error. Its norm decides when to stop. Before the next
// cycle is run, its correction is expected to be smaller than the last one as the residual became smaller, so that no
// cycle runs only to say that none is needed.
PetscErrorCode StageMatrix::test(KSP, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                                 void* stage) noexcept
{
    auto& self = *static_cast<StageMatrix*>(stage);
    auto& progress = self.progress_;
    *reason = KSP_CONVERGED_ITERATING;
    if (!std::isfinite(residual))
        *reason = KSP_DIVERGED_NANORINF;
    else if (residual == 0)
        *reason = KSP_CONVERGED_ATOL;
    else if (iteration > 0) {
        const double expected = next_correction(progress.correction, residual, progress.residual);
        if (expected <= std::max(progress.relative * progress.size, progress.absolute))
            *reason = KSP_CONVERGED_ATOL;
        else if (residual > largest_growth * progress.first_residual)
            *reason = KSP_DIVERGED_DTOL;
    } else {
        progress.first_residual = residual;
    }
    progress.residual = residual;
    return 0;
}

PetscErrorCode StageMatrix::apply_cycle(PC shell, Vec in, Vec out) noexcept
{
    void* stage = nullptr;
    if (const PetscErrorCode code = PCShellGetContext(shell, static_cast<void*>(&stage)); code != 0)
        return code;
    auto& self = *static_cast<StageMatrix*>(stage);
    try {
        self.cycle_->apply(in, out);
    } catch (const std::exception& error) {
        return report(error);
    }
    auto& progress = self.progress_;
    const PetscErrorCode code = VecNorm(out, NORM_2, &progress.correction);
    progress.size = std::max(progress.size, progress.correction);
    return code;
}

PetscErrorCode StageMatrix::view_cycle(PC shell, PetscViewer viewer) noexcept
{
    void* stage = nullptr;
    if (const PetscErrorCode code = PCShellGetContext(shell, static_cast<void*>(&stage)); code != 0)
        return code;
    try {
        static_cast<StageMatrix*>(stage)->cycle_->view(viewer);
        return 0;
    } catch (const std::exception& error) {
        return report(error);
    }
}

StageMatrix::~StageMatrix() = default;

bool StageMatrix::follows_temperature() const { return films_.some() || maps_.vary(); }

void StageMatrix::reset(double longest)
{
    longest_ = longest;
    factor_ = multigrid_factor_ = -1;
    coarse_.reset();
    cycle_.reset();
    multigrid_.reset();
}

// A new hierarchy is a function of its matrices alone, so that a resumed run can build it again: ML estimates
// eigenvalues from the same random vectors, and so does PETSc's own hierarchy, where PETSc comes without ML.
void StageMatrix::create_multigrid()
{
    cycle_.reset();
    DEADPOINT_PETSC(PCCreate(PETSC_COMM_WORLD, multigrid_.out()));
    DEADPOINT_PETSC(PCSetOperators(multigrid_, system_, system_));
    DEADPOINT_PETSC(PCSetType(multigrid_, hierarchy));
    DEADPOINT_PETSC(PCSetOptionsPrefix(multigrid_, "heat_cycle_"));
    DEADPOINT_PETSC(PCSetFromOptions(multigrid_));
#ifdef PETSC_HAVE_ML
    ML_set_random_seed(1 + rank());
#endif
}

// Aggregates and interpolation of the multigrid, from a matrix that conduction rules, where coarse levels matter; they
// serve every step size. So do two sets of coarse matrices, where nothing but the factor changes.
void StageMatrix::prepare()
{
    if (coarse_)
        return;
    create_multigrid();
    coarse_ = std::make_unique<CoarseMatrices>();
    for (const double factor : {longest_, shortest_factor}) {
        fill(factor, nullptr, nullptr);
        DEADPOINT_PETSC(PCSetUp(multigrid_));
        if (follows_temperature())
            break;
        coarse_->keep(multigrid_, factor);
    }
}

bool StageMatrix::combine(double factor, Vec temperature)
{
    prepare();
    fill(factor, matrices_.films(), temperature);
    factor_ = factor;
    const bool near = factor < largest_reuse * multigrid_factor_ && multigrid_factor_ < largest_reuse * factor;
    // A temperature-dependent matrix changes little per step, so the old multigrid remains usable.
    if (follows_temperature() && near)
        return false;
    multigrid_factor_ = factor;
    if (follows_temperature() && temperature) {
        prepare_preconditioner_temperature(temperature);
        DEADPOINT_PETSC(VecCopy(temperature, origin_));
    }
    if (coarse_->complete()) {
        coarse_->follow(multigrid_, factor);
        renew_cycle(coarse_->bounds());
    } else {
        DEADPOINT_PETSC(PCSetUp(multigrid_));
        renew_cycle(smoother_bounds(multigrid_));
    }
    return true;
}

void StageMatrix::renew_cycle(const std::vector<double>& bounds)
{
    if (!cycle_)
        cycle_ = std::make_unique<FloatCycle>(multigrid_);
    cycle_->take_values(bounds);
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
    low_rank_ = &low_rank;
    return solve(right, solution, 0, tolerance, what);
}

int StageMatrix::solve_from_guess(Vec right, Vec solution, double relative, const char* what)
{
    low_rank_ = nullptr;
    PetscReal size = 0;
    DEADPOINT_PETSC(VecNorm(solution, NORM_2, &size));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
    const int iterations = solve(right, solution, size, {relative, 0}, what);
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
    return iterations;
}

// The relative tolerance counts for `size` or the size of the largest correction.
int StageMatrix::solve(Vec right, Vec solution, double size, heat::SolveTolerance tolerance, const char* what)
{
    const double absolute = tolerance.absolute * std::sqrt(static_cast<double>(space_.total));
    progress_ = {tolerance.relative, absolute, size, 0, 0, 0};
    DEADPOINT_PETSC(
        KSPSetTolerances(solver_, tolerance.relative, std::max(absolute, 1e-300), largest_growth, most_iterations));
    return shell_->use([&] { return fem::solve(solver_, right, solution, what); });
}

}  // namespace deadpoint::fem
