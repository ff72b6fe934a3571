#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/enclosed_air.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/heat/oil.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::heat {

/// The heat balance at one time: its scalars, and the watts by unknown.
template <class Vector>
struct Rate {
    HeatBalance balance;
    Vector watts;
    std::vector<double> pending{};  ///< watts by functional that are not yet in `watts`; empty: none
};

/// The right-hand side of  M dT/dt = sources(t, T) - K T: joints, oil, films, enclosed air and other heat.
template <class System>
class HeatSources {
public:
    using Vector = typename System::Vector;

    HeatSources(System& system, const HeatProblem& problem)
        : joints(problem, system.geometry()), oil(problem), films(problem, system.geometry()),
          air(problem.enclosures, system), system_(system), problem_(problem)
    {}

    JointBalance joints;
    OilMarch oil;
    FilmBalance films;
    EnclosedAir<System> air;

    [[nodiscard]] const HeatProblem& problem() const { return problem_; }
    [[nodiscard]] const HeatSegment& segment() const { return *segment_; }
    [[nodiscard]] std::size_t segment_index() const
    {
        return static_cast<std::size_t>(segment_ - problem_.segments.data());
    }

    /// Sets the laws of a segment.
    void enter(const HeatSegment& segment)
    {
        segment_ = &segment;
        joints.enter(segment);
        oil.enter(segment);
        films.enter(segment);
        needed_ = joints.needed();
        needed_.insert(needed_.end(), films.needed().begin(), films.needed().end());
        std::vector<Loads> loads;
        for (std::size_t r = 0; r < problem_.sources.size(); ++r)
            loads.push_back(joints.source_load(r));
        system_.set_laws(joints.laws(), loads);
    }

    /// Sets the times of a step, for the values of courses within it.
    void set_step(const StepTimes& step)
    {
        step_ = step;
        films.set_step(step);
        oil.set_step(step);
    }

    /// The sources at a time and a temperature, with the oil and air that were set last.
    Rate<Vector> at(double time, const Vector& temperature) const
    {
        auto result = balance_at(time, temperature);
        complete(result);
        return result;
    }
    /// The same with watts by unknown that still miss what complete() adds. Where only the balance is read, that is
    /// left out.
    Rate<Vector> balance_at(double time, const Vector& temperature) const
    {
        const auto values = functionals(temperature);
        std::vector<double> watts(system_.geometry().layout.count(), 0.0);
        Rate<Vector> result{{}, system_.make_vector()};
        auto& balance = result.balance;
        balance.time = time;
        balance.air.resize(air.count());
        const auto inside = air.temperatures();
        films.evaluate(values, time, inside, balance, watts);
        joints.evaluate(values, balance, watts);
        add_bodies(time, balance, watts);
        result.pending = std::move(watts);
        if (films.some_follow()) {
            complete(result);
            films.book(system_.add_films(films.following(time, inside), temperature, result.watts), balance);
        }
        add_enclosures(time, inside, balance);
        return result;
    }
    void complete(Rate<Vector>& rate) const
    {
        if (rate.pending.empty())
            return;
        system_.add_loads(rate.pending, rate.watts);
        rate.pending.clear();
    }

    /// Adds corrections of the sources' heat [W] to a balance alone.
    void correct(HeatBalance& balance, const std::vector<double>& corrections) const
    {
        std::vector<double> unread(system_.geometry().layout.count(), 0.0);
        joints.correct(balance, corrections, unread);
    }
    /// Adds corrections of the sources' heat [W].
    void correct(Rate<Vector>& rate, const std::vector<double>& corrections) const
    {
        std::vector<double> watts(system_.geometry().layout.count(), 0.0);
        joints.correct(rate.balance, corrections, watts);
        system_.add_loads(watts, rate.watts);
    }

    /// Equilibrates the oil with the present field at the start of a segment; returns the sources.
    /// @throws ConvergenceError if oil and joints do not agree
    Rate<Vector> equilibrate_oil(double time, const Vector& temperature)
    {
        auto rate = at(time, temperature);
        if (oil.empty())
            return rate;
        for (int i = 0; i < most_oil_steps; ++i) {
            const auto reaches = oil.march(joints, rate.balance, time, 0, oil.sumps());
            const double change = oil_change(reaches);
            joints.set_oil(reaches);
            if (change < oil_settled)
                return rate;
            auto flows = std::move(rate.balance.oil);
            rate = at(time, temperature);
            rate.balance.oil = std::move(flows);
        }
        throw ConvergenceError("oil and joints did not agree at t = " + std::to_string(time) +
                               " s; look at the flow and the coefficients of the oil circuits");
    }

