/// Requirement: no course over time is stepped over. Steps end where tables bend; where points are dense, a step passes
/// over them only if nothing watched would change, and takes their exact mean; functions are looked at every second.
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/balance.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

constexpr double hour = 3600;
/// Energies are sums of some hundred steps, each rounded.
constexpr double summed = 1e-10;

/// Steel of a litre with a heater, in still air of 0.6 W/K.
lumps::Machine block() { return {{3611}, {}, {}, {{0, 0.06}}, {0}}; }
HeatProblem heated(const TimeCourse& power, double duration = 4 * hour)
{
    HeatProblem problem;
    problem.time_tolerance = 0.02;
    problem.body_heat = {{"motor", {0}, -1}};
    problem.surfaces = {lumps::film(10)};
    problem.segments = {lumps::segment(problem, duration, 293.15)};
    problem.segments[0].body_heat[0] = power;
    return problem;
}

bool ends_at(const ThermalHistory& history, double time)
{
    return std::ranges::any_of(history.time, [&](double end) { return std::abs(end - time) < 1e-9 * time; });
}

/// Measured every 10 s over 8 h: a slow swing, a controller's cycle of 11 min and noise, around a mean.
TimeCourse logged(double mean, double swing, double noise)
{
    std::vector<double> times, values;
    unsigned state = 1;
    for (int k = 0; k <= 2880; ++k) {
        state = state * 1664525u + 1013904223u;
        times.push_back(10.0 * k);
        values.push_back(mean + swing * std::sin(k / 900.0) + 0.3 * swing * std::sin(k / 10.5) +
                         noise * (state / 4294967296.0 - 0.5));
    }
    return {times, values};
}

}  // namespace

TEST_CASE("a pulse between two long steps is stepped on: 150 kJ, and the peak of one mass")
{
    const auto problem = heated(TimeCourse({0, 7920, 7921, 8220, 8221}, {0, 0, 500, 500, 0}));
    lumps::Run run(block(), problem, 293.15);
    const auto& history = run.go();
    CHECK(history.energy.generated == near(150e3, summed));
    for (const double time : {7920.0, 7921.0, 8220.0, 8221.0})
        CHECK(ends_at(history, time));
    // C dT/dt = 500 W - 0.6 W/K (T - T_0) over 300 s: 833.3 K (1 - exp(-300 / 6018.3)), to the time tolerance
    CHECK(std::ranges::max(history.probes[0].value) - 293.15 == near(833.333 * -std::expm1(-300 / 6018.33), 0, 0.03));
}

TEST_CASE("a table with two equal times jumps there, without a collapse, with its whole energy")
{
    const auto problem = heated(TimeCourse({0, 1000, 1000, 1600, 1600}, {0, 0, 700, 700, 100}));
    lumps::Run run(block(), problem, 293.15);
    const auto& history = run.go();
    CHECK(history.energy.generated == near(700.0 * 600 + 100.0 * (4 * hour - 1600), summed));
    CHECK(run.run.steps().size() < 300);
}

TEST_CASE("a dense table of heat, flux or power keeps its integral in few steps")
{
    const auto course = logged(40, 20, 2);
    const double energy = course.mean(0, 8 * hour) * 8 * hour;
    auto by_motor = heated(course, 8 * hour);
    auto by_flux = heated(lumps::steady(0), 8 * hour);
    auto machine = block();
    machine.surfaces.push_back({0, 1});
    by_flux.surfaces.push_back({});
    by_flux.surfaces[1].kind = SurfaceCondition::Kind::flux;
    by_flux.surfaces[1].flux = course;
    auto by_power = heated(lumps::steady(0), 8 * hour);
    by_power.enclosures = {{"cabin", 500, 3, 293.15}};
    by_power.segments[0].enclosure_power = {course};
    lumps::Run motor(block(), by_motor, 293.15), flux(machine, by_flux, 293.15), power(block(), by_power, 293.15);
    power.run.set_media({}, {293.15});
    CHECK(motor.go().energy.generated == near(energy, summed));
    CHECK(flux.go().energy.from_surfaces == near(energy, summed));
    CHECK(power.go().energy.generated == near(energy, summed));
    for (const auto* run : {&motor, &flux}) {
        CHECK(run->run.steps().size() < 1000);  // of 2880 points
        CHECK(run->run.history().energy.mismatch() < 1e-11);
    }
}

TEST_CASE("room air that was measured every ten seconds costs few steps and has its exact mean")
{
    auto problem = heated(lumps::steady(0), 8 * hour);
    problem.segments[0].ambient = logged(295, 3, 0.4);
    lumps::Run run(block(), problem, 295);
    const auto& history = run.go();
    CHECK(run.run.steps().size() < 150);
    // Against the same with a step at each point.
    auto fine = problem;
    fine.fixed_step = 10;
    lumps::Run at_each(block(), fine, 295);
    at_each.go();
    const double largest = [&] {
        double difference = 0;
        for (double t = 0; t <= 8 * hour; t += 100)
            difference = std::max(
                difference, std::abs(interpolate(history.time, history.probes[0], t) -
                                     interpolate(at_each.run.history().time, at_each.run.history().probes[0], t)));
        return difference;
    }();
    CHECK(largest < problem.time_tolerance);
}

