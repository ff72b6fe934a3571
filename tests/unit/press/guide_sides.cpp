/// Requirement: the side of a guide that is pressed has the force, the pressure and the friction heat; the joint as a
/// whole keeps its heat.
#include "deadpoint/press/laws/guide_sides.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

/// A press that leans to the right, so that its slide does, and whose right gib has half of the depth of its left one.
casefile::Case made_press(const std::string& preload = "2 kN")
{
    auto input =
        casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml",
                            {"joints.guide.preload=\"" + preload + "\"", "machine.gravity_direction=[0.3, -1, 0]"})
            .value;
    casefile::GuideFriction coulomb;
    coulomb.coefficient = 0.1;
    input.friction.at("gibs").law = coulomb;
    std::get<BoxShape>(input.parts.at("gib_right").shapes.at(0).form).max[2] = 0;
    return input;
}

const Machine& machine()
{
    static const Machine built = [] {
        Observer quiet;
        return full::prepare_machine(made_press(), 3, quiet);
    }();
    return built;
}

std::size_t first_of_guide(const casefile::Case& input)
{
    std::size_t first = 0;
    for (const auto& [name, joint] : input.joints) {
        if (name == "guide")
            return first;
        first += joint.interfaces.size();
    }
    return first;
}

/// Mean over the turn of a function of the force on the slide to the right.
template <class Function>
double mean_of(const press::LoadsResult& loads, const Function& function)
{
    const auto joint = std::ranges::find(loads.linkage.joints, "guide", &LinkageJoint::name);
    const auto& force = loads.history.joints[static_cast<std::size_t>(joint - loads.linkage.joints.begin())].force;
    const auto& time = loads.history.time;
    double sum = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double before = i > 0 ? time[i - 1] : time.back() - loads.history.period;
        const double after = i + 1 < time.size() ? time[i + 1] : time.front() + loads.history.period;
        sum += (after - before) / 2 / loads.history.period * function(force[i][0]);
    }
    return sum;
}

struct Pressed {
    explicit Pressed(const std::string& preload)
        : input(made_press(preload)), loads(press::compute_loads(input, &machine(), 0))
    {
        sides = press::guide_sides(input, machine(), loads, "guide", first_of_guide(input)).value();
    }
    casefile::Case input;
    press::LoadsResult loads;
    press::GuideSides sides;
};

}  // namespace

TEST_CASE("the gib on the left pushes the slide to the right, in whatever order the joint names its sides")
{
    const Pressed drawn("2 kN");
    CHECK(drawn.sides.of_interface == std::vector<int>{1, -1});
    auto input = made_press();
    std::swap(input.joints.at("guide").bodies[0], input.joints.at("guide").bodies[1]);
    const auto loads = press::compute_loads(input, &machine(), 0);
    const auto turned = press::guide_sides(input, machine(), loads, "guide", first_of_guide(input)).value();
    // The push on the frame, body_a now, goes the other way: the left gib is pushed to the left.
    CHECK(turned.of_interface == std::vector<int>{-1, 1});
    CHECK(turned.load_minus == near(drawn.sides.load_plus, 1e-9));
    CHECK(turned.heat_plus == near(1 - drawn.sides.heat_plus, 1e-9));
}

TEST_CASE("under preload both sides share the side force, without it one side has all of it")
{
    const Pressed tight("500 kN");
    const double side = mean_of(tight.loads, [](double force) { return force; });
    REQUIRE(std::abs(side) > 1);
    CHECK(tight.sides.load_plus == near(500e3 + side / 2, 1e-10));
    CHECK(tight.sides.load_minus == near(500e3 - side / 2, 1e-10));
    CHECK(tight.sides.heat_plus == near(0.5, 0.01));
    const Pressed loose("0 N");
    CHECK(loose.sides.load_plus == near(mean_of(loose.loads, [](double force) { return std::max(force, 0.0); }), 1e-9));
    CHECK(loose.sides.load_minus ==
          near(mean_of(loose.loads, [](double force) { return std::max(-force, 0.0); }), 1e-9));
}

TEST_CASE("the joint keeps its heat, and a narrow gib gets more of it per area")
{
    const Pressed at("2 kN");
    const auto first = first_of_guide(at.input);
    const double left = machine().interfaces[first].area, right = machine().interfaces[first + 1].area;
    CHECK(right == near(left / 2, 1e-6));
    for (const double part : {0.0, 0.4, 1.0}) {
        const auto factors = press::side_factors(at.input, machine(), at.sides, "guide", first, part);
        CHECK(factors[0] * left + factors[1] * right == near(left + right, 1e-12));
        // Each side has its share of the load part; of the rest, each area has the same.
        CHECK(factors[1] * right / (left + right) ==
              near(part * (1 - at.sides.heat_plus) + (1 - part) * right / (left + right), 1e-12));
    }
}

TEST_CASE("pressure and heat of a guide are those of its sides")
{
    const Pressed at("2 kN");
    const auto first = first_of_guide(at.input);
    const auto conductances = press::interface_conductances(at.input, machine(), &at.loads, at.loads.speed);
    CHECK(*conductances[first].pressure == near(at.sides.load_plus / machine().interfaces[first].area, 1e-12));
    CHECK(*conductances[first + 1].pressure == near(at.sides.load_minus / machine().interfaces[first + 1].area, 1e-12));
    Observer quiet;
    const auto problem = press::describe_heat(at.input, machine(), quiet, &at.loads);
    const auto& laws =
        problem.segments.front().interfaces.empty() ? problem.interfaces : problem.segments.front().interfaces;
    // They rub without a film: all of the heat follows the load.
    CHECK(laws[first + 1].heat_weight * machine().interfaces[first + 1].area /
              (laws[first].heat_weight * machine().interfaces[first].area) ==
          near((1 - at.sides.heat_plus) / at.sides.heat_plus, 1e-9));
    CHECK(laws[first + 1].heat_weight > 1.2 * laws[first].heat_weight);
}

TEST_CASE("a guide that is drawn on one side, or by half, has no sides")
{
    auto input = made_press();
    auto& interfaces = input.joints.at("guide").interfaces;
    interfaces.pop_back();
    auto bare = machine();
    const auto first = first_of_guide(input);
    bare.interfaces.erase(bare.interfaces.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    const auto loads = press::compute_loads(made_press(), &machine(), 0);
    CHECK_FALSE(press::guide_sides(input, bare, loads, "guide", first));
    auto half = made_press();
    half.machine.half_model = true;
    CHECK_FALSE(press::guide_sides(half, machine(), loads, "guide", first));
    CHECK_FALSE(press::guide_sides(made_press(), machine(), loads, "wrist_pin", 0));
}
