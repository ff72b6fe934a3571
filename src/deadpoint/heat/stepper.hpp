#pragma once

#include "deadpoint/heat/stage_solver.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace deadpoint::heat {

/// The field at one time, with its slope and stored heat.
template <class Vector>
struct Level {
    Vector temperature;  ///< [K]
    Vector slope;        ///< [K/s]
    Vector stored;       ///< M h(T) [J]
    Rate<Vector> rate;
};

/// Steps of TR-BDF2 (second order, L-stable) with an error estimate of third order (Hosea and Shampine, Applied
/// Numerical Mathematics 20, 1996).
template <class System>
class Stepper {
public:
    using Vector = typename System::Vector;
    struct Outcome {
        double error = 0;            ///< largest error of the watched functionals, sumps and enclosed air [K]
        double from_prescribed = 0;  ///< heat that entered through prescribed temperatures [J]
    };

    /// @param watched  functionals whose error counts
    Stepper(System& system, HeatSources<System>& sources, StageSolver<System>& stages, std::vector<std::size_t> watched)
        : system_(system), sources_(sources), stages_(stages), before_(level()), now_(level()), middle_(level()),
          next_(level()), error_(system.make_vector()), work_(system.make_vector()), watched_(std::move(watched))
    {}

    [[nodiscard]] Level<Vector>& now() { return now_; }
    [[nodiscard]] const Level<Vector>& now() const { return now_; }
    [[nodiscard]] const Level<Vector>& middle() const { return middle_; }
    [[nodiscard]] const Level<Vector>& next() const { return next_; }
    [[nodiscard]] Level<Vector>& before() { return before_; }
    /// True if now().slope is known; false at the start of a segment.
    [[nodiscard]] bool slope_known() const { return slope_known_; }
    /// Length of the last step, between before() and now(); 0 if the slope of before() is not known
    /// [s].
    [[nodiscard]] double previous_step() const { return previous_step_; }
    void set_past(bool slope_known, double previous_step)
    {
        slope_known_ = slope_known;
        previous_step_ = previous_step;
        system_.store(now_.temperature, now_.stored);
    }

    /// Starts a segment from the present temperatures.
    void begin_segment(const HeatSegment& segment, double time)
    {
        sources_.enter(segment);
        if (time == 0)
            system_.impose(time, now_.temperature);
        now_.rate = sources_.equilibrate_oil(time, now_.temperature);
        system_.conduct(now_.temperature, work_);
        system_.add(-1, work_, now_.rate.watts);
        system_.store(now_.temperature, now_.stored);
        stages_.begin_step(now_.rate.balance);
        slope_known_ = false;
        previous_step_ = 0;
    }

    /// For a start where slopes of temperatures jump: they are not known.
    void forget_slope()
    {
        slope_known_ = false;
        previous_step_ = 0;
    }
    /// Largest change of a watched temperature or of enclosed air by heat that a step of length dt does not see [K].
    double change_by(const UnseenCourses& unseen, double time, double dt)
    {
        if (!unseen.some_heat())
            return 0;
        stages_.begin_step(now_.rate.balance);
        stages_.set_source_slopes(now_.rate.balance.source_slope);
        stages_.build(time, diagonal * dt, now_.temperature);
        system_.combine({}, work_);
        const auto in_air = sources_.add_unseen(unseen, now_.rate.balance, work_);
        system_.clear_prescribed(work_);
        return filtered(in_air);
    }
    /// Largest change of a prescribed temperature in the last step [K].
    double prescribed_change()
    {
        if (!system_.some_prescribed())
            return 0;
        system_.combine({{1, &next_.temperature}, {-1, &now_.temperature}}, work_);
        system_.copy(work_, error_);
        system_.clear_prescribed(error_);
        system_.add(-1, error_, work_);
        return system_.largest(work_);
    }

    /// Computes next() from now(), a step of length dt later.
    Outcome step(double time, double dt)
    {
        const double factor = diagonal * dt;
        stages_.begin_step(now_.rate.balance);
        sources_.set_step({time, time + gamma_stage * dt, time + dt});
        first_stage(time, dt, factor);
        second_stage(time, dt, factor);
        Outcome result;
        result.from_prescribed = prescribed_heat(dt);
        if (sources_.problem().fixed_step > 0)
            return result;
        result.error = std::max(estimate_error(dt), sources_.oil.step_error(dt, slope_known_, now_.rate.balance,
                                                                            middle_.rate.balance, next_.rate.balance));
        result.error = std::max(result.error, largest_watched());
        return result;
    }

    /// Sets the slope of now() to the secant of the step if it is not known.
    void complete_first_slope(double dt)
    {
        if (!slope_known_)
            system_.combine({{1 / dt, &next_.temperature}, {-1 / dt, &now_.temperature}}, now_.slope);
    }
    /// Temperatures within the step, by the cubic through its ends; s is 0 at its start and 1 at its end.
    void interpolate(double dt, double s, Vector& result) const
    {
        hermite(now_.temperature, now_.slope, next_.temperature, next_.slope, dt, s, result);
    }
    /// Makes the step's end the present; returns the heat stored in enclosed air [J].
    double accept(double dt)
    {
        const double in_air = sources_.air.accept(dt);
        std::swap(before_, now_);
        std::swap(now_, next_);
        previous_step_ = slope_known_ ? dt : 0;
        slope_known_ = true;
        sources_.oil.accept(now_.rate.balance);
        return in_air;
    }

private:
    [[nodiscard]] Level<Vector> level() const
    {
        return {system_.make_vector(), system_.make_vector(), system_.make_vector(), {{}, system_.make_vector()}};
    }

