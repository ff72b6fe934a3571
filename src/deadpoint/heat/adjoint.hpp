#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

namespace deadpoint::heat {

template <class System>
class HeatRun;  // run.hpp
template <class System>
class HeatSources;  // sources.hpp

/// What the adjoint of the steps reads of a run that is over.
template <class System>
struct FinishedRun {
    HeatSources<System>& sources;
    std::span<const StepRecord> steps;
    const typename System::Vector& start;  ///< temperatures
};

/// Interface that the adjoint of the steps needs besides HeatSystem: matrices with constant
/// convection coefficients, and the shares of prescribed temperatures.
// clang-format off
template <class S>
concept AdjointSystem = HeatSystem<S> && requires(S& s, const S& c, typename S::Vector& v,
                                                  const typename S::Vector& x, const std::vector<double>& numbers) {
    s.begin_adjoint();                        // materials by their constants, no terms of low rank
    s.set_film_coefficients(numbers);         // of films that follow the temperature, per surface condition [W/m2/K]
    c.apply_mass(x, v);                       // M x
    c.apply_stiffness(x, v);                  // K x
    { s.solve_adjoint(1.0, x, v) } -> std::convertible_to<int>;  // (M + factor K) v = x from the guess v
    // per surface condition: sum of (right - left) (prescribed temperature - reference)
    { c.prescribed_shares(x, x, 1.0, 1.0) } -> std::same_as<std::vector<double>>;  // right, left, time, reference
    // per surface condition that of its prescribed unknowns, then that of all others
    { c.start_shares(x, x, 1.0) } -> std::same_as<std::vector<double>>;            // weights, start, reference
};
// clang-format on

/// Runs the discrete adjoint of the time steps backward over the steps of a finished run.
///
/// With t = T - T_reference and the recorded scalars of each step, a step of length dt is linear,
/// d = diagonal dt:
///
///     (M + d K_m) t_m = M t_0 + d (f_0 - K_0 t_0) + d f_m
///     (M + d K_1) t_1 = M (bdf_middle t_m - bdf_now t_0) + d f_1
///
/// K_0, K_m and K_1 differ only in convection coefficients that depend on temperature: each uses
/// the mean coefficient of its surface at that stage. Materials over temperature use their
/// constants, enclosed air its recorded temperature. For weights l_1 on t_1 the transposed step
/// gives the weights on its loads, d y_2 on f_1 and d y_1 on f_m and f_0, and those on t_0:
///
///     (M + d K_1) y_2 = l_1
///     (M + d K_m) y_1 = bdf_middle M y_2
///     l_0 = M y_1 - d K_0 y_1 - bdf_now M y_2
///
/// Prescribed unknowns have no equation: y is 0 there, and the weight of their temperature is the
/// residual of the right side, l_1 - (M + d K_1) y_2 and bdf_middle M y_2 - (M + d K_m) y_1.
template <class System>
class HeatAdjoint {
public:
    using Vector = typename System::Vector;

    /// The run cannot continue afterwards.
    HeatAdjoint(HeatRun<System>& run, double reference)
        : HeatAdjoint(run.system(), {run.sources(), run.steps(), run.start()}, reference)
    {}
    HeatAdjoint(System& system, FinishedRun<System> run, double reference)
        : run_(run), system_(system), reference_(reference), weights_(system_.make_vector()),
          solution_(system_.make_vector()), middle_weights_(system_.make_vector()),
          middle_solution_(system_.make_vector()), change_(system_.make_vector()), mass_product_(system_.make_vector()),
          stiffness_product_(system_.make_vector())
    {
        system_.begin_adjoint();
    }

    /// Weights of a functional, to be set before causes():  value = sum of weight (T -
    /// T_reference). Afterwards those on the temperatures before the first step.
    [[nodiscard]] Vector& weights() { return weights_; }
    /// @param row  of the run's history: the time of the functional
    HeatCauses causes(std::size_t row)
    {
        const auto& problem = run_.sources.problem();
        causes_ = {};
        causes_.friction.assign(system_.geometry().layout.interfaces, 0.0);
        causes_.oil = causes_.friction;
        causes_.surfaces.assign(problem.surfaces.size(), 0.0);
        causes_.body_heat.assign(problem.body_heat.size(), 0.0);
        change_over_ = 0;
        film_coefficients_.clear();
        system_.combine({}, solution_);
        system_.combine({}, middle_solution_);
        entered_ = nullptr;
        for (const auto& step : run_.steps | std::views::reverse)
            if (step.row <= row) {
                enter(step.segment);
                step_back(step);
            }
        const auto start = system_.start_shares(weights_, run_.start, reference_);
        causes_.start = start.back();
        for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
            causes_.surfaces[i] += start[i];
        return causes_;
    }
    /// Sets laws and convection coefficients as at the end of a step.
    void look_at(const StepRecord& step)
    {
        entered_ = nullptr;
        enter(step.segment);
        run_.sources.set_step(times_of(step));
        use_films(step.end);
    }
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    void enter(std::size_t segment)
    {
        const auto& wanted = run_.sources.problem().segments[segment];
        if (entered_ == &wanted)
            return;
        entered_ = &wanted;
        run_.sources.enter(wanted);
        film_coefficients_.clear();
    }

