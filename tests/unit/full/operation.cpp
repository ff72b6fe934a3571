/// Requirement: oil circuits, heat of other kinds, load zones and warm rings reach the heat stage as the case states
/// them.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/friction_physics.hpp"
#include "deadpoint/press/laws/load_zone.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/oil.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rpm = pi / 30;

casefile::Case made_press(const std::string& name)
{
    return casefile::read_case(std::string(DEADPOINT_SOURCE_DIR "/cases/") + name).value;
}

const casefile::Case& starter()
{
    static const auto input = made_press("starter-by-laws/case.toml");
    return input;
}

const Machine& starter_machine()
{
    static const Machine machine = [] {
        Observer quiet;
        return full::prepare_machine(starter(), 2.5, quiet);
    }();
    return machine;
}

HeatProblem problem_of(const casefile::Case& input)
{
    Observer quiet;
    const auto loads = press::compute_loads(input, &starter_machine(), 0);
    return press::describe_heat(input, starter_machine(), quiet, &loads);
}

// Index of a joint's first interface.
std::size_t first_interface(const casefile::Case& input, const std::string& joint)
{
    std::size_t first = 0;
    for (const auto& [name, other] : input.joints) {
        if (name == joint)
            return first;
        first += other.interfaces.size();
    }
    return first;
}

Vec3 around(double degrees, double radius = 0.04)
{
    return {radius * std::cos(degrees * pi / 180), radius * std::sin(degrees * pi / 180), 0.1};
}

}  // namespace

TEST_CASE("a circuit has the heat capacity of its flow, and serves its joints in order")
{
    const auto& input = starter();
    const auto circuits = press::oil_circuits(input, starter_machine());
    REQUIRE(circuits.size() == 1);
    const double density = input.lubricants.at("oil").density;
    CHECK(density > 800);
    CHECK(circuits[0].sump_capacity == near(0.020 * density * 1900, 1e-12));
    CHECK(circuits[0].sump_loss == 6);
    CHECK(!circuits[0].cooled);
    const auto bearing = static_cast<int>(first_interface(input, "crank_bearing"));
    CHECK(circuits[0].joints[0] == std::vector<int>{bearing, bearing + 1});
    CHECK(circuits[0].joints[1] == std::vector<int>{static_cast<int>(first_interface(input, "crank_pin"))});

    auto segment = input.operation[0];
    const double flow = 2e-3 / 60 * density * 1900;
    CHECK(press::oil_flows(input, starter_machine(), segment)[0] == near(flow, 1e-12));
    segment.speed = 0;
    CHECK(press::oil_flows(input, starter_machine(), segment)[0] == 0);
}

TEST_CASE("half a press has half the flow, half the sump and half the motor")
{
    auto half = starter_machine();
    half.half_model = true;
    const auto whole = press::oil_circuits(starter(), starter_machine())[0];
    const auto circuit = press::oil_circuits(starter(), half)[0];
    CHECK(circuit.sump_capacity == near(whole.sump_capacity / 2, 1e-5));
    CHECK(circuit.sump_loss == near(whole.sump_loss / 2, 1e-5));
    CHECK(press::oil_flows(starter(), half, starter().operation[0])[0] ==
          near(press::oil_flows(starter(), starter_machine(), starter().operation[0])[0] / 2, 1e-5));
    Observer quiet;
    const auto loads = press::compute_loads(starter(), &starter_machine(), 0);
    CHECK(press::describe_heat(starter(), half, quiet, &loads).segments[0].body_heat[0](0) == near(25, 1e-5));
    CHECK(problem_of(starter()).segments[0].body_heat[0](0) == near(50, 1e-5));
}

TEST_CASE("the coefficient against the arriving oil is that of an exchanger")
{
    const auto& input = starter();
    const auto problem = problem_of(input);
    const auto first = first_interface(input, "crank_bearing");
    const double area = starter_machine().interfaces[first].area + starter_machine().interfaces[first + 1].area;
    const double units = 150 * area / problem.segments[0].oil_flow[0];
    const double expected = 150 * (1 - std::exp(-units)) / units;
    for (const auto i : {first, first + 1})
        CHECK(problem.segments[0].interfaces[i].oil == near(expected, 1e-12));
    CHECK(problem.interfaces[first].oil == 150);
    // The guide is on no circuit.
    CHECK(problem.segments[0].interfaces[first_interface(input, "guide")].oil == 0);
}

