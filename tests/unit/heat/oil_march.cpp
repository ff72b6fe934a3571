/// Requirement: oil carries heat from joint to joint without losing any, and a sump follows its balance, of any
/// capacity and with any flow.
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/heat/oil.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

constexpr double flow = 60, loss = 15, ambient = 290;

/// Three interfaces at three places: the first joint has two of them, the second one.
struct Circuit {
    explicit Circuit(bool cooled)
    {
        geometry.layout = {3, 1, 0, 0, 0};
        geometry.interface_names = {"left", "right", "top"};
        geometry.interface_area = {0.2, 0.1, 0.3};
        InterfaceLaw law;
        law.film_a = 500;
        law.film_b = 400;
        law.oil = 300;
        law.oil_temperature = 300;
        problem.interfaces = {law, law, law};
        problem.oil.resize(1);
        problem.oil[0].joints = {{0, 1}, {2}};
        problem.oil[0].cooled = cooled;
        problem.oil[0].inlet_temperature = 303;
        problem.oil[0].sump_capacity = 2e4;
        problem.oil[0].sump_loss = loss;
        segment.duration = 1000;
        segment.oil_flow = {flow};
        segment.ambient = [](double) { return ambient; };
        values.assign(geometry.layout.count(), 340);
    }
    /// The balance with the oil of the laws, then marched. @return where the oil reaches each interface
    std::vector<double> march(double factor, double known)
    {
        JointBalance joints(problem, geometry);
        joints.enter(segment);
        OilMarch oil(problem);
        oil.enter(segment);
        balance = {};
        std::vector<double> watts(geometry.layout.count(), 0.0);
        joints.evaluate(values, balance, watts);
        return oil.march(joints, balance, 0, factor, {known});
    }
    HeatGeometry geometry;
    HeatProblem problem;
    HeatSegment segment;
    std::vector<double> values;
    HeatBalance balance;
};

// A film between sides of 340 K and oil at t conducts U = 300 x 900 / 1200 W/m2/K to it.
constexpr double conductance = 300 * 900 / 1200.0;
double leaves(double area, double inlet) { return inlet + area * conductance * (340 - inlet) / flow; }

}  // namespace

TEST_CASE("oil reaches the interfaces of one joint at one temperature and the next joint warmer by their heat")
{
    Circuit at(true);
    const auto reaches = at.march(0, 310);
    CHECK(reaches[0] == 303);
    CHECK(reaches[1] == 303);
    CHECK(reaches[2] == near(leaves(0.3, 303), 1e-14));  // 0.2 + 0.1 m2
    const auto& state = at.balance.oil[0];
    CHECK(state.inlet == 303);
    CHECK(state.outlet == near(leaves(0.3, leaves(0.3, 303)), 1e-14));
    CHECK(state.heat == near(flow * (state.outlet - 303), 1e-12));
}

TEST_CASE("the cooler takes what brings the sump's oil to the inlet's temperature")
{
    Circuit at(true);
    at.march(0, 310);
    const auto& state = at.balance.oil[0];
    CHECK(state.sump == 310);
    CHECK(state.cooler == near(flow * (310 - 303), 1e-14));
    // What comes from the joints stays in the sump, or leaves by the cooler or to the room.
    CHECK(2e4 * state.sump_rate == near(state.heat - state.cooler - loss * (310 - ambient), 1e-12));
}

TEST_CASE("without a cooler the sump feeds the joints, which take or give what the sump loses or gains")
{
    Circuit at(false);
    at.march(0, 310);
    const auto& state = at.balance.oil[0];
    CHECK(state.inlet == 310);
    CHECK(state.cooler == 0);
    CHECK(state.outlet == near(leaves(0.3, leaves(0.3, 310)), 1e-14));
    CHECK(2e4 * state.sump_rate == near(state.heat - loss * (310 - ambient), 1e-12));
}

TEST_CASE("the sump at a stage's end meets C s = C known + factor (flow (outlet - s) - loss (s - ambient))")
{
    for (const bool cooled : {false, true})
        for (const double factor : {0.0, 3.0, 500.0, 1e6}) {
            CAPTURE(cooled);
            CAPTURE(factor);
            Circuit at(cooled);
            at.march(factor, 310);
            const auto& state = at.balance.oil[0];
            const double gains = flow * (state.outlet - state.sump) - loss * (state.sump - ambient);
            CHECK(2e4 * state.sump == near(2e4 * 310 + factor * gains, 1e-11));
            CHECK(state.sump_rate == near(gains / 2e4, 1e-9));
        }
}

TEST_CASE("a long stage brings the sump to where it loses what it gains")
{
    Circuit at(false);
    at.march(1e12, 310);
    // Per kelvin of the inlet the outlet rises by (1 - A U / flow)^2; all solids are at 340 K.
    const double passed = std::pow(1 - 0.3 * conductance / flow, 2);
    const double to_solids = flow * (1 - passed);
    CHECK(at.balance.oil[0].sump == near((to_solids * 340 + loss * ambient) / (to_solids + loss), 1e-8));
}

