#include "deadpoint/fem/conduction/heat_adjoint.hpp"

#include "deadpoint/fem/conduction/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

// Of each solve, in the norm of its solution: what is left out of the shares of all causes together is of this size.
constexpr double relative_tolerance = 1e-8;

}  // namespace

HeatAdjoint::HeatAdjoint(HeatSolver& solver)
    : solver_(solver), problem_(*solver.problem_), weights_(solver.before_), solution_(solver.middle_),
      middle_weights_(solver.next_), middle_solution_(solver.slope_before_), change_(solver.slope_middle_),
      mass_product_(solver.work_), stiffness_product_(solver.work2_)
{
    solver_.shell_slopes_.clear();  // the heat is as booked and no longer follows the temperature
    for (std::size_t k = 0; k < solver_.air_->count(); ++k)  // nor do the enclosures
        DEADPOINT_PETSC(VecSet(solver_.air_->load(k), 0));
    for (auto& room : solver_.rooms_)  // nor radiation inside them
        room.coupling.clear();
    solver_.system_factor_ = -1;
}

HeatCauses HeatAdjoint::causes(const std::vector<double>& weights, std::size_t row)
{
    causes_ = {};
    causes_.friction.assign(solver_.interfaces_.size(), 0.0);
    causes_.oil = causes_.friction;
    causes_.surfaces.assign(problem_.surfaces.size(), 0.0);
    causes_.body_heat.assign(problem_.body_heat.size(), 0.0);
    change_over_ = 0;
    film_coefficients_.clear();

    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(weights_, &values));
    std::copy(weights.begin(), weights.end(), values);
    DEADPOINT_PETSC(VecRestoreArray(weights_, &values));
    DEADPOINT_PETSC(VecSet(solution_, 0));
    DEADPOINT_PETSC(VecSet(middle_solution_, 0));
    for (auto step = solver_.steps_.rbegin(); step != solver_.steps_.rend(); ++step)
        if (step->row <= row) {
            enter(step->segment);
            step_back(*step);
        }
    add_start(weights_);
    return causes_;
}

void HeatAdjoint::enter(std::size_t segment)
{
    const auto& wanted = problem_.segments[segment];
    if (solver_.segment_ == &wanted)
        return;
    solver_.enter_segment(wanted);
    film_coefficients_.clear();
}

// Guesses: with y(s) for slowly fading weights, s the time before the step's end, y_2 stands for s = d and y_1 for
// s = 2 d but for the factor bdf_middle, to second order. change_ is y_1 / bdf_middle - y_2.
void HeatAdjoint::step_back(const StepRecord& step)
{
    const double factor = diagonal * step.duration;
    solve_stage(factor, step.end, weights_, solution_);
    add_prescribed(weights_, step.end.time);
    add_loads(solution_, factor, {&step.end});

    DEADPOINT_PETSC(MatMult(solver_.mass_, solution_, middle_weights_));
    DEADPOINT_PETSC(VecScale(middle_weights_, bdf_middle));
    DEADPOINT_PETSC(VecCopy(solution_, middle_solution_));
    if (change_over_ > 0)
        DEADPOINT_PETSC(VecAXPY(middle_solution_, step.duration / change_over_, change_));
    DEADPOINT_PETSC(VecScale(middle_solution_, bdf_middle));
    solve_stage(factor, step.middle, middle_weights_, middle_solution_);
    add_prescribed(middle_weights_, step.middle.time);
    add_loads(middle_solution_, factor, {&step.middle, &step.start});

    use_films(step.start);
    apply_stiffness(middle_solution_, stiffness_product_);
    DEADPOINT_PETSC(MatMult(solver_.mass_, middle_solution_, mass_product_));
    DEADPOINT_PETSC(VecCopy(mass_product_, weights_));
    DEADPOINT_PETSC(VecAXPY(weights_, -factor, stiffness_product_));
    DEADPOINT_PETSC(VecAXPY(weights_, -bdf_now / bdf_middle, middle_weights_));

    DEADPOINT_PETSC(VecCopy(middle_solution_, change_));
    DEADPOINT_PETSC(VecAXPBY(change_, -1, 1 / bdf_middle, solution_));
    change_over_ = step.duration;
    DEADPOINT_PETSC(VecAXPY(solution_, 1 / diagonal, change_));
}

bool HeatAdjoint::radiates_inside(std::size_t film) const
{
    const auto& condition = *solver_.films_[film].condition;
    return condition.enclosure >= 0 && condition.emissivity > 0;
}