TEST_CASE("a resting press conducts as it did when it last ran, and its oil and clutch stand still")
{
    auto input = starter();
    input.operation.push_back(input.operation[0]);
    input.operation.push_back(input.operation[0]);
    input.operation[1].speed = 0;
    input.operation[2].force = 0;
    input.joints.at("guide").preload = 0;
    const auto problem = problem_of(input);
    const auto guide = first_interface(input, "guide");
    const auto film = [&](std::size_t s) { return problem.segments[s].interfaces[guide].film_a; };
    CHECK(film(1) == film(0));
    // Without preload and process the gibs carry less, and touch less.
    CHECK(film(2) < film(0));
    CHECK(problem.segments[1].interfaces[first_interface(input, "crank_bearing")].oil == 0);
    CHECK(!problem.segments[1].body_heat[0]);
    CHECK(!problem.segments[1].heat[0]);
    input.heat_sources.at("clutch").at_rest = true;
    CHECK(problem_of(input).segments[1].body_heat[0](0) == near(50, 1e-5));
}

TEST_CASE("oil coefficients grow with the speed of each segment")
{
    auto input = starter();
    input.oil_circuits.clear();
    const double speed = input.operation[0].speed;
    for (const double factor : {4.0, 0.0}) {
        input.operation.push_back(input.operation[0]);
        input.operation.back().speed = factor * speed;
    }
    input.oil_with_speed["journals"] = {0.5, speed, 0.2};
    const auto problem = problem_of(input);
    const auto bearing = first_interface(input, "crank_bearing"), pin = first_interface(input, "crank_pin");
    const auto oil = [&](std::size_t segment, std::size_t i) { return problem.segments[segment].interfaces[i].oil; };
    // 150 W/m2/K at the speed of the first segment
    CHECK(oil(0, bearing) == near(150, 1e-14));
    CHECK(oil(1, bearing) == near(150 * (0.2 + 0.8 * 2), 1e-14));
    CHECK(oil(2, bearing) == near(150 * 0.2, 1e-14));
    CHECK(problem.interfaces[bearing].oil == near(150, 1e-14));
    CHECK(oil(1, pin) == 150);
}

TEST_CASE("under a steady force the load heat falls over the half ring as the squared cosine")
{
    const auto& input = starter();
    auto loads = press::compute_loads(input, &starter_machine(), 0);
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (loads.linkage.joints[j].name == "crank_bearing") {
            // on body a: 2 kN at 30 degrees by the moving body on the ground
            const bool ground_is_a = loads.linkage.joints[j].body_a == loads.linkage.ground;
            const double sign = ground_is_a ? 1 : -1;
            for (auto& force : loads.history.joints[j].force)
                force = {sign * 2000 * std::cos(pi / 6), sign * 2000 * std::sin(pi / 6)};
        }
    const auto zone = press::load_zone(input, "crank_bearing", loads);
    CHECK(zone(around(30)) == near(4, 1e-9));
    CHECK(zone(around(90)) == near(1, 1e-9));
    CHECK(zone(around(-30)) == near(1, 1e-9));
    CHECK(zone(around(121)) == 0);
    CHECK(zone(around(210)) == 0);
}

TEST_CASE("the load zone of a real turn has the mean 1 and lies where the shaft presses most")
{
    const auto& input = starter();
    const auto loads = press::compute_loads(input, &starter_machine(), 0);
    const auto zone = press::load_zone(input, "crank_bearing", loads);
    double mean = 0;
    for (int degree = 0; degree < 360; ++degree)
        mean += zone(around(degree)) / 360;
    CHECK(mean == near(1, 1e-9));
    // 100 kN push the crankshaft up into its bearings near bottom dead point; its weight alone hangs down.
    CHECK(zone(around(90)) > 1.5);
    CHECK(zone(around(270)) < zone(around(90)));
}

TEST_CASE("heat without load has no zone")
{
    const auto& input = starter();
    auto loads = press::compute_loads(input, &starter_machine(), 0);
    for (auto& joint : loads.history.joints)
        for (auto& force : joint.force)
            force = {0, 0};
    CHECK_THROWS_WITH_AS(press::load_zone(input, "crank_bearing", loads), doctest::Contains("carries no load"),
                         InputError);
}