    // The cubic through values and slopes at both ends of an interval of length h, at the place s.
    void hermite(const Vector& start, const Vector& start_slope, const Vector& end, const Vector& end_slope_, double h,
                 double s, Vector& result) const
    {
        system_.combine({{(1 + 2 * s) * (1 - s) * (1 - s), &start},
                         {h * s * (1 - s) * (1 - s), &start_slope},
                         {s * s * (3 - 2 * s), &end},
                         {h * s * s * (s - 1), &end_slope_}},
                        result);
    }

    void first_stage(double time, double dt, double factor)
    {
        const double to_middle = gamma_stage * dt;
        if (previous_step_ > 0)
            hermite(before_.temperature, before_.slope, now_.temperature, now_.slope, previous_step_,
                    1 + to_middle / previous_step_, middle_.temperature);
        else if (slope_known_)
            system_.combine({{1, &now_.temperature}, {to_middle, &now_.slope}}, middle_.temperature);
        else
            system_.copy(now_.temperature, middle_.temperature);
        system_.combine({{1, &now_.stored}, {factor, &now_.rate.watts}}, stages_.known);
        sources_.air.begin_first_stage(dt, slope_known_, now_.rate.balance);
        middle_.rate =
            stages_.solve(time + to_middle, factor, sources_.oil.known_in_first_stage(factor, now_.rate.balance),
                          middle_.temperature, middle_.stored);
    }

    // Its guess uses the result of the first stage; the slope at the end follows from the formula
    // of the stage.
    void second_stage(double time, double dt, double factor)
    {
        system_.combine({{bdf_middle, &middle_.stored}, {-bdf_now, &now_.stored}}, stages_.known);
        const Scaled<Vector> from_middle{1 / factor, &middle_.temperature}, from_now{-1 / factor, &now_.temperature};
        if (slope_known_) {
            system_.combine({from_middle, from_now, {-1, &now_.slope}}, middle_.slope);
            hermite(now_.temperature, now_.slope, middle_.temperature, middle_.slope, gamma_stage * dt, 1 / gamma_stage,
                    next_.temperature);
        } else {
            system_.combine({from_middle, from_now}, middle_.slope);
            system_.combine({{1 / gamma_stage, &middle_.temperature}, {1 - 1 / gamma_stage, &now_.temperature}},
                            next_.temperature);
        }
        sources_.air.begin_second_stage();
        next_.rate = stages_.solve(time + dt, factor, sources_.oil.known_in_second_stage(middle_.rate.balance),
                                   next_.temperature, next_.stored);
        system_.combine({{1 / factor, &next_.temperature},
                         {-bdf_middle / factor, &middle_.temperature},
                         {bdf_now / factor, &now_.temperature}},
                        next_.slope);
    }

    // Writes the error of the step into error_ and returns the largest error of the enclosures [K].
    // The error is the difference to the companion method, with the slopes of both stages from
    // their formulas. If the first slope is not known, as at the start of a segment, the difference
    // of the rates is filtered with the step's matrix, which removes stiff transients; in every
    // later step the second stage damps them.
    double estimate_error(double dt)
    {
        const auto by_weights = [&](const Vector& start, const Vector& middle, const Vector& end, Vector& result) {
            system_.combine(
                {{dt * error_weights[0], &start}, {dt * error_weights[1], &middle}, {dt * error_weights[2], &end}},
                result);
        };
        if (slope_known_) {
            by_weights(now_.slope, middle_.slope, next_.slope, error_);
            return sources_.air.error(dt);
        }
        by_weights(now_.rate.watts, middle_.rate.watts, next_.rate.watts, work_);
        system_.clear_prescribed(work_);
        return filtered(sources_.air.first_error(dt, {&now_.rate.balance, &middle_.rate.balance, &next_.rate.balance}));
    }

    // Solves for the change by heat in work_ and in enclosed air with the matrix that was built last: error_, and the
    // largest change of anything watched [K].
    double filtered(const std::vector<double>& in_air)
    {
        sources_.air.eliminate(in_air, work_);
        // tight enough that any number of ranks takes the same steps
        const double sharp = 1e-4 * step_tolerance(sources_.problem().time_tolerance);
        stages_.solve_linear(work_, error_, {1e-4, sharp}, "the error of a time step");
        double largest = largest_watched();
        for (const double e : sources_.air.solution(in_air, error_))
            largest = std::max(largest, std::abs(e));
        return largest;
    }
    // Largest watched functional of error_ [K].
    [[nodiscard]] double largest_watched() const
    {
        double largest = 0;
        for (const double e : system_.evaluate(watched_, error_))
            largest = std::max(largest, std::abs(e));
        return largest;
    }

    // Heat that entered through unknowns of prescribed temperature: their stored heat less their
    // other gains [J].
    double prescribed_heat(double dt)
    {
        if (!system_.some_prescribed())
            return 0;
        system_.combine({{1, &next_.stored},
                         {-1, &now_.stored},
                         {-dt * outer_weight, &now_.rate.watts},
                         {-dt * outer_weight, &middle_.rate.watts},
                         {-dt * diagonal, &next_.rate.watts}},
                        work_);
        return system_.total_prescribed(work_);
    }

    System& system_;
    HeatSources<System>& sources_;
    StageSolver<System>& stages_;
    Level<Vector> before_, now_, middle_, next_;
    Vector error_, work_;
    std::vector<std::size_t> watched_;
    bool slope_known_ = false;
    double previous_step_ = 0;
};

}  // namespace deadpoint::heat
