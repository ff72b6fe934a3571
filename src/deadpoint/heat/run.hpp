#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/history.hpp"
#include "deadpoint/heat/run_state.hpp"
#include "deadpoint/heat/stepper.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint {
class Observer;
}

namespace deadpoint::heat {

/// Callbacks of a run. Empty functions are not called.
template <class Vector>
struct RunHooks {
    std::function<void(double time)> on_step;                  ///< after each accepted step
    std::function<void(double time, const Vector&)> on_field;  ///< for each of HeatProblem::field_times, in order
    std::function<void(bool interrupted)> on_between_steps;    ///< when state() and vectors() are valid
    /// Once, before the first step whose length the end of the operation changes, or at that end: up to here a run with
    /// a longer operation takes the same steps. state() and vectors() are valid.
    std::function<void()> on_end_in_sight;
};

/// Tells an observer of a step; warns if steps stay so short that a run would not end in
/// a reasonable time.
/// @param done      steps so far
/// @param duration  of the last one [s]
/// @return whether the run is to stop
bool report_step(const HeatProblem& problem, std::size_t done, double time, double duration, Observer& observer);

/// Length of the first step that is tried [s].
inline double first_step(const HeatProblem& problem)
{
    return problem.fixed_step > 0 ? problem.fixed_step : problem.initial_step;
}

/// A heat problem over its segments, on a system that outlives it.
template <class System>
class HeatRun {
public:
    using Vector = typename System::Vector;

    /// @param functionals, contributions  of HistoryRecorder
    HeatRun(System& system, const HeatProblem& problem, std::size_t functionals = 0, std::size_t contributions = 0)
        : system_(system), problem_(problem), sources_(system, problem), stages_(system, sources_),
          recorder_(problem, system.geometry().layout, functionals, contributions),
          stepper_(system, sources_, stages_, recorder_.watched()), ends_(problem), start_(system.make_vector()),
          work_(system.make_vector())
    {
        const std::size_t parts = system.geometry().layout.parts;
        recorder_.history().part_lowest.assign(parts, std::numeric_limits<double>::infinity());
        recorder_.history().part_highest.assign(parts, -std::numeric_limits<double>::infinity());
    }
    HeatRun(const HeatRun&) = delete;

    /// The temperatures, to be set before begin().
    [[nodiscard]] Vector& temperature() { return stepper_.now().temperature; }
    [[nodiscard]] const Vector& temperature() const { return stepper_.now().temperature; }
    void set_media(std::vector<double> sumps, const std::vector<double>& enclosures)
    {
        sources_.oil.set_sumps(std::move(sumps));
        sources_.air.start_from(enclosures);
    }
    [[nodiscard]] const std::vector<double>& sumps() const { return sources_.oil.sumps(); }
    [[nodiscard]] std::vector<double> enclosures() const { return sources_.air.at_start(); }

    /// Starts the first segment.
    void begin()
    {
        start_segment();
        system_.copy(temperature(), start_);
    }

    /// Continues to the end of the operation, or until the observer is cancelled.
    /// @throws ConvergenceError, DomainError
    const ThermalHistory& go(const RunHooks<Vector>& hooks, Observer& observer)
    {
        auto& history = recorder_.history();
        while (!history.interrupted) {
            const double end = place_.segment_start + problem_.segments[place_.segment].duration;
            while (!history.interrupted && place_.time < end * (1 - 1e-14)) {
                look_for_end(end, hooks);
                if (try_step(end, hooks))
                    after_step(hooks, observer);
            }
            if (history.interrupted || place_.segment + 1 == problem_.segments.size())
                break;
            ++place_.segment;
            start_segment();
        }
        if (!history.interrupted)
            see_end(hooks);
        history.linear_iterations = stages_.iterations;
        history.linear_solves = stages_.solves;
        return history;
    }

    [[nodiscard]] const ThermalHistory& history() const { return recorder_.history(); }
    [[nodiscard]] const std::vector<StepRecord>& steps() const { return steps_; }
    [[nodiscard]] const HeatProblem& problem() const { return problem_; }
    [[nodiscard]] HeatSources<System>& sources() { return sources_; }
    [[nodiscard]] StageSolver<System>& stages() { return stages_; }
    [[nodiscard]] Stepper<System>& stepper() { return stepper_; }
    [[nodiscard]] System& system() { return system_; }
    /// The temperatures from which the run started.
    [[nodiscard]] const Vector& start() const { return start_; }