    /// Largest difference to the temperatures at which the oil now reaches the interfaces [K];
    /// infinite if one of them is no number.
    [[nodiscard]] double oil_change(const std::vector<double>& reaches) const
    {
        double change = 0;
        for (std::size_t i = 0; i < reaches.size(); ++i) {
            const double here = std::abs(reaches[i] - joints.oil_temperature()[i]);
            change = std::max(change, std::isnan(here) ? std::numeric_limits<double>::infinity() : here);
        }
        return change;
    }

    /// Builds the slopes of the surfaces' heat by the temperature of the air, at the temperature of
    /// a field, for stages of a given length.
    void build_air_loads(double time, double factor, const Vector& temperature)
    {
        for (std::size_t k = 0; k < air.count(); ++k) {
            Vector& load = air.load(k);
            system_.combine({}, load);
            std::vector<double> watts(system_.geometry().layout.count(), 0.0);
            for (std::size_t i = 0; i < problem_.surfaces.size(); ++i)
                if (const auto& c = problem_.surfaces[i]; c.enclosure == static_cast<int>(k) &&
                                                          c.kind == SurfaceCondition::Kind::film &&
                                                          !follows_temperature(c))
                    watts[system_.geometry().layout.surface(i)] = c.coefficient;
            system_.add_loads(watts, load);
            system_.add_film_slopes(films.following(time, air.temperatures(), static_cast<int>(k)), temperature, load);
            air.complete_load(k, factor);
        }
    }

    /// Adds heat that a step does not see to a load; returns that of the enclosed air [J].
    /// @param balance  at the step's start
    std::vector<double> add_unseen(const UnseenCourses& unseen, const HeatBalance& balance, Vector& load) const
    {
        const auto& layout = system_.geometry().layout;
        std::vector<double> watts(layout.count(), 0.0), in_air(air.count(), 0.0);
        for (std::size_t k = 0; k < unseen.bodies.size(); ++k)
            watts[layout.body(k)] += unseen.bodies[k];
        for (std::size_t i = 0; i < problem_.surfaces.size(); ++i)
            if (system_.geometry().surface_area[i] > 0)
                watts[layout.surface(i)] += unseen_flux(i, unseen, balance);
        for (std::size_t k = 0; k < in_air.size(); ++k)
            in_air[k] =
                problem_.enclosures[k].exchange * unseen.ambient + (k < unseen.powers.size() ? unseen.powers[k] : 0);
        system_.add_loads(watts, load);
        return in_air;
    }

private:
    static constexpr double oil_settled = 1e-9;  // [K]
    static constexpr int most_oil_steps = 100;

    [[nodiscard]] std::vector<double> functionals(const Vector& temperature) const
    {
        const auto found = system_.evaluate(needed_, temperature);
        std::vector<double> values(system_.geometry().layout.count(), 0.0);
        for (std::size_t k = 0; k < needed_.size(); ++k)
            values[needed_[k]] = found[k];
        return values;
    }
    // [J/m2]
    [[nodiscard]] double unseen_flux(std::size_t surface, const UnseenCourses& unseen, const HeatBalance& balance) const
    {
        const auto& condition = problem_.surfaces[surface];
        if (condition.kind == SurfaceCondition::Kind::flux)
            return unseen.surfaces[surface];
        if (condition.kind != SurfaceCondition::Kind::film || condition.enclosure >= 0)
            return 0;
        const double mean = balance.film_mean[surface];
        const double faced = films.surroundings(surface, balance.time, {});
        return film_slope(films.law(surface, faced)(mean), condition.emissivity, mean, faced) *
               (condition.ambient ? unseen.surfaces[surface] : unseen.ambient);
    }
    void add_bodies(double time, HeatBalance& balance, std::vector<double>& watts) const
    {
        balance.body_heat.assign(problem_.body_heat.size(), 0.0);
        for (std::size_t k = 0; k < balance.body_heat.size(); ++k)
            if (const auto& power = segment_->body_heat[k]) {
                balance.body_heat[k] = step_.value(power, time);
                watts[system_.geometry().layout.body(k)] += balance.body_heat[k];
                balance.generated += balance.body_heat[k];
            }
    }
    void add_enclosures(double time, const std::vector<double>& inside, HeatBalance& balance) const
    {
        const double ambient = step_.value(segment_->ambient, time);
        for (std::size_t k = 0; k < inside.size(); ++k) {
            auto& flow = balance.air[k];
            flow.temperature = inside[k];
            flow.to_room = problem_.enclosures[k].exchange * (inside[k] - ambient);
            if (!segment_->enclosure_power.empty() && segment_->enclosure_power[k])
                flow.power = step_.value(segment_->enclosure_power[k], time);
            balance.generated += flow.power;
            balance.to_air += flow.to_room;
        }
    }

    System& system_;
    const HeatProblem& problem_;
    const HeatSegment* segment_ = nullptr;
    StepTimes step_;
    std::vector<std::size_t> needed_;
};

}  // namespace deadpoint::heat