    // Guesses: with y(s) for slowly fading weights, s the time before the step's end, y_2 stands for s = d and y_1 for
    // s = 2 d but for the factor bdf_middle, to second order. change_ is y_1 / bdf_middle - y_2.
    void step_back(const StepRecord& step)
    {
        const double factor = diagonal * step.duration;
        run_.sources.set_step(times_of(step));
        solve_stage(factor, step.end, weights_, solution_);
        add_prescribed(weights_, step.end.time);
        add_loads(solution_, factor, {&step.end});

        system_.apply_mass(solution_, mass_product_);
        system_.combine({{bdf_middle, &mass_product_}}, middle_weights_);
        system_.combine(
            {{bdf_middle, &solution_}, {change_over_ > 0 ? bdf_middle * step.duration / change_over_ : 0, &change_}},
            middle_solution_);
        solve_stage(factor, step.middle, middle_weights_, middle_solution_);
        add_prescribed(middle_weights_, step.middle.time);
        add_loads(middle_solution_, factor, {&step.middle, &step.start});

        use_films(step.start);
        system_.apply_stiffness(middle_solution_, stiffness_product_);
        system_.apply_mass(middle_solution_, mass_product_);
        system_.combine(
            {{1, &mass_product_}, {-factor, &stiffness_product_}, {-bdf_now / bdf_middle, &middle_weights_}}, weights_);

        system_.combine({{1 / bdf_middle, &middle_solution_}, {-1, &solution_}}, change_);
        change_over_ = step.duration;
        system_.add(1 / diagonal, change_, solution_);
    }

    // Leaves (M + factor K) of the solution, in stiffness_product_, where there are prescribed unknowns to need it.
    void solve_stage(double factor, const StageRecord& stage, const Vector& right, Vector& solution)
    {
        use_films(stage);
        system_.copy(right, mass_product_);
        system_.clear_prescribed(mass_product_);
        system_.clear_prescribed(solution);
        iterations_ += system_.solve_adjoint(factor, mass_product_, solution);
        if (!system_.some_prescribed())
            return;
        system_.apply_stiffness(solution, mass_product_);
        system_.apply_mass(solution, stiffness_product_);
        system_.add(factor, mass_product_, stiffness_product_);
    }

    void add_prescribed(const Vector& right, double time)
    {
        if (!system_.some_prescribed())
            return;
        const auto shares = system_.prescribed_shares(right, stiffness_product_, time, reference_);
        for (std::size_t i = 0; i < shares.size(); ++i)
            causes_.surfaces[i] += shares[i];
    }

    [[nodiscard]] bool radiates_inside(std::size_t surface) const
    {
        const auto& condition = run_.sources.problem().surfaces[surface];
        return condition.enclosure >= 0 && condition.emissivity > 0;
    }

    // Temperature that a surface faces. If it radiates to other surfaces and also gives heat to
    // enclosed air, this is the temperature with which its coefficient gives its total heat loss.
    [[nodiscard]] double surroundings(std::size_t surface, const StageRecord& stage) const
    {
        if (radiates_inside(surface))
            return stage.film_mean[surface] -
                   stage.variable_to_air[surface] / (mean_coefficient(surface, stage) * area(surface));
        return run_.sources.films.surroundings(surface, stage.time, air_of(stage));
    }
    [[nodiscard]] static std::vector<double> air_of(const StageRecord& stage)
    {
        std::vector<double> result;
        for (const auto& air : stage.air)
            result.push_back(air.temperature);
        return result;
    }
    [[nodiscard]] double area(std::size_t surface) const { return system_.geometry().surface_area[surface]; }