    /// State between two steps: the scalars, and the vectors from which a step starts.
    [[nodiscard]] RunState state() const
    {
        return {place_,
                stepper_.slope_known(),
                stepper_.previous_step(),
                stages_.iterations,
                stages_.solves,
                sources_.oil.sumps(),
                sources_.joints.oil_temperature(),
                sources_.air.states(),
                stages_.origin(),
                stepper_.now().rate.balance,
                recorder_.history(),
                steps_};
    }
    [[nodiscard]] std::vector<Vector*> vectors()
    {
        auto& before = stepper_.before();
        auto& now = stepper_.now();
        return {&before.temperature, &now.temperature, &before.slope, &now.slope, &now.rate.watts};
    }
    /// Continues from a state that fits (see misfit()). Call it after begin(), when vectors() hold
    /// the vectors of that state. The caller must build the preconditioner of its origin again.
    void restore(const RunState& state)
    {
        place_ = state.place;
        sources_.enter(problem_.segments[place_.segment]);
        ends_.enter(problem_.segments[place_.segment]);
        if (!problem_.oil.empty())
            sources_.joints.set_oil(state.oil_temperature);
        sources_.oil.set_sumps(state.sumps);
        sources_.air.set_states(state.air);
        stages_.iterations = state.iterations;
        stages_.solves = state.solves;
        stages_.set_origin(state.origin);
        stepper_.now().rate.balance = state.balance;
        stepper_.set_past(state.slope_known, state.previous_step);
        recorder_.history() = state.history;
        steps_ = state.steps;
    }

private:
    // A step passes over points of tables only if there are more.
    static constexpr std::ptrdiff_t fewest_passed = 2;

    // The slope of the fields is not known where a segment starts.
    void start_segment()
    {
        stepper_.begin_segment(problem_.segments[place_.segment], place_.time);
        ends_.enter(problem_.segments[place_.segment]);
        place_.segment_start = place_.time;
        place_.wanted = first_step(problem_);
        start_row();
    }
    // A further row of the same time, from which slopes are not known.
    void start_row()
    {
        place_.segment_row = recorder_.history().time.size();
        record(0);
    }
    // Where prescribed temperatures bend or have jumped, the slopes of temperatures jump within a segment.
    void start_where_bent()
    {
        if (!controlled() || recorder_.history().time.size() == place_.segment_row + 1)
            return;
        if (ends_.bends_prescribed(place_.time))
            stepper_.forget_slope();
        if (!stepper_.slope_known())
            start_row();
    }
    [[nodiscard]] bool controlled() const { return problem_.fixed_step <= 0; }

    void look_for_end(double end, const RunHooks<Vector>& hooks)
    {
        const bool last = place_.segment + 1 == problem_.segments.size();
        const double left = end - place_.time, looked_at = 2 * place_.wanted;
        const bool shortened = fit_step(place_.wanted, left) != place_.wanted;
        if (last && place_.time > place_.segment_start &&
            (shortened || (left < looked_at && !ends_.points(place_.time, place_.time + looked_at).empty())))
            see_end(hooks);
    }
    void see_end(const RunHooks<Vector>& hooks)
    {
        if (!end_seen_ && hooks.on_end_in_sight)
            hooks.on_end_in_sight();
        end_seen_ = true;
    }

    // Where the next step ends at the latest: at the end of the segment, or where its courses bend. A step may pass
    // over points of dense tables, and places where functions are looked at, as long as what it does not see would
    // change no watched temperature by more than half the tolerance.
    double next_stop(double end)
    {
        if (!controlled())
            return end;
        const double time = place_.time;
        auto points = ends_.points(time, std::min(end, time + 2 * place_.wanted));
        const auto inside = std::ranges::upper_bound(points, time + place_.wanted) - points.begin();
        if (!points.empty() && inside <= fewest_passed)
            end = points.front();
        const double to = time + fit_step(place_.wanted, end - time);
        points = ends_.looked_at(time, to);
        if (points.empty())
            return end;
        const auto whole = ends_.unseen(time, to);
        const double change = stepper_.change_by(whole, time, to - time), allowed = problem_.time_tolerance / 2;
        if (std::max(change, whole.prescribed) <= allowed)
            return end;
        const auto is_seen = [&](double point) {
            const auto unseen = ends_.unseen(time, point);
            return unseen.prescribed <= allowed && (change <= allowed || change * unseen.share_of(whole) <= allowed);
        };
        const auto unseen = std::ranges::partition_point(points, is_seen);
        const double stop = unseen == points.begin() ? points.front() : unseen[-1];
        while (place_.wanted / step_ratio >= stop - time)
            place_.wanted /= step_ratio;
        return stop;
    }

