#include "deadpoint/fem/heat_solver.hpp"
#include "deadpoint/fem/session.hpp"
#include "deadpoint/fem/tr_bdf2.hpp"

#include <algorithm>
#include <ml_utils.h>

// The linear system of a stage and its solver.

namespace deadpoint::fem {
namespace {

// Of a multigrid hierarchy, in the ratio of step sizes. Beyond, the bounds of its smoother may not hold any more.
constexpr double largest_reuse = 2.5;
// Below that of the shortest step: mass alone rules the matrix [s].
constexpr double shortest_factor = 1e-7;

// Options that the user gave to PETSC win.
void default_option(const char* name, const char* value)
{
    PetscBool given = PETSC_FALSE;
    DEADPOINT_PETSC(PetscOptionsHasName(nullptr, nullptr, name, &given));
    if (!given)
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, name, value));
}

// Makes the next multigrid hierarchy a function of its matrices alone, so that a resumed run can build it again:
// without what smoothers keep of the last one, and with the same random vectors, from which ML estimates eigenvalues.
void begin_anew(KSP solver)
{
    PC multigrid = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver, &multigrid));
    DEADPOINT_PETSC(PCSetType(multigrid, PCNONE));
    DEADPOINT_PETSC(PCSetType(multigrid, PCML));
    DEADPOINT_PETSC(PCSetUseAmat(multigrid, PETSC_FALSE));
    DEADPOINT_PETSC(PCSetFromOptions(multigrid));
    ML_set_random_seed(1 + rank());
}

}  // namespace

void HeatSolver::prepare_solver()
{
    DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_COPY_VALUES, system_.out()));
    DEADPOINT_PETSC(MatSetOption(system_, MAT_SYMMETRIC, PETSC_TRUE));

    const PetscInt rows = space_.last - space_.first;
    DEADPOINT_PETSC(MatCreateShell(PETSC_COMM_WORLD, rows, rows, space_.total, space_.total, this, shell_.out()));
    DEADPOINT_PETSC(MatShellSetOperation(shell_, MATOP_MULT, reinterpret_cast<void (*)(void)>(&HeatSolver::multiply)));
    DEADPOINT_PETSC(MatSetOption(shell_, MAT_SYMMETRIC, PETSC_TRUE));

    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    prepare_tangents();
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    DEADPOINT_PETSC(PCSetType(preconditioner, PCML));
    // Weak couplings across films only blur the aggregates.
    default_option("-heat_pc_ml_Threshold", "0.01");
    // Of aggregates and their interpolation, which are half of a hierarchy's cost; see build_aggregates().
    default_option("-heat_pc_ml_reuse_interpolation", "true");
    // Runs at the memory's speed, which Gauss-Seidel sweeps do
    // not, and alike on any number of ranks.
    default_option("-heat_mg_levels_ksp_type", "chebyshev");
    default_option("-heat_mg_levels_ksp_max_it", "2");
    default_option("-heat_mg_levels_pc_type", "jacobi");
    // A bound that is too low turns the preconditioner indefinite where films are far stiffer than the metal.
    default_option("-heat_mg_levels_ksp_chebyshev_esteig", "0,0.1,0,1.2");
    default_option("-heat_mg_levels_esteig_ksp_type", "cg");
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "heat_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
    DEADPOINT_PETSC(KSPSetOperators(solver_, shell_, system_));
    build_aggregates();
}

// y = (M + factor (K + K_films)) x - factor sum of dH/dT b (b .
// x): heat that falls with temperature adds to the matrix, as a
// few rank-one terms that the preconditioner need not know.
PetscErrorCode HeatSolver::multiply(Mat shell, Vec in, Vec out)
{
    HeatSolver* self = nullptr;
    MatShellGetContext(shell, &self);
    MatMult(self->system_, in, out);
    self->air_->multiply(in, out);
    if (self->shell_slopes_.empty())
        return 0;
    std::vector<const SparseFunctional*> loads;
    for (const auto& load : self->shell_loads_)
        loads.push_back(&load);
    const auto products = evaluate(loads, in);
    for (std::size_t r = 0; r < products.size(); ++r)
        add_to(out, self->shell_loads_[r], -self->system_factor_ * self->shell_slopes_[r] * products[r]);
    return 0;
}