    // The coefficient with which a surface gives off its recorded heat of that stage, if it is near
    // the law's.
    [[nodiscard]] double mean_coefficient(std::size_t surface, const StageRecord& stage) const
    {
        const auto& condition = run_.sources.problem().surfaces[surface];
        const auto& films = run_.sources.films;
        const double mean = stage.film_mean[surface];
        if (radiates_inside(surface)) {
            const double inside = stage.air[static_cast<std::size_t>(condition.enclosure)].temperature;
            return film_slope(films.law(surface, inside)(mean), condition.emissivity, mean, inside);
        }
        const double air = surroundings(surface, stage), rise = mean - air;
        const double squares = mean * mean + air * air;
        const double by_law =
            films.law(surface, air)(mean).value + condition.emissivity * stefan_boltzmann * squares * (mean + air);
        const double by_heat = stage.variable_to_air[surface] / (area(surface) * rise);
        return std::isfinite(by_heat) && by_heat > 0.5 * by_law && by_heat < 2 * by_law ? by_heat : by_law;
    }

    void use_films(const StageRecord& stage)
    {
        if (!run_.sources.films.some_follow())
            return;
        const auto& surfaces = run_.sources.problem().surfaces;
        std::vector<double> coefficients(surfaces.size(), 0.0);
        for (std::size_t i = 0; i < surfaces.size(); ++i)
            if (follows_temperature(surfaces[i]) && area(i) > 0)
                coefficients[i] = mean_coefficient(i, stage);
        if (coefficients == film_coefficients_)
            return;
        film_coefficients_ = std::move(coefficients);
        system_.set_film_coefficients(film_coefficients_);
    }

    void add_loads(const Vector& solution, double factor, const std::vector<const StageRecord*>& stages)
    {
        std::vector<std::size_t> all(system_.geometry().layout.probe(0));
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k] = k;
        const auto products = system_.evaluate(all, solution);
        for (const auto* stage : stages) {
            add_joints(products, factor, *stage);
            add_surfaces(products, factor, *stage);
            for (std::size_t k = 0; k < causes_.body_heat.size(); ++k)
                causes_.body_heat[k] += factor * stage->body_heat[k] * products[system_.geometry().layout.body(k)];
        }
    }

    void add_joints(const std::vector<double>& products, double factor, const StageRecord& stage)
    {
        const auto& joints = run_.sources.joints;
        const auto& layout = system_.geometry().layout;
        for (std::size_t i = 0; i < layout.interfaces; ++i) {
            const auto& law = joints.laws()[i];
            const auto through_film = [&](std::size_t a, std::size_t b) {
                return joints.side_share(i, false) * products[a] + joints.side_share(i, true) * products[b];
            };
            const double by_film = through_film(layout.mean(i, false), layout.mean(i, true));
            causes_.oil[i] += factor * law.oil * joints.area(i) * (stage.oil_temperature[i] - reference_) * by_film;
            if (law.source < 0)
                continue;
            const auto r = static_cast<std::size_t>(law.source);
            const bool in_volume = law.heat_part >= 0;
            double received = stage.source_heat[r] *
                              (in_volume ? products[layout.part(static_cast<std::size_t>(law.heat_part))] : by_film);
            if (law.load_zone)
                received += run_.sources.problem().sources[r].share * run_.sources.segment().zoned_heat[r] *
                            (in_volume ? products[layout.zone(i, false)]
                                       : through_film(layout.zone(i, false), layout.zone(i, true)));
            causes_.friction[i] += factor * joints.heat_share(i) * received;
        }
    }

    void add_surfaces(const std::vector<double>& products, double factor, const StageRecord& stage)
    {
        const auto& surfaces = run_.sources.problem().surfaces;
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const auto& condition = surfaces[i];
            double density = 0;
            if (condition.kind == SurfaceCondition::Kind::flux)
                density = run_.sources.films.flux(i, stage.time);
            else if (condition.kind == SurfaceCondition::Kind::film && area(i) > 0)
                density = (follows_temperature(condition) ? mean_coefficient(i, stage) : condition.coefficient) *
                          (surroundings(i, stage) - reference_);
            causes_.surfaces[i] += factor * density * products[system_.geometry().layout.surface(i)];
        }
    }

    FinishedRun<System> run_;
    System& system_;
    double reference_;
    HeatCauses causes_;
    const HeatSegment* entered_ = nullptr;
    std::vector<double> film_coefficients_;  ///< as set last, per surface condition
    Vector weights_, solution_, middle_weights_, middle_solution_, change_, mass_product_, stiffness_product_;
    double change_over_ = 0;  ///< length of the step that change_ belongs to; 0: none [s]
    int iterations_ = 0;
};

}  // namespace deadpoint::heat
