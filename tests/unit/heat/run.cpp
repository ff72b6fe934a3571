/// Requirement: a run goes through its segments step by step, tells what it was asked to tell, can be stopped between
/// any two steps, and goes on from there as if it had not been.
#include "deadpoint/heat/run.hpp"

#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

/// Two lumps with a motor that runs in the first of two segments, and a film to air of 290 K.
HeatProblem motor()
{
    HeatProblem problem;
    problem.body_heat = {{"motor", {0}, -1}};
    problem.surfaces = {lumps::film(20)};
    problem.segments = {lumps::segment(problem, 3000, 290), lumps::segment(problem, 2000, 290)};
    problem.segments[0].body_heat[0] = lumps::steady(100);
    return problem;
}
lumps::Machine two_lumps() { return {{2e4, 5e4}, {{0, 1, 30}}, {}, {{1, 0.5}}, {0, 1}}; }

struct Stopping : Observer {
    explicit Stopping(int after_) : after(after_) {}
    void warn(std::string_view text) override { warnings.emplace_back(text); }
    [[nodiscard]] bool cancelled() const override { return ++asked > after; }
    int after;
    mutable int asked = 0;
    std::vector<std::string> warnings;
};

}  // namespace

TEST_CASE("a run's times: each segment begins at the end of the one before, at the same temperatures")
{
    const auto problem = motor();
    lumps::Run run(two_lumps(), problem, 290);
    const auto& history = run.go();
    CHECK(history.time.front() == 0);
    CHECK(history.time.back() == 5000);
    std::size_t twice = 0;
    for (std::size_t k = 1; k < history.time.size(); ++k) {
        CHECK(history.time[k] >= history.time[k - 1]);
        if (history.time[k] == history.time[k - 1]) {
            ++twice;
            CHECK(history.time[k] == 3000);
            CHECK(history.probes[0].value[k] == history.probes[0].value[k - 1]);
        }
    }
    CHECK(twice == 1);
    CHECK(run.run.steps().size() + 2 == history.time.size());
    CHECK(history.part_lowest == std::vector<double>{290, 290});
    CHECK(history.linear_solves ==
          2 * static_cast<int>(run.run.steps().size() + static_cast<std::size_t>(history.rejected_steps)));
}

TEST_CASE("steps double at most, and begin anew with each segment")
{
    auto problem = motor();
    problem.initial_step = 2;
    problem.max_step = 100;
    lumps::Run run(two_lumps(), problem, 290);
    run.go();
    const auto& steps = run.run.steps();
    double before = 0;
    std::size_t segment = 9;
    for (const auto& step : steps) {
        CHECK(step.duration <= 100);
        if (step.segment != segment)
            CHECK(step.duration <= 2);
        else
            CHECK(step.duration <= 2 * before * (1 + 1e-12));
        before = step.duration;
        segment = step.segment;
        CHECK(step.end.time - step.start.time == near(step.duration, 1e-9));
    }
}

TEST_CASE("a fixed step is kept but for a segment's end, and never refused")
{
    auto problem = motor();
    problem.fixed_step = 400;
    lumps::Run run(two_lumps(), problem, 290);
    const auto& history = run.go();
    CHECK(history.rejected_steps == 0);
    const auto& steps = run.run.steps();
    REQUIRE(steps.size() == 8 + 5);  // 3000 = 6 x 400 + 2 x 300, 2000 = 5 x 400
    CHECK(steps[5].duration == 400);
    CHECK(steps[6].duration == near(300, 1e-12));
    CHECK(steps[7].duration == near(300, 1e-12));
}

TEST_CASE("heat that is switched on within a run makes steps short that were too long")
{
    auto problem = motor();
    problem.initial_step = 1000;
    problem.segments[0].body_heat[0] = [](double t) { return t < 500 ? 0.0 : 5000.0; };
    lumps::Run run(two_lumps(), problem, 290);
    const auto& history = run.go();
    CHECK(history.rejected_steps > 3);
    // The jump is missed by less than a step's quadrature: 2500 s of 5 kW.
    CHECK(history.energy.mismatch() < 1e-12);
    CHECK(history.energy.generated == near(5000 * 2500.0, 1e-4));
}

TEST_CASE("fields at wanted times come in order, once, and lie on the curve of the probes")
{
    auto problem = motor();
    problem.field_times = {0, 1, 777, 3000, 3001, 5000};
    lumps::Run run(two_lumps(), problem, 290);
    std::vector<double> times, values;
    RunHooks<Eigen::VectorXd> hooks;
    hooks.on_field = [&](double time, const Eigen::VectorXd& field) {
        times.push_back(time);
        values.push_back(lumps::temperatures_of(run.machine, field)[0]);
    };
    lumps::Quiet observer;
    run.run.begin();
    const auto& history = run.run.go(hooks, observer);
    CHECK(times == problem.field_times);
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(values[k] == near(interpolate(history.time, history.probes[0], times[k]), 1e-12));
    CHECK(values.front() == near(290, 1e-15));
    CHECK(values.back() == run.temperatures()[0]);
}