TEST_CASE("a pulse within a dense table is not passed over")
{
    std::vector<double> times, values;
    for (int k = 0; k <= 1440; ++k) {
        times.push_back(10.0 * k);
        values.push_back(k >= 700 && k < 730 ? 500 : 0);
    }
    const auto problem = heated(TimeCourse(times, values));
    lumps::Run run(block(), problem, 293.15);
    const auto& history = run.go();
    CHECK(history.energy.generated == near(150e3, summed));
    CHECK(std::ranges::max(history.probes[0].value) - 293.15 == near(833.333 * -std::expm1(-300 / 6018.33), 0, 0.1));
    CHECK(run.run.steps().size() < 200);
}

TEST_CASE("a function that acts for minutes is seen between steps of half an hour")
{
    const auto problem = heated(TimeCourse([](double t) { return t > 7920 && t < 8220 ? 500.0 : 0.0; }));
    lumps::Run run(block(), problem, 293.15);
    const auto& history = run.go();
    // Both jumps within a second, which Gauss' method does not cut.
    CHECK(history.energy.generated == near(150e3, 1e-3));
    CHECK(std::ranges::max(history.probes[0].value) - 293.15 == near(833.333 * -std::expm1(-300 / 6018.33), 0, 0.1));
}

TEST_CASE("a daily course of the air has its exact mean over any part of a day")
{
    constexpr double day = 24 * hour;
    HeatProblem problem;
    problem.surfaces = {lumps::film(10)};
    problem.segments = {lumps::segment(problem, 7 * hour, 293.15)};
    problem.segments[0].ambient = {[](double t) { return 293.15 + 5 * std::cos(2 * M_PI * t / day); }, day / 16};
    lumps::Run run({{1e12}, {}, {}, {{0, 1}}, {0}}, problem, 293.15);  // stays at 293.15 K
    // 10 W/K times the integral of the air's difference
    CHECK(run.go().energy.to_air == near(-10 * 5 * day / (2 * M_PI) * std::sin(2 * M_PI * 7 / 24), 1e-6));
    CHECK(run.run.steps().size() < 60);
}

TEST_CASE("points fall anywhere: all energies are those of the tables, and steps of a millisecond do not multiply")
{
    for (const double shift : {0.0, 0.3, 123.456, 1799.9999}) {
        CAPTURE(shift);
        const TimeCourse course({shift, shift + 0.001, shift + 777.7, shift + 777.9, shift + 5000.5},
                                {100, 400, 200, 900, 0});
        const auto problem = heated(course);
        lumps::Run run(block(), problem, 293.15);
        CHECK(run.go().energy.generated == near(course.mean(0, 4 * hour) * 4 * hour, summed));
        CHECK(run.run.steps().size() < 250);
    }
}

TEST_CASE("a run over tables goes on bit by bit from any of its steps, and a longer one takes the same steps")
{
    auto problem = heated(logged(40, 20, 10), 3000);
    problem.segments[0].ambient = {{0, 700, 701, 2500}, {293, 293, 299, 290}};
    problem.segments.push_back(problem.segments[0]);
    lumps::Run whole(block(), problem, 293.15);
    whole.go();
    std::vector<RunState> states;
    std::vector<std::vector<Eigen::VectorXd>> vectors;
    lumps::Run again(block(), problem, 293.15);
    std::size_t in_sight = 0;
    RunHooks<Eigen::VectorXd> hooks;
    hooks.on_between_steps = [&](bool) {
        states.push_back(again.run.state());
        auto& list = vectors.emplace_back();
        for (const auto* vector : again.run.vectors())
            list.push_back(*vector);
    };
    hooks.on_end_in_sight = [&] { in_sight = states.size(); };
    lumps::Quiet quiet;
    again.run.begin();
    again.run.go(hooks, quiet);
    CHECK(again.run.history().time == whole.run.history().time);
    const auto from = [&](std::size_t step, const HeatProblem& of) {
        lumps::Run run(block(), of, 293.15);
        run.run.begin();
        REQUIRE(misfit(states[step], run.run.state(), of).empty());
        for (std::size_t k = 0; k < vectors[step].size(); ++k)
            *run.run.vectors()[k] = vectors[step][k];
        run.run.restore(states[step]);
        run.run.go({}, quiet);
        return run.run.history();
    };
    for (std::size_t step = 0; step < states.size(); step += 7) {
        CAPTURE(step);
        const auto history = from(step, problem);
        CHECK(history.time == whole.run.history().time);
        CHECK(history.probes[0].value == whole.run.history().probes[0].value);
        CHECK(history.energy.generated == whole.run.history().energy.generated);
    }
    auto longer = problem;
    longer.segments[1].duration += 1234.5;
    lumps::Run prolonged(block(), longer, 293.15);
    prolonged.go();
    REQUIRE(in_sight > 0);
    const auto history = from(in_sight - 1, longer);
    CHECK(history.time == prolonged.run.history().time);
    CHECK(history.probes[0].value == prolonged.run.history().probes[0].value);
}

TEST_CASE("causes over dense tables add up to the rise")
{
    auto problem = heated(logged(40, 20, 10), 8 * hour);
    problem.segments[0].ambient = logged(295, 3, 0.4);
    lumps::Run run(block(), problem, 293.15);
    run.go();
    constexpr double reference = 293.15;
    const double rise = run.temperatures()[0] - reference;
    HeatAdjoint adjoint(run.run, reference);
    adjoint.weights() = Eigen::VectorXd::Constant(1, 1 / std::sqrt(3611.0));
    const auto causes = adjoint.causes(run.run.history().time.size() - 1);
    CHECK(causes.body_heat[0] + causes.surfaces[0] + causes.start == near(rise, 1e-9));  // of adjoint solves
}