    // One step towards the end of the segment; false if it was too long and must be repeated with a
    // shorter one.
    bool try_step(double end, const RunHooks<Vector>& hooks)
    {
        start_where_bent();
        end = next_stop(end);
        const double dt = fit_step(place_.wanted, end - place_.time);
        const auto outcome = stepper_.step(place_.time, dt);
        const double tolerance = step_tolerance(problem_.time_tolerance);
        const bool too_long = controlled() && outcome.error > tolerance;
        const bool jumped = too_long && dt <= TimeCourse::jump && stepper_.prescribed_change() > tolerance;
        if (too_long && !jumped) {
            shorten(dt, outcome.error, tolerance);
            return false;
        }
        stepper_.complete_first_slope(dt);
        hand_on_fields(dt, hooks);
        accept(dt, outcome.from_prescribed);
        place_.time = end - place_.time <= dt * (1 + 1e-12) ? end : place_.time + dt;
        record(dt);
        if (recorder_.history().time.size() == place_.segment_row + 2)
            recorder_.fill_first_slopes(place_.segment_row);
        if (jumped) {
            stepper_.forget_slope();
            place_.wanted = first_step(problem_);
        } else if (controlled()) {
            lengthen(dt, outcome.error, tolerance);
        }
        return true;
    }

    // Steps that an event made shorter tell as well whether twice the wanted length would do.
    void lengthen(double dt, double error, double tolerance)
    {
        constexpr int most = 60;
        if (dt * step_size_factor(error, tolerance, 0, most) >= place_.wanted * step_ratio * (1 - 1e-9))
            place_.wanted *= step_ratio;
        place_.wanted = std::min(place_.wanted, problem_.max_step);
    }

    void shorten(double dt, double error, double tolerance)
    {
        ++recorder_.history().rejected_steps;
        place_.wanted = dt * step_size_factor(error, tolerance, -20, -1);
        if (dt < 1e-6)
            throw ConvergenceError("the time step collapsed below 1 us at t = " + std::to_string(place_.time) +
                                   " s; loosen numerics.time_tolerance or look for a law that jumps");
    }

    // Records a step and makes its end the present.
    void accept(double dt, double from_prescribed)
    {
        const auto& start = stepper_.now().rate.balance;
        const auto& middle = stepper_.middle().rate.balance;
        const auto& end = stepper_.next().rate.balance;
        const double stored = system_.stored_between(temperature(), stepper_.next().temperature);
        recorder_.add_energy(dt, start, middle, end, from_prescribed, stored);
        steps_.push_back({place_.segment, recorder_.history().time.size(), dt, start, middle, end});
        recorder_.history().energy.stored += stepper_.accept(dt);
    }

    void after_step(const RunHooks<Vector>& hooks, Observer& observer)
    {
        if (hooks.on_step)
            hooks.on_step(place_.time);
        const double length = std::max(steps_.back().duration, place_.wanted);
        const bool stop = report_step(problem_, steps_.size(), place_.time, length, observer);
        auto& interrupted = recorder_.history().interrupted;
        interrupted = system_.any(stop);
        if (hooks.on_between_steps)
            hooks.on_between_steps(interrupted);
    }

    void hand_on_fields(double dt, const RunHooks<Vector>& hooks)
    {
        const auto& times = problem_.field_times;
        auto& next = place_.next_field;
        for (; next < times.size() && times[next] <= place_.time + dt * (1 + 1e-12); ++next) {
            const double s = std::clamp((times[next] - place_.time) / dt, 0.0, 1.0);
            stepper_.interpolate(dt, s, work_);
            if (hooks.on_field)
                hooks.on_field(times[next], work_);
        }
    }

    void record(double dt)
    {
        auto& history = recorder_.history();
        const auto& now = stepper_.now();
        system_.widen(now.temperature, history.part_lowest, history.part_highest);
        const auto values = observed(now.temperature, false);
        const auto slopes = stepper_.slope_known() ? observed(now.slope, true) : std::vector<double>();
        recorder_.record(place_.time, values, slopes, now.rate.balance, stepper_.middle().rate.balance, dt);
    }
    [[nodiscard]] std::vector<double> observed(const Vector& vector, bool is_slope) const
    {
        auto values = system_.evaluate(recorder_.watched(), vector);
        const auto further = system_.observe(vector, temperature(), is_slope);
        values.insert(values.end(), further.begin(), further.end());
        return values;
    }

    System& system_;
    const HeatProblem& problem_;
    HeatSources<System> sources_;
    StageSolver<System> stages_;
    HistoryRecorder recorder_;
    Stepper<System> stepper_;
    StepEnds ends_;
    RunPlace place_;
    bool end_seen_ = false;
    std::vector<StepRecord> steps_;  ///< accepted
    Vector start_, work_;
};

}  // namespace deadpoint::heat
