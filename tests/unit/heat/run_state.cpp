/// Requirement: whatever in a state that was read does not belong to the case is found before the run goes on with it.
#include "deadpoint/heat/run_state.hpp"

#include "lumps.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <limits>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

/// A problem with one of everything, its run before the first step, and the state at the end of its first segment.
struct States {
    States()
    {
        InterfaceLaw law;
        law.film_a = law.film_b = 800;
        law.oil = 200;
        law.oil_temperature = 300;
        law.source = 0;
        problem.interfaces = {law};
        problem.sources = {{"pin", 1, {}, {}}};
        problem.body_heat = {{"motor", {0}, -1}};
        problem.surfaces = {lumps::film(15), lumps::film(5)};
        problem.surfaces[1].enclosure = 0;
        problem.enclosures = {{"cabin", 3000, 4, 295}};
        problem.oil = {{"main", {{0}}, false, 0, 2e4, 15, 300}};
        problem.fixed_step = 100;
        problem.field_times = {50, 250};
        for (const double duration : {300.0, 500.0}) {
            problem.segments.push_back(lumps::segment(problem, duration, 290));
            problem.segments.back().oil_flow = {60};
            problem.segments.back().heat[0] = [](double) { return LawValue{200, 0, true}; };
        }
        lumps::Run run({{2e4, 5e4}, {}, {{0, 1, 0.1}}, {{1, 0.5}, {0, 0.3}}, {0, 1}}, problem, 290);
        run.run.begin();
        begun = run.run.state();
        RunHooks<Eigen::VectorXd> hooks;
        hooks.on_between_steps = [&](bool) {
            if (run.run.steps().size() == 5)  // the second of the second segment
                state = run.run.state();
        };
        lumps::Quiet observer;
        run.run.go(hooks, observer);
    }
    /// What is said of the state after a change.
    [[nodiscard]] std::string said(const std::function<void(RunState&)>& change) const
    {
        auto changed = state;
        change(changed);
        return misfit(changed, begun, problem);
    }
    HeatProblem problem;
    RunState begun, state;
};

constexpr const char* lists = "its lists are not those of this case";
constexpr const char* times = "its times are not those of this case";
constexpr const char* history = "its history is not one of this case";

}  // namespace

TEST_CASE("a state of the same problem fits, also one before the second segment's first step")
{
    const States at;
    CHECK(misfit(at.state, at.begun, at.problem).empty());
    CHECK(at.state.place.segment == 1);
    CHECK(at.state.place.segment_start == 300);
    CHECK(at.state.place.next_field == 2);
}

TEST_CASE("lists of another length, and numbers beyond the problem's, are found")
{
    const States at;
    CHECK(at.said([](RunState& s) { s.place.segment = 2; }) == lists);
    CHECK(at.said([](RunState& s) { s.origin.segment = 2; }) == lists);
    CHECK(at.said([](RunState& s) { s.sumps.clear(); }) == lists);
    CHECK(at.said([](RunState& s) { s.oil_temperature.push_back(300); }) == lists);
    CHECK(at.said([](RunState& s) { s.air.pop_back(); }) == lists);
    CHECK(at.said([](RunState& s) { s.origin.air.push_back(300); }) == lists);
    CHECK(at.said([](RunState& s) { s.place.next_field = 3; }) == lists);
}

TEST_CASE("times that are none of the run's are found, lest its steps never end")
{
    const States at;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double nan = std::nan("");
    CHECK(at.said([](RunState& s) { s.place.segment = 0; }) == times);  // its time is beyond it
    CHECK(at.said([](RunState& s) { s.place.segment_start = 299; }) == times);
    CHECK(at.said([](RunState& s) { s.place.time = 300; }) == times);  // a step has been made
    CHECK(at.said([](RunState& s) { s.place.time = 801; }) == times);
    CHECK(at.said([&](RunState& s) { s.place.time = nan; }) == times);
    for (const double wanted : {0.0, -1.0, infinite, nan})
        CHECK(at.said([&](RunState& s) { s.place.wanted = wanted; }) == times);
    for (const double previous : {-1.0, infinite, nan})
        CHECK(at.said([&](RunState& s) { s.previous_step = previous; }) == times);
    CHECK(at.said([&](RunState& s) { s.origin.factor = nan; }) == times);
}

TEST_CASE("a history with a row too few, too many, or of another time, is found")
{
    const States at;
    CHECK(at.said([](RunState& s) { s.history.time.back() += 1; }) == history);
    CHECK(at.said([](RunState& s) { s.history.time.pop_back(); }) == history);
    CHECK(at.said([](RunState& s) { s.place.segment_row = s.history.time.size() - 1; }) == history);
    CHECK(at.said([](RunState& s) { s.place.segment_row = ~std::size_t{0}; }) == history);  // plus two it is one
    CHECK(at.said([](RunState& s) { std::swap(s.history.time[0], s.history.time[1]); }) == history);
    const std::vector<std::function<void(ThermalHistory&)>> changes{
        [](auto& h) { h.probes[0].value.pop_back(); },   [](auto& h) { h.probes[1].rate.push_back(0); },
        [](auto& h) { h.interface_a.clear(); },          [](auto& h) { h.interface_b[0].value.clear(); },
        [](auto& h) { h.part_means.emplace_back(); },    [](auto& h) { h.functionals.emplace_back(); },
        [](auto& h) { h.source_heat[0].pop_back(); },    [](auto& h) { h.source_temperature.clear(); },
        [](auto& h) { h.to_air.push_back(0); },          [](auto& h) { h.to_oil.pop_back(); },
        [](auto& h) { h.body_heat[0].pop_back(); },      [](auto& h) { h.oil[0].cooler.pop_back(); },
        [](auto& h) { h.oil[0].sump.value.pop_back(); }, [](auto& h) { h.enclosures[0].to_room.push_back(1); },
        [](auto& h) { h.enclosures.clear(); },           [](auto& h) { h.contributions.emplace_back(); },
        [](auto& h) { h.film_out_of_range.pop_back(); }, [](auto& h) { h.part_lowest.pop_back(); },
        [](auto& h) { h.part_highest.push_back(0); },
    };
    for (std::size_t k = 0; k < changes.size(); ++k) {
        CAPTURE(k);
        CHECK(at.said([&](RunState& s) { changes[k](s.history); }) == history);
    }
}

TEST_CASE("a balance or a step of another problem is found")
{
    const States at;
    CHECK(at.said([](RunState& s) { s.balance.source_heat.clear(); }) == history);
    CHECK(at.said([](RunState& s) { s.balance.oil.emplace_back(); }) == history);
    CHECK(at.said([](RunState& s) { s.balance.film.push_back(300); }) == history);
    CHECK(at.said([](RunState& s) { s.balance.film_mean.pop_back(); }) == history);
    CHECK(at.said([](RunState& s) { s.steps[1].segment = 5; }) == history);
    CHECK(at.said([](RunState& s) { s.steps[1].row = 1000; }) == history);
    CHECK(at.said([](RunState& s) { s.steps[0].duration = 0; }) == history);
    CHECK(at.said([](RunState& s) { s.steps[2].middle.air.clear(); }) == history);
    CHECK(at.said([](RunState& s) { s.steps[2].end.body_heat.push_back(1); }) == history);
    CHECK(at.said([](RunState& s) { s.steps[2].start.oil_temperature.clear(); }) == history);
}
