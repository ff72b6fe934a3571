/// Requirement: a run's history holds what was handed to it, with slopes and sums that fit its steps.
#include "deadpoint/heat/history.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

const FunctionalLayout layout{2, 3, 1, 1, 2};

HeatProblem problem()
{
    HeatProblem result;
    result.sources.resize(1);
    result.body_heat.resize(1);
    result.oil.resize(1);
    result.enclosures.resize(1);
    result.surfaces.resize(1);
    return result;
}

/// All scalars of a balance as functions of one number.
HeatBalance balance(double x)
{
    HeatBalance result;
    result.source_heat = {10 * x};
    result.source_temperature = {300 + x};
    result.body_heat = {5 * x};
    result.oil = {{300 + x, 301 + x, 302 + x, 0, 0, 20 * x, 30 * x}};
    result.air = {{295 + x, 2 * x, 3 * x, 4 * x}};
    result.generated = x;
    result.to_air = 2 * x;
    result.to_oil = 3 * x;
    result.flux = 4 * x;
    result.films_untested = {0};
    return result;
}

/// Values of the watched functionals, two observed ones and one contribution.
std::vector<double> values(double first)
{
    std::vector<double> result;
    for (int i = 0; i < 2 + 2 + 2 + 3 + 2 + 1; ++i)
        result.push_back(first + i);
    return result;
}

}  // namespace

TEST_CASE("a history watches probes, both sides of interfaces, and parts, in this order")
{
    const auto input = problem();
    const HistoryRecorder recorder(input, layout, 2, 1);
    std::vector<std::size_t> expected{layout.probe(0),       layout.probe(1),      layout.mean(0, false),
                                      layout.mean(1, false), layout.mean(0, true), layout.mean(1, true)};
    for (std::size_t p = 0; p < 3; ++p)
        expected.push_back(layout.part(p));
    CHECK(recorder.watched() == expected);
    CHECK(recorder.history().time.empty());
    CHECK(recorder.history().film_out_of_range == std::vector<bool>{false});
}

TEST_CASE("each value goes to the series it belongs to")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    recorder.record(0, values(100), {}, balance(1), {}, 0);
    recorder.record(10, values(200), values(0.5), balance(2), balance(1.6), 10);
    const auto& history = recorder.history();
    CHECK(history.time == std::vector<double>{0, 10});
    CHECK(history.probes[1].value == std::vector<double>{101, 201});
    CHECK(history.interface_a[0].value == std::vector<double>{102, 202});
    CHECK(history.interface_b[1].value == std::vector<double>{105, 205});
    CHECK(history.part_means[2].value == std::vector<double>{108, 208});
    CHECK(history.functionals[0].value == std::vector<double>{109, 209});
    CHECK(history.contributions[0] == std::vector<double>{111, 211});
    CHECK(history.functionals[1].rate == std::vector<double>{0, 10.5});
    CHECK(history.source_heat[0] == std::vector<double>{10, 20});
    CHECK(history.source_temperature[0] == std::vector<double>{301, 302});
    CHECK(history.body_heat[0] == std::vector<double>{5, 10});
    CHECK(history.oil[0].heat == std::vector<double>{20, 40});
    CHECK(history.oil[0].cooler == std::vector<double>{30, 60});
    CHECK(history.oil[0].outlet.value == std::vector<double>{302, 303});
    CHECK(history.enclosures[0].from_surfaces == std::vector<double>{2, 4});
    CHECK(history.enclosures[0].power == std::vector<double>{3, 6});
    CHECK(history.enclosures[0].to_room == std::vector<double>{4, 8});
    CHECK(history.to_air == std::vector<double>{2, 4});
    CHECK(history.to_oil == std::vector<double>{3, 6});
}