// Of what a surface faces. Where it radiates to other surfaces and gives heat to enclosed air too: the temperature
// against which its coefficient makes what it lost.
double HeatAdjoint::surroundings(std::size_t film, const StageRecord& stage) const
{
    const auto& condition = *solver_.films_[film].condition;
    if (radiates_inside(film))
        return stage.film_mean[film] - stage.variable_to_air[solver_.films_[film].index] /
                                           (mean_coefficient(film, stage) * solver_.films_[film].area);
    return condition.enclosure >= 0 ? stage.air[static_cast<std::size_t>(condition.enclosure)].temperature
                                    : solver_.ambient(condition, stage.time);
}

// The coefficient with which a film would give off what it gave at that stage, if that is near the law's.
double HeatAdjoint::mean_coefficient(std::size_t film, const StageRecord& stage) const
{
    const auto& condition = *solver_.films_[film].condition;
    const double mean = stage.film_mean[film];
    if (radiates_inside(film)) {
        const double inside = stage.air[static_cast<std::size_t>(condition.enclosure)].temperature;
        return HeatSolver::film_slope(solver_.film_at(condition, inside)(mean), condition.emissivity, mean, inside);
    }
    const double air = surroundings(film, stage), rise = mean - air;
    const double squares = mean * mean + air * air;
    const double by_law =
        solver_.film_at(condition, air)(mean).value + condition.emissivity * stefan_boltzmann * squares * (mean + air);
    const double heat = stage.variable_to_air[solver_.films_[film].index];
    const double by_heat = heat / (solver_.films_[film].area * rise);
    return std::isfinite(by_heat) && by_heat > 0.5 * by_law && by_heat < 2 * by_law ? by_heat : by_law;
}

void HeatAdjoint::use_films(const StageRecord& stage)
{
    if (!solver_.variable_films_)
        return;
    const auto& films = solver_.films_;
    std::vector<double> coefficients(films.size(), 0.0);
    for (std::size_t i = 0; i < films.size(); ++i)
        if (const auto& condition = *films[i].condition; condition.kind == SurfaceCondition::Kind::film &&
                                                         films[i].area > 0 &&
                                                         HeatSolver::depends_on_temperature(condition))
            coefficients[i] = mean_coefficient(i, stage);
    if (coefficients == film_coefficients_)
        return;
    film_coefficients_ = std::move(coefficients);
    solver_.system_factor_ = -1;
    solver_.assemble_variable_films([&](const HeatSolver::Film& film) -> HeatSolver::PointCoefficient {
        const double value = film_coefficients_[static_cast<std::size_t>(&film - films.data())];
        return [value](const FilmPoint&) { return value; };
    });
}

void HeatAdjoint::apply_stiffness(Vec in, Vec out)
{
    DEADPOINT_PETSC(MatMult(solver_.stiffness_, in, out));
    if (solver_.variable_films_)
        DEADPOINT_PETSC(MatMultAdd(solver_.variable_, in, out, out));
    if (solver_.conduction_varies_)
        DEADPOINT_PETSC(MatMultAdd(solver_.conduction_, in, out, out));
}

// Leaves (M + factor K) of the solution, in `stiffness_product_`, where there are prescribed unknowns to need it.
void HeatAdjoint::solve_stage(double factor, const StageRecord& stage, Vec weights, Vec solution)
{
    use_films(stage);
    if (factor != solver_.system_factor_)
        solver_.combine_system(factor, nullptr);
    DEADPOINT_PETSC(VecCopy(weights, mass_product_));
    solver_.clear_prescribed(mass_product_);
    solver_.clear_prescribed(solution);
    DEADPOINT_PETSC(KSPSetTolerances(solver_.solver_, relative_tolerance, 1e-300, 1e10, 2000));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_.solver_, PETSC_TRUE));
    iterations_ +=
        solver_.shell_->use([&] { return solve(solver_.solver_, mass_product_, solution, "the weights of the heat"); });
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_.solver_, PETSC_FALSE));
    if (!solver_.some_prescribed_)
        return;
    apply_stiffness(solution, stiffness_product_);
    DEADPOINT_PETSC(VecScale(stiffness_product_, factor));
    DEADPOINT_PETSC(MatMultAdd(solver_.mass_, solution, stiffness_product_, stiffness_product_));
}