TEST_CASE("the end in sight is told once, before the first step that it changes, or at the end")
{
    auto problem = motor();
    const auto told_at = [&] {
        lumps::Run run(two_lumps(), problem, 290);
        std::vector<double> times;
        RunHooks<Eigen::VectorXd> hooks;
        hooks.on_end_in_sight = [&] { times.push_back(run.run.state().place.time); };
        lumps::Quiet observer;
        run.run.begin();
        run.run.go(hooks, observer);
        return times;
    };
    problem.fixed_step = 400;  // 3000 = 6 x 400 + 2 x 300 is no end of the operation; 2000 = 5 x 400 changes no step
    CHECK(told_at() == std::vector<double>{5000});
    problem.segments[1].duration = 1900;  // 4 x 400 is followed by 300
    CHECK(told_at() == std::vector<double>{3000 + 3 * 400});
}

TEST_CASE("each accepted step is told once, with its time")
{
    const auto problem = motor();
    lumps::Run run(two_lumps(), problem, 290);
    std::vector<double> times;
    int between = 0;
    RunHooks<Eigen::VectorXd> hooks;
    hooks.on_step = [&](double time) { times.push_back(time); };
    hooks.on_between_steps = [&](bool interrupted) {
        CHECK_FALSE(interrupted);
        ++between;
    };
    lumps::Quiet observer;
    run.run.begin();
    run.run.go(hooks, observer);
    REQUIRE(times.size() == run.run.steps().size());
    CHECK(between == static_cast<int>(times.size()));
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(times[k] == near(run.run.steps()[k].end.time, 1e-13));
}

TEST_CASE("a run that is stopped between any two steps goes on bit by bit, across segments too")
{
    const auto problem = motor();
    lumps::Run whole(two_lumps(), problem, 290);
    whole.go();
    const int steps = static_cast<int>(whole.run.steps().size());
    for (int after = 1; after < steps; after += 3) {
        CAPTURE(after);
        lumps::Run first(two_lumps(), problem, 290), second(two_lumps(), problem, 290);
        Stopping observer(after - 1);
        first.run.begin();
        const auto& stopped = first.run.go({}, observer);
        CHECK(stopped.interrupted);
        CHECK(static_cast<int>(first.run.steps().size()) == after);
        second.run.begin();
        auto state = first.run.state();
        state.history.interrupted = false;
        REQUIRE(misfit(state, second.run.state(), problem).empty());
        for (std::size_t k = 0; k < first.run.vectors().size(); ++k)
            *second.run.vectors()[k] = *first.run.vectors()[k];
        second.run.restore(state);
        lumps::Quiet quiet;
        const auto& history = second.run.go({}, quiet);
        CHECK(history.time == whole.run.history().time);
        CHECK(history.probes[1].value == whole.run.history().probes[1].value);
        CHECK(history.probes[1].rate == whole.run.history().probes[1].rate);
        CHECK(history.energy.to_air == whole.run.history().energy.to_air);
        CHECK(second.run.temperature() == whole.run.temperature());
    }
}

TEST_CASE("steps that would number more than a hundred thousand are warned of, once, after a thousand")
{
    HeatProblem problem;
    problem.segments.resize(2);
    problem.segments[0].duration = 1e6;
    problem.segments[1].duration = 1e6;
    Stopping observer(0);
    report_step(problem, 999, 100, 0.1, observer);
    report_step(problem, 1001, 100, 0.1, observer);
    report_step(problem, 1000, 100, 20, observer);  // 99 995 more
    CHECK(observer.warnings.empty());
    report_step(problem, 1000, 100, 19, observer);
    REQUIRE(observer.warnings.size() == 1);
    CHECK(observer.warnings[0].find("t = 100 s of 2e+06 s") != std::string::npos);
    CHECK(observer.warnings[0].find("19 s a step, 1.1e+05 more follow") != std::string::npos);
}

TEST_CASE("energy of a run with heat, film and a change of air closes, and its stored part is M (T - T_start)")
{
    auto problem = motor();
    problem.segments[1].ambient = [](double t) { return 290 + 10 * std::sin(t / 500); };
    lumps::Run run(two_lumps(), problem, 300);
    const auto& history = run.go();
    CHECK(history.energy.mismatch() < 1e-12);
    const auto end = run.temperatures();
    CHECK(history.energy.stored == near(2e4 * (end[0] - 300) + 5e4 * (end[1] - 300), 1e-11));
    CHECK(history.energy.generated == near(100 * 3000.0, 1e-12));
}