TEST_CASE("slopes of oil and air are those of the parabola through a step's three values")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    const double dt = 8;
    const auto x = [](double t) { return 3 + 0.5 * t - 0.02 * t * t; };
    recorder.record(0, values(0), {}, balance(x(0)), {}, 0);
    recorder.record(dt, values(0), values(0), balance(x(dt)), balance(x(gamma_stage * dt)), dt);
    const auto& history = recorder.history();
    const double slope = 0.5 - 0.04 * dt;
    for (const auto* series :
         {&history.oil[0].inlet, &history.oil[0].outlet, &history.oil[0].sump, &history.enclosures[0].temperature}) {
        CHECK(series->rate[0] == 0);  // open until the first step is there
        CHECK(series->rate[1] == near(slope, 1e-11));
    }
}

TEST_CASE("a segment's first slopes become those of the secant, other rows stay")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    recorder.record(0, values(100), values(7), balance(1), {}, 0);
    recorder.record(4, values(108), values(9), balance(3), balance(2), 4);
    recorder.fill_first_slopes(0);
    const auto& history = recorder.history();
    CHECK(history.probes[0].rate[0] == 2);
    CHECK(history.functionals[1].rate[0] == 2);
    CHECK(history.oil[0].sump.rate[0] == near(0.5, 1e-15));
    CHECK(history.enclosures[0].temperature.rate[0] == near(0.5, 1e-15));
    CHECK(history.probes[0].rate[1] == 9);
    // No step behind the last row: nothing to take a secant of.
    const auto before = history.probes[0].rate;
    recorder.fill_first_slopes(1);
    CHECK(history.probes[0].rate == before);
}

TEST_CASE("the heat of steps is summed by the weights of their stages: exact for watts that rise evenly")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    const auto watts = [](double t) { return 100 + 6 * t; };
    double time = 0;
    for (const double dt : {1.0, 4.0, 2.5}) {
        recorder.add_energy(dt, balance(watts(time)), balance(watts(time + gamma_stage * dt)),
                            balance(watts(time + dt)), 11, 13);
        time += dt;
    }
    const double integral = 100 * time + 3 * time * time;
    const auto& energy = recorder.history().energy;
    CHECK(energy.generated == near(integral, 1e-14));
    CHECK(energy.to_air == near(2 * integral, 1e-14));
    CHECK(energy.to_oil == near(3 * integral, 1e-14));
    CHECK(energy.from_surfaces == near(4 * integral + 33, 1e-14));
    CHECK(energy.stored == 39);
}

TEST_CASE("a law that left its range once stays told")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    auto outside = balance(1);
    outside.in_range = false;
    outside.films_untested = {0.3};
    recorder.record(0, values(0), {}, balance(1), {}, 0);
    CHECK_FALSE(recorder.history().law_out_of_range);
    CHECK_FALSE(recorder.history().film_out_of_range[0]);
    recorder.record(1, values(0), values(0), outside, balance(1), 1);
    recorder.record(2, values(0), values(0), balance(1), balance(1), 1);
    CHECK(recorder.history().law_out_of_range);
    CHECK(recorder.history().film_out_of_range[0]);
}

TEST_CASE("the history's cubic goes through a cubic exactly, between its rows too")
{
    const auto input = problem();
    HistoryRecorder recorder(input, layout, 2, 1);
    const auto y = [](double t) { return 300 + t - 0.2 * t * t + 0.03 * t * t * t; };
    const auto slope = [](double t) { return 1 - 0.4 * t + 0.09 * t * t; };
    for (const double t : {0.0, 1.0, 3.0, 7.0}) {
        auto at = values(0), rate = values(0);
        at[0] = y(t);
        rate[0] = slope(t);
        recorder.record(t, at, rate, balance(1), balance(1), t);
    }
    const auto& history = recorder.history();
    for (double t = 0; t <= 7; t += 0.25)
        CHECK(interpolate(history.time, history.probes[0], t) == near(y(t), 1e-13));
    CHECK(interpolate(history.time, history.probes[0], -5) == 300);  // held beyond
    CHECK(interpolate(history.time, history.probes[0], 99) == y(7));
}