void HeatAdjoint::add_prescribed(Vec weights, double time)
{
    if (!solver_.some_prescribed_)
        return;
    std::vector<double> sums(problem_.surfaces.size(), 0.0);
    const double *right = nullptr, *left = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(weights, &right));
    DEADPOINT_PETSC(VecGetArrayRead(stiffness_product_, &left));
    for (std::size_t i = 0; i < solver_.prescribed_.size(); ++i) {
        const auto at = solver_.prescribed_[i] - solver_.space_.first;
        const auto& [position, condition] = solver_.prescribed_at_[i];
        sums[static_cast<std::size_t>(condition - problem_.surfaces.data())] +=
            (right[at] - left[at]) * (condition->temperature(position, time) - solver_.reference_);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(stiffness_product_, &left));
    DEADPOINT_PETSC(VecRestoreArrayRead(weights, &right));
    sum_over_ranks(sums);
    for (std::size_t i = 0; i < sums.size(); ++i)
        causes_.surfaces[i] += sums[i];
}

void HeatAdjoint::add_loads(Vec solution, double factor, const std::vector<const StageRecord*>& stages)
{
    std::vector<const SparseFunctional*> loads;
    for (const auto& interface : solver_.interfaces_)
        for (const auto* load : {&interface.mean_a, &interface.mean_b, &interface.load_zone})
            loads.push_back(load);
    for (const auto& mean : solver_.part_means_)
        loads.push_back(&mean);
    for (const auto& film : solver_.films_)
        loads.push_back(&film.integral);
    for (const auto& load : solver_.body_loads_)
        loads.push_back(&load);
    const auto products = evaluate(loads, solution);
    for (const auto* stage : stages)
        add_load(products, factor, *stage);
}

void HeatAdjoint::add_load(const std::vector<double>& products, double factor, const StageRecord& stage)
{
    const auto& interfaces = solver_.interfaces_;
    const double* of_part = products.data() + 3 * interfaces.size();
    const double* of_film = of_part + solver_.part_means_.size();
    const double* of_body = of_film + solver_.films_.size();
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
        const auto& law = (*solver_.laws_)[i];
        const auto& interface = interfaces[i];
        const double through_film = (law.film_a * products[3 * i] + law.film_b * products[3 * i + 1]) / interface.sum;
        causes_.oil[i] +=
            factor * law.oil * interface.area * (stage.oil_temperature[i] - solver_.reference_) * through_film;
        if (law.source < 0)
            continue;
        const auto& source = problem_.sources[static_cast<std::size_t>(law.source)];
        double received = stage.source_heat[static_cast<std::size_t>(law.source)] *
                          (law.heat_part >= 0 ? of_part[law.heat_part] : through_film);
        if (law.load_zone)
            received +=
                source.share * solver_.segment_->zoned_heat[static_cast<std::size_t>(law.source)] * products[3 * i + 2];
        causes_.friction[i] += factor * interface.heat_weight_area * received;
    }
    for (std::size_t i = 0; i < solver_.films_.size(); ++i) {
        const auto& condition = *solver_.films_[i].condition;
        double density = 0;
        if (condition.kind == SurfaceCondition::Kind::flux)
            density = condition.flux(stage.time);
        else if (solver_.films_[i].area > 0)
            density =
                (HeatSolver::depends_on_temperature(condition) ? mean_coefficient(i, stage) : condition.coefficient) *
                (surroundings(i, stage) - solver_.reference_);
        causes_.surfaces[solver_.films_[i].index] += factor * density * of_film[i];
    }
    for (std::size_t k = 0; k < causes_.body_heat.size(); ++k)
        causes_.body_heat[k] += factor * stage.body_heat[k] * of_body[k];
}

void HeatAdjoint::add_start(Vec weights)
{
    std::vector<double> sums(problem_.surfaces.size() + 1, 0.0);
    const double *weight = nullptr, *temperature = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(weights, &weight));
    DEADPOINT_PETSC(VecGetArrayRead(solver_.start_, &temperature));
    for (PetscInt i = 0; i < solver_.space_.last - solver_.space_.first; ++i) {
        const auto found = std::ranges::lower_bound(solver_.prescribed_, solver_.space_.first + i);
        const bool given = found != solver_.prescribed_.end() && *found == solver_.space_.first + i;
        const auto* condition = given ? solver_.prescribed_at_[found - solver_.prescribed_.begin()].second : nullptr;
        sums[given ? static_cast<std::size_t>(condition - problem_.surfaces.data()) : problem_.surfaces.size()] +=
            weight[i] * (temperature[i] - solver_.reference_);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(solver_.start_, &temperature));
    DEADPOINT_PETSC(VecRestoreArrayRead(weights, &weight));
    sum_over_ranks(sums);
    causes_.start = sums.back();
    for (std::size_t i = 0; i < problem_.surfaces.size(); ++i)
        causes_.surfaces[i] += sums[i];
}

}  // namespace deadpoint::fem
