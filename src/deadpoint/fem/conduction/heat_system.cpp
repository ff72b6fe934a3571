#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/conduction/tr_bdf2.hpp"
#include "deadpoint/fem/space/session.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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
    shell_ = std::make_unique<ShellMatrix>(rows, space_.total, [this](Vec in, Vec out) { multiply(in, out); });
    DEADPOINT_PETSC(MatSetOption(*shell_, MAT_SYMMETRIC, PETSC_TRUE));

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
    DEADPOINT_PETSC(KSPSetOperators(solver_, *shell_, system_));
    build_aggregates();
}

// y = (M + factor (K + K_films)) x - factor sum of dH/dT b (b .
// x): heat that falls with temperature adds to the matrix, as a
// few rank-one terms that the preconditioner need not know.
void HeatSolver::multiply(Vec in, Vec out) const
{
    DEADPOINT_PETSC(MatMult(system_, in, out));
    air_->multiply(in, out);
    multiply_rooms(in, out);
    if (shell_slopes_.empty())
        return;
    std::vector<const SparseFunctional*> loads;
    for (const auto& load : shell_loads_)
        loads.push_back(&load);
    const auto products = evaluate(loads, in);
    for (std::size_t r = 0; r < products.size(); ++r)
        add_to(out, shell_loads_[r], -system_factor_ * shell_slopes_[r] * products[r]);
}

void HeatSolver::solve_system(Vec right, Vec solution, const char* what)
{
    const auto with_term = [this](const Error& error) {
        return fmt::format("{}\n  the largest term of the heat balance at t = {:.6g} s is {}", error.what(), time_,
                           largest_term());
    };
    try {
        iterations_ += shell_->use([&] { return solve(solver_, right, solution, what); });
    } catch (const NotFinite& error) {
        throw DomainError(with_term(error) + "\n  help: give it a value that can be meant");
    } catch (const ConvergenceError& error) {
        throw ConvergenceError(with_term(error));
    }
}

namespace {

struct Term {
    std::string text;
    double size = 0;  ///< what it comes to, roughly [W]
};

}  // namespace

// What each quantity of the case comes to for a kelvin, or at the present temperatures; one that is not finite counts
// as the largest.
std::string HeatSolver::largest_term() const
{
    std::vector<Term> terms;
    const auto add = [&](const char* table, const std::string& name, const char* meaning, double value,
                         const char* unit, double factor = 1) {
        terms.push_back({fmt::format("the {} of {}.{}: {:.3g} {}", meaning, table, name, value, unit), value * factor});
    };
    const auto& parts = space_.machine.parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        add("parts", parts[p].name, "heat capacity",
            materials_[p].density * materials_[p].specific_heat * part_volume_[p], "J/K");
        add("parts", parts[p].name, "conductivity", materials_[p].conductivity, "W/m/K");
    }
    for (std::size_t i = 0; i < interfaces_.size(); ++i)
        add("joints", space_.machine.interfaces[i].name, "conductance", interfaces_[i].sum * interfaces_[i].area,
            "W/K");
    for (std::size_t r = 0; r < problem_->sources.size() && r < rate_now_.source_heat.size(); ++r)
        if (segment_ && segment_->heat[r])
            add("friction", problem_->sources[r].name, "heat", segment_->heat[r](rate_now_.source_temperature[r]).value,
                "W");
    for (std::size_t k = 0; k < problem_->body_heat.size(); ++k)
        if (segment_ && segment_->body_heat[k])
            add("heat_sources", problem_->body_heat[k].name, "power", segment_->body_heat[k](time_), "W");
    for (const auto& film : films_)
        if (film.condition->kind == SurfaceCondition::Kind::flux)
            add("surfaces", film.condition->name, "heat flux", film.condition->flux(time_), "W/m2", film.area);
        else
            add("surfaces", film.condition->name, "film", film.condition->coefficient, "W/m2/K", film.area);
    const auto size = [](const Term& term) { return std::isfinite(term.size) ? std::abs(term.size) : 1e308; };
    return terms.empty() ? "none" : std::ranges::max_element(terms, {}, size)->text;
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
    build_room_loads(values);
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