void HeatSolver::set_tolerance(double relative, double absolute)
{
    const double scale = std::sqrt(static_cast<double>(space_.total));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, relative, absolute * scale, 1e10, 2000));
}

void HeatSolver::build_system(double factor, Vec temperature)
{
    if (factor == system_factor_ && !variable_films_ && !materials_vary())
        return;
    const double* values = variable_films_ ? everywhere_->gather(temperature) : nullptr;
    build_air_loads(factor, values);
    if (variable_films_)
        assemble_variable_films([&](const Film& film) -> PointCoefficient {
            const double surroundings = ambient(*film.condition, time_);
            return [&film, values, surroundings, law = film_at(*film.condition, surroundings)](const FilmPoint& point) {
                const double at = value_at(point.shape, values);
                return film_slope(law(at), film.condition->emissivity, at, surroundings);
            };
        });
    combine_system(factor, temperature);
}

void HeatSolver::assemble_variable_films(const std::function<PointCoefficient(const Film&)>& coefficient_on)
{
    DEADPOINT_PETSC(MatZeroEntries(variable_));
    for (const auto& film : films_) {
        if (film.points.empty())
            continue;
        const auto coefficient = coefficient_on(film);
        for (const auto& point : film.points)
            insert_block(variable_, point.shape, point.shape, coefficient(point) * point.weight);
    }
    DEADPOINT_PETSC(MatAssemblyBegin(variable_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(variable_, MAT_FINAL_ASSEMBLY));
}

// Aggregates and interpolation of the multigrid, from a matrix that conduction rules, where coarse levels matter; they
// serve every step size. So do two sets of coarse matrices, where nothing but the factor changes.
void HeatSolver::build_aggregates()
{
    begin_anew(solver_);
    coarse_ = {};
    PC multigrid = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &multigrid));
    DEADPOINT_PETSC(KSPSetReusePreconditioner(solver_, PETSC_FALSE));
    for (const double factor : {longest_segment(*problem_), shortest_factor}) {
        fill_system(factor, nullptr, nullptr);
        DEADPOINT_PETSC(PCSetUp(multigrid));  // KSPSetUp would do so only the first time
        if (system_follows_temperature())
            break;
        coarse_.keep(multigrid, factor);
    }
    aggregates_built_ = true;
}

void HeatSolver::combine_system(double factor, Vec temperature)
{
    if (!aggregates_built_)
        build_aggregates();
    fill_system(factor, variable_, temperature);
    system_factor_ = factor;
    const bool near = factor < largest_reuse * multigrid_factor_ && multigrid_factor_ < largest_reuse * factor;
    // A matrix that follows the temperature changes little at a time: the old multigrid still serves it.
    const bool anew = system_follows_temperature() && !near;
    DEADPOINT_PETSC(KSPSetReusePreconditioner(solver_, anew ? PETSC_FALSE : PETSC_TRUE));
    if (system_follows_temperature() && near)
        return;
    multigrid_factor_ = factor;
    note_multigrid(temperature);
    if (coarse_.complete()) {
        PC multigrid = nullptr;
        DEADPOINT_PETSC(KSPGetPC(solver_, &multigrid));
        coarse_.follow(multigrid, factor);
    }
}

// system = M + factor (K + K_films), with tangents at a temperature if one is given.
void HeatSolver::fill_system(double factor, Mat films, Vec temperature)
{
    DEADPOINT_PETSC(MatCopy(stiffness_, system_, SAME_NONZERO_PATTERN));
    if (films)
        DEADPOINT_PETSC(MatAXPY(system_, 1, films, SAME_NONZERO_PATTERN));
    add_conduction_tangent(system_, temperature);
    DEADPOINT_PETSC(MatScale(system_, factor));
    add_capacity(system_, temperature);
    if (some_prescribed_)
        DEADPOINT_PETSC(MatZeroRowsColumns(system_, static_cast<PetscInt>(prescribed_.size()), prescribed_.data(), 1,
                                           nullptr, nullptr));
}

}  // namespace deadpoint::fem