namespace {

// A pair 170 x 260 as in the press, with balls of 32 mm, preloaded by 2 kN.
casefile::PalmgrenFriction preloaded(PairArrangement arrangement, double distance)
{
    casefile::PalmgrenFriction f;
    f.bearing = BearingType::angular_contact_ball_pair;
    f.mean_diameter = 0.215;
    f.static_rating = 220e3;
    f.contact_angle = 15 * pi / 180;
    f.axial_preload = 2000;
    f.balls = 18;
    f.ball_diameter = 0.032;
    f.ring_expansion = 11.5e-6;
    f.arrangement = arrangement;
    f.row_distance = distance;
    return f;
}

casefile::Friction oiled(const casefile::FrictionLaw& law)
{
    casefile::Friction friction;
    friction.law = law;
    friction.lubricant = "oil";
    return friction;
}

RingHeatLaw ring_heat(const casefile::PalmgrenFriction& law)
{
    tribology::Duty duty = tribology::steady_duty(5000, 200 * rpm);
    return press::physical_heat(starter(), oiled(law), {{"joint", nullptr, {duty}}}).ring_heat;
}

}  // namespace

TEST_CASE("rings of one temperature keep the heat, a warmer inner ring raises it by the preload")
{
    const auto law = ring_heat(preloaded(PairArrangement::face_to_face, 0.042));
    REQUIRE(law);
    CHECK(law(0) == 0);
    CHECK(law(5) > 0);
    CHECK(law(10) > law(5));
    CHECK(law(-5) < 0);
    // A preload of zero is the least: colder rings take nothing more.
    CHECK(law(-40) == near(law(-50), 1e-9));
    CHECK(!ring_heat([] {
        auto f = preloaded(PairArrangement::face_to_face, 0.042);
        f.ring_expansion.reset();
        return f;
    }()));
}

TEST_CASE("a pair back to back whose cones meet in one point does not feel its rings")
{
    // d_m cos b = l sin b
    const auto law = ring_heat(preloaded(PairArrangement::back_to_back, 0.215 / std::tan(15 * pi / 180)));
    CHECK(std::abs(law(20)) < 1e-6);
    CHECK(ring_heat(preloaded(PairArrangement::back_to_back, 0.042))(20) <
          ring_heat(preloaded(PairArrangement::face_to_face, 0.042))(20));
}

TEST_CASE("the rings of a case are its journals and seats, by the side that moves or stands")
{
    auto input = starter();
    auto& journals = input.friction.at("journals");
    journals = oiled(preloaded(PairArrangement::face_to_face, 0.042));
    const auto problem = problem_of(input);
    const auto row = static_cast<std::size_t>(std::distance(input.friction.begin(), input.friction.find("journals")));
    const auto first = static_cast<int>(first_interface(input, "crank_bearing"));
    REQUIRE(problem.sources[row].inner_rings.size() == 2);
    REQUIRE(problem.sources[row].outer_rings.size() == 2);
    // The bush of the frame is side a, the crankshaft side b.
    CHECK(problem.sources[row].inner_rings[0].interface == first);
    CHECK(problem.sources[row].inner_rings[0].b);
    CHECK(!problem.sources[row].outer_rings[0].b);
    CHECK(problem.segments[0].ring_heat[row](10) > 0);

    input.joints.at("crank_bearing").interfaces[0].seat = input.joints.at("crank_bearing").interfaces[1].seat = false;
    CHECK_THROWS_WITH_AS(problem_of(input), doctest::Contains("mark its interfaces with journal = true and seat"),
                         InputError);
}

TEST_CASE("a load zone needs loads and a law with a load part")
{
    auto input = starter();
    auto& interface = input.joints.at("crank_bearing").interfaces[0];
    interface.load_zone = true;
    Observer quiet;
    CHECK(problem_of(input).segments[0].interfaces[first_interface(input, "crank_bearing")].load_zone);
    input.friction.at("journals") = oiled(casefile::SkfFriction{BearingType::cylindrical_roller, 0.08, 0.14, 0});
    CHECK_THROWS_WITH_AS(problem_of(input), doctest::Contains("friction.journals has no load part"), InputError);
}