TEST_CASE("a sump's relaxation is minus the derivative of its rate by its temperature")
{
    for (const bool cooled : {false, true}) {
        Circuit at(cooled);
        at.march(0, 310);
        const auto before = at.balance.oil[0];
        at.march(0, 312);
        const auto after = at.balance.oil[0];
        const double by_difference = (after.sump_rate - before.sump_rate) / 2;  // straight
        CHECK(before.sump_relaxation == near(-by_difference, 1e-10));
        CHECK(before.sump_relaxation > 0);
    }
}

TEST_CASE("a sump without capacity follows at once, whatever was known of it")
{
    for (const bool cooled : {false, true})
        for (const double known : {280.0, 350.0}) {
            Circuit at(cooled);
            at.problem.oil[0].sump_capacity = 0;
            at.march(77, known);
            const auto& state = at.balance.oil[0];
            CHECK(flow * (state.outlet - state.sump) == near(loss * (state.sump - ambient), 1e-11));
            CHECK(state.sump_rate == 0);
            CHECK(state.sump_relaxation == 0);
        }
}

TEST_CASE("oil that stands takes no heat along and reaches every joint as it is")
{
    Circuit at(false);
    at.segment.oil_flow = {0};
    const auto reaches = at.march(100, 310);
    const auto& state = at.balance.oil[0];
    for (const double t : reaches)
        CHECK(t == near(state.sump, 1e-15));
    CHECK(state.heat == 0);
    CHECK(state.outlet == state.inlet);
    // The sump cools by itself: s (C + f G) = C known + f G ambient.
    CHECK(state.sump == near((2e4 * 310 + 100 * loss * ambient) / (2e4 + 100 * loss), 1e-14));
}

TEST_CASE("a sump that nothing ties to anything keeps its temperature, also without capacity")
{
    Circuit at(true);
    at.segment.oil_flow = {0};
    at.problem.oil[0].sump_loss = 0;
    at.problem.oil[0].sump_capacity = 0;
    at.march(100, 317);
    CHECK(at.balance.oil[0].sump == 317);
    CHECK(std::isfinite(at.balance.oil[0].sump_rate));
}

TEST_CASE("what the stages know of a sump makes a whole step that of TR-BDF2")
{
    // s' = -r (s - ambient) by its own loss: the step's growth is known in closed form.
    Circuit at(true);
    at.segment.oil_flow = {0};
    OilMarch oil(at.problem);
    oil.enter(at.segment);
    oil.set_sumps({330});
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    HeatBalance start, middle, end;
    std::vector<double> watts(at.geometry.layout.count(), 0.0);
    for (auto* balance : {&start, &middle, &end})
        joints.evaluate(at.values, *balance, watts);
    const double dt = 400, factor = diagonal * dt;
    oil.march(joints, start, 0, 0, oil.sumps());
    oil.march(joints, middle, 0, factor, oil.known_in_first_stage(factor, start));
    oil.march(joints, end, 0, factor, oil.known_in_second_stage(middle));
    const double z = -loss / 2e4 * dt;
    const double of_middle = (1 + diagonal * z) / (1 - diagonal * z);
    const double of_end = (bdf_middle * of_middle - bdf_now) / (1 - diagonal * z);
    CHECK(middle.oil[0].sump - ambient == near(40 * of_middle, 1e-12));
    CHECK(end.oil[0].sump - ambient == near(40 * of_end, 1e-12));
    oil.accept(end);
    CHECK(oil.sumps()[0] == end.oil[0].sump);
}

TEST_CASE("a sump's error: that of its slopes, sharper for a sump that forgets slowly, filtered in a first step")
{
    Circuit at(false);
    OilMarch oil(at.problem);
    oil.enter(at.segment);
    HeatBalance start, middle, end;
    for (auto* balance : {&start, &middle, &end})
        balance->oil.resize(1);
    start.oil[0].sump_rate = 0.03;
    middle.oil[0].sump_rate = 0.012;
    end.oil[0].sump_rate = 0.01;
    const double dt = 100;
    const double raw = std::abs(step_error(dt, 0.03, 0.012, 0.01));
    // One that forgets within a step: the error itself.
    end.oil[0].sump_relaxation = 10;
    CHECK(oil.step_error(dt, true, start, middle, end) == near(raw, 1e-12));
    CHECK(oil.step_error(dt, false, start, middle, end) == near(raw / (1 + diagonal * dt * 10), 1e-12));
    // One that forgets nothing: of the segment's ten steps each may err by a tenth, not by the step's share.
    end.oil[0].sump_relaxation = 0;
    const double of_a_step = heat::step_tolerance(at.problem.time_tolerance) / at.problem.time_tolerance;
    CHECK(oil.step_error(dt, true, start, middle, end) == near(raw * of_a_step * 1000 / dt, 1e-12));
    // No circuit, no error.
    CHECK(oil.step_error(dt, true, {}, {}, {}) == 0);
}
