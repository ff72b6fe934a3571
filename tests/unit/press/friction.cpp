/// Requirement: friction heat follows speed, process force, shaft model and stiffness as its law and the computed loads
/// say, and the shipped press keeps its published heat at the base case.
#include "deadpoint/press/laws/friction.hpp"

#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/warning.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/tribology/friction/ball_bearing.hpp"
#include "deadpoint/tribology/friction/load_zone.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using messages::error_of;
using messages::has;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double exact = 1e-9;  // the same sums, in another order
constexpr double rpm = pi / 30;
constexpr double at_20 = 293.15;
constexpr double density_at_20 = 870 * (1 - 7e-4 * 5);  // of the oil in physics.toml [kg/m3]

casefile::Case press_case(const std::vector<std::string>& overrides = {}, const char* file = "case.toml")
{
    return casefile::read_case(std::string(DEADPOINT_SOURCE_DIR "/cases/jl75g-60/") + file, overrides).value;
}

/// Coarse, for the masses only; made once.
const Machine& press_machine()
{
    static const Machine machine = [] {
        Observer quiet;
        return full::prepare_machine(press_case(), 2.5, quiet);
    }();
    return machine;
}

casefile::Segment segment(double speed, double force)
{
    casefile::Segment s;
    s.speed = speed * rpm;
    s.force = force;
    return s;
}

press::FrictionHeat heat(const casefile::Case& input, const std::string& row, double speed = 200, double force = 3e5)
{
    press::FrictionLaws laws(input, &press_machine(), nullptr);
    return laws.heat(row, segment(speed, force));
}

/// Loads of the case with laws from first principles at 200 rpm and 300 kN; no friction law changes them.
const press::LoadsResult& physics_loads()
{
    static const auto loads = [] {
        auto input = press_case({}, "physics.toml");
        input.operation = {segment(200, 3e5)};
        return press::compute_loads(input, &press_machine(), 0);
    }();
    return loads;
}

/// A joint of the press and its image over the turn.
std::vector<const JointCycle*> cycles(const std::string& joint)
{
    const auto& loads = physics_loads();
    std::vector<const JointCycle*> result;
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (loads.linkage.joints[j].name.starts_with(joint))
            result.push_back(&loads.history.joints[j]);
    return result;
}

/// Mean over the turn of a function of force and relative speed; all samples weigh the same at even speed.
double mean_of(const JointCycle& cycle, const auto& function)
{
    double sum = 0;
    for (std::size_t i = 0; i < cycle.force.size(); ++i)
        sum += function(norm(cycle.force[i]), std::abs(cycle.sliding[i])) / static_cast<double>(cycle.force.size());
    return sum;
}

double rolling_duty(const std::vector<BearingCycle>& bearings)
{
    double sum = 0;
    for (const auto& bearing : bearings) {
        double mean = 0;
        for (const auto& force : bearing.force)
            mean += std::pow(norm(force), 1.33) / static_cast<double>(bearing.force.size());
        sum += mean;
    }
    return sum;
}

}  // namespace

TEST_CASE("the press at its reference has the published heat")
{
    const auto input = press_case();
    press::FrictionLaws laws(input, &press_machine(), nullptr);
    // Table 5 at 20 degC: four decimals, two rows rounded to whole watts
    CHECK(laws.heat("crank_bearings", segment(200, 3e5)).heat(at_20).value == near(2023.66, 0.003 / 2024));
    CHECK(std::abs(laws.heat("crank_pin", segment(200, 3e5)).heat(at_20).value - 927) < 0.5);
    for (const auto& [name, row] : input.friction) {
        const auto result = laws.heat(name, segment(200, 3e5));
        CHECK(*result.load_part == near(std::get<casefile::CalibratedFriction>(row.law).load_part, exact));
        CHECK(result.unloaded == (name == "guide_10"));
    }
}

TEST_CASE("without force the load parts fall by the ratio of duties, the viscous parts stay")
{
    const auto input = press_case();
    press::FrictionLaws laws(input, &press_machine(), nullptr);
    const auto full = laws.heat("crank_bearings", segment(200, 3e5));
    const auto none = laws.heat("crank_bearings", segment(200, 0));
    const auto& loaded = *laws.loads(segment(200, 3e5)).crankshaft;
    const auto& unloaded = *laws.loads(segment(200, 0)).crankshaft;
    const double ratio = rolling_duty(unloaded.flexible->bearings) / rolling_duty(loaded.flexible->bearings);
    CHECK(std::abs(ratio - 1) > 0.01);  // above 1: the short push from below relieves the bearings of the weight
    CHECK(*laws.heat("link_9_slider_10", segment(200, 0)).load_ratio < 0.9);
    CHECK(*none.load_ratio == near(ratio, exact));
    CHECK(full.heat(at_20).value - none.heat(at_20).value ==
          near((1 - ratio) * std::get<casefile::CalibratedFriction>(input.friction.at("crank_bearings").law).load_part,
               exact));
    CHECK(none.heat(at_20).value - *none.load_part == near(full.heat(at_20).value - *full.load_part, exact));
    // a row that follows no load
    CHECK(laws.heat("guide_10", segment(200, 0)).heat(at_20).value == near(362.23, exact));
}

TEST_CASE("the rigid shaft and soft bearings load the bearings otherwise, and the peak measure sees more of it")
{
    const auto rigid = press_case({"crankshaft.model=rigid", "process_force.kind=elastic"});
    press::FrictionLaws laws(rigid, &press_machine(), nullptr);
    const auto summary = laws.summary(segment(200, 3e5));
    REQUIRE(summary.bearings.size() == 4);
    CHECK_FALSE(summary.same_loads);
    const auto row = laws.heat("crank_bearings", segment(200, 3e5));
    CHECK(std::abs(*row.load_ratio - 1) > 1e-3);
    const auto peak = heat(press_case({"crankshaft.model=rigid", "process_force.kind=elastic",
                                       "friction.crank_bearings.load_measure=peak"}),
                           "crank_bearings");
    CHECK(std::abs(*peak.load_ratio - *row.load_ratio) > 1e-3);
    // pins see the same force under the same course of the process
    CHECK(*laws.heat("crank_pin", segment(200, 3e5)).load_ratio == near(1, exact));

    const auto soft =
        press_case({"crankshaft.bearings.0.stiffness=5e7 N/m", "crankshaft.bearings.1.stiffness=5e7 N/m",
                    "crankshaft.bearings.2.stiffness=5e7 N/m", "crankshaft.bearings.3.stiffness=5e7 N/m"});
    CHECK(std::abs(*heat(soft, "crank_bearings").load_ratio - 1) > 1e-3);
}

TEST_CASE("friction heat grows with force and speed and rests with the press")
{
    const auto input = press_case();
    press::FrictionLaws laws(input, &press_machine(), nullptr);
    for (const auto& [name, row] : input.friction) {
        const auto at = [&](double speed, double force) {
            return laws.heat(name, segment(speed, force)).heat(at_20).value;
        };
        CHECK(at(0, 3e5) == 0.0);
        CHECK(at(400, 3e5) > at(200, 3e5));
    }
    const auto total = [&](double force) {
        double sum = 0;
        for (const auto& [name, row] : input.friction)
            sum += laws.heat(name, segment(200, force)).heat(at_20).value;
        return sum;
    };
    CHECK(total(1.5e5) > total(0));
    CHECK(total(3e5) > total(1.5e5));
}

TEST_CASE("a pin from first principles: Coulomb and Petroff by hand")
{
    const auto input = press_case({}, "physics.toml");
    press::FrictionLaws laws(input, &press_machine(), nullptr);
    const auto& loads = laws.loads(segment(200, 3e5));
    const auto result = laws.heat("crank_pin", segment(200, 3e5));
    const auto& joints = loads.linkage.joints;
    const auto j =
        static_cast<std::size_t>(std::ranges::find(joints, "crank_pin", &LinkageJoint::name) - joints.begin());
    const auto& cycle = loads.history.joints[j];
    double coulomb = 0, square = 0;  // the press runs evenly, so all samples weigh the same
    const auto count = static_cast<double>(cycle.force.size());
    for (std::size_t i = 0; i < cycle.force.size(); ++i) {
        coulomb += norm(cycle.force[i]) * std::abs(cycle.sliding[i]) / count;
        square += cycle.sliding[i] * cycle.sliding[i] / count;
    }
    CHECK(*result.load_part == near(0.02 * 0.1 * coulomb, exact));
    const double film = 2 * pi * density_at_20 * 70e-6 * 1e-3 * 0.2 * square / 1e-4;
    CHECK(result.heat(at_20).value - *result.load_part == near(film, 1e-8));
    CHECK(laws.heat("pivot_h", segment(0, 3e5)).heat(at_20).value == 0.0);
    const auto summary = laws.summary(segment(200, 3e5));
    CHECK(summary.balance->mismatch() < press::power_tolerance);
}

TEST_CASE("a swinging pin and its image: Coulomb and Petroff at the true relative speed")
{
    const auto input = press_case({}, "physics.toml");
    press::FrictionLaws laws(input, &press_machine(), &physics_loads());
    const auto result = laws.heat("pivot_p18", segment(200, 3e5));
    double coulomb = 0, square = 0;
    const auto found = cycles("pivot_p18");
    REQUIRE(found.size() == 2);
    for (const JointCycle* cycle : found) {
        coulomb += mean_of(*cycle, [](double force, double speed) { return force * speed; });
        square += mean_of(*cycle, [](double, double speed) { return speed * speed; });
    }
    CHECK(*result.load_part == near(0.02 * 0.06 * coulomb, exact));
    const double film = 2 * pi * density_at_20 * 70e-6 * std::pow(0.06, 3) * 0.12 * square / 0.06e-3;
    CHECK(result.heat(at_20).value - *result.load_part == near(film, 1e-8));
    // it swings by a few degrees: a pin that turns with the crank would shear its film hundreds of times as much
    CHECK(std::pow(200 * rpm, 2) / (square / 2) > 100);
}

TEST_CASE("a guide pressed by its gibs: friction on both faces and shear of the film by hand")
{
    const auto input = press_case({}, "physics.toml");
    press::FrictionLaws laws(input, &press_machine(), &physics_loads());
    const auto result = laws.heat("guide_10", segment(200, 3e5));
    const auto found = cycles("guide_10");
    REQUIRE(found.size() == 1);
    const double speed = mean_of(*found[0], [](double, double v) { return v; });
    const double square = mean_of(*found[0], [](double, double v) { return v * v; });
    CHECK(*result.load_part == near(0.05 * 2 * 2e3 * speed, exact));  // no side force by symmetry
    const double film = density_at_20 * 70e-6 * 0.2596 * square / 50e-6;
    CHECK(result.heat(at_20).value - *result.load_part == near(film, 1e-8));
}

TEST_CASE("the crankshaft's bearings by SKF: the catalogue's formulas at every instant")
{
    const auto input =
        press_case({"friction.crank_bearings={ law = \"skf\", lubricant = \"oil\", bearing = \"angular_contact_ball\", "
                    "bore = \"170 mm\", outside_diameter = \"260 mm\", axial_preload = \"1500 N\" }"},
                   "physics.toml");
    press::FrictionLaws laws(input, &press_machine(), &physics_loads());
    const auto result = laws.heat("crank_bearings", segment(200, 3e5));
    CHECK_FALSE(result.load_part);
    // N, mm, rpm and mm2/s, as printed in the catalogue; 70 mm2/s at 20 degC
    constexpr double dm = 215, n = 200, nu = 70, axial = 1500;
    const double heating = 1 / (1 + 1.84e-9 * std::pow(n * dm, 1.28) * std::pow(nu, 0.64));
    const double starving = std::exp(-3e-8 * nu * n * (170 + 260) * std::sqrt(4.4 / (2.0 * (260 - 170))));
    const double boundary = std::exp(-2.6e-8 * std::pow(n * nu, 1.4) * dm);
    const double lift = std::pow(dm, 4) * n * n;
    double expected = 0;
    for (const auto& bearing : physics_loads().crankshaft->cycle().bearings) {
        for (const auto& force : bearing.force) {
            const double rolling =
                5.03e-7 * std::pow(dm, 1.97) * std::pow(norm(force) + 1.9e-12 * lift + 1.97 * axial, 0.54);
            const double sliding = 1.3e-2 * std::pow(dm, 0.26) *
                                   (std::pow(norm(force) + 1.91e-12 * lift, 4.0 / 3) + 0.68 * std::pow(axial, 4.0 / 3));
            const double torque = heating * starving * rolling * std::pow(nu * n, 0.6) +
                                  sliding * (0.15 * boundary + 0.05 * (1 - boundary));
            expected += 1e-3 * torque * n * rpm / static_cast<double>(bearing.force.size());
        }
    }
    CHECK(result.heat(at_20).value == near(expected, 1e-8));
}

TEST_CASE("the crankshaft's bearings by Palmgren with spin: torques and load by hand, spin as F^(4/3)")
{
    const std::string sizes =
        "law = \"palmgren\", lubricant = \"oil\", bearing = \"angular_contact_ball_pair\", mean_diameter = \"215 mm\", "
        "static_rating = \"220 kN\", contact_angle = \"25 deg\", lubrication_factor = 6.5";
    const auto heat_of = [&](const std::string& more) {
        const auto input = press_case({"friction.crank_bearings={ " + sizes + more + " }"}, "physics.toml");
        press::FrictionLaws laws(input, &press_machine(), &physics_loads());
        return laws.heat("crank_bearings", segment(200, 3e5));
    };
    const auto rolling = heat_of("");
    const auto spinning = heat_of(", balls = 22, ball_diameter = \"24 mm\", osculation = 0.53, spin_friction = 0.05");
    const auto& bearings = physics_loads().crankshaft->cycle().bearings;
    const double speed = 200 * rpm;
    // four bearings: f1 = 0.001 (F/C0)^0.33 and M0 = 1e-7 f0 (nu n)^(2/3) dm^3 N mm
    const double load = 0.001 * 0.215 * std::pow(220e3, -0.33) * rolling_duty(bearings) * speed;
    CHECK(*rolling.load_part == near(load, exact));
    const double viscous = 4 * 1e-10 * 6.5 * std::pow(70 * 200, 2.0 / 3) * std::pow(215, 3) * speed;
    CHECK(rolling.heat(at_20).value - *rolling.load_part == near(viscous, 1e-8));

    tribology::BallBearing balls;
    balls.balls = 22;
    balls.rows = 2;
    balls.ball_diameter = 0.024;
    balls.pitch_diameter = 0.215;
    balls.contact_angle = 25 * pi / 180;
    balls.inner_osculation = balls.outer_osculation = 0.53;
    const double torque = tribology::spin_torque(balls, 0.05, tribology::spread_load(balls, 1e4, {}));
    double duty = 0;
    for (const auto& bearing : bearings)
        for (const auto& force : bearing.force)
            duty += std::pow(norm(force) / 1e4, 4.0 / 3) / static_cast<double>(bearing.force.size());
    const double spin = spinning.heat(at_20).value - rolling.heat(at_20).value;
    CHECK(spin == near(torque * duty * speed, 1e-8));
    CHECK(*spinning.load_part - *rolling.load_part == near(spin, 1e-8));
}

TEST_CASE("what a law lacks is said with the key that lacks it")
{
    auto input = press_case({}, "physics.toml");
    input.lubricants.at("oil").density = 0;
    CHECK(has(error_of([&] { heat(input, "crank_pin"); }), "lubricants.oil: the shear of an oil film needs"));
    input = press_case({}, "physics.toml");
    std::get<casefile::PinFriction>(input.friction.at("crank_pin").law).length.reset();
    CHECK(has(error_of([&] { heat(input, "crank_pin"); }), "the length of the pin of joints.crank_pin is missing"));
}

namespace {

/// A vertical slider-crank: throw 40 mm, rod 300 mm, the wrist 60 mm above the middle of the guide.
casefile::Case slider_crank()
{
    auto input = casefile::read_case(DEADPOINT_TEST_DATA "/study/balanced-crank.toml", {}).value;
    auto& friction = input.friction["gib"];
    friction.law = casefile::GuideFriction{0.05, {}, {}};
    input.joints.at("guide").friction = "gib";
    return input;
}

std::vector<std::string> texts(const std::vector<Warning>& warnings)
{
    std::vector<std::string> result;
    for (const auto& warning : warnings)
        result.push_back(warning.text);
    return result;
}

bool any_has(const std::vector<std::string>& texts, const std::string& piece)
{
    return std::ranges::any_of(texts, [&](const auto& text) { return has(text, piece); });
}

}  // namespace

TEST_CASE("a guide under an eccentric force: both ends by hand, alike in heat, figures and load ratio")
{
    auto input = slider_crank();
    for (const auto* body : {"rod", "slide"})
        input.bodies.at(body).mass = input.bodies.at(body).inertia = 0;
    input.crankshaft.reset();
    auto& process = input.process_force.emplace();
    process.kind = casefile::ProcessForce::Kind::rectangular;
    process.from = 1.25 * pi;
    process.to = 1.75 * pi;
    process.offset = 0.03;
    const double preload = input.joints.at("guide").preload, length = 0.2;
    REQUIRE(preload == 500);

    const auto without = press::compute_loads(input, nullptr, 0);
    CHECK(any_has(texts(without.warnings), "guide 'guide' carries a moment of up to"));
    CHECK(any_has(texts(without.warnings), "state joints.guide.guide_length"));
    input.joints.at("guide").guide_length = length;
    const auto loads = press::compute_loads(input, nullptr, 0);
    CHECK_FALSE(any_has(texts(loads.warnings), "guide 'guide' carries a moment"));

    const auto& history = loads.history;
    const auto count = static_cast<double>(history.time.size());  // the speed is steady: all weigh the same
    double mean = 0, rubbed = 0, flat = 0, largest = 0;
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        const double past = history.angle[i] - history.angle[0];
        const double aside = 0.04 * std::sin(past);
        const double lean = aside / std::sqrt(0.3 * 0.3 - aside * aside);  // of the rod, which has no mass
        const double force = history.process_force[i];
        const double side = std::abs(force * lean);
        const double moment = std::abs(force * (0.03 + 0.06 * lean));
        const double normal =
            std::max(preload, side / 2 + moment / length) + std::max(preload, std::abs(side / 2 - moment / length));
        mean += normal / count;
        rubbed += 0.05 * normal * std::abs(history.slide_speed[i]) / count;
        flat += std::max(2 * preload, side) / count;
        largest = std::max(largest, moment);
    }
    CHECK(largest > 600);  // 20 kN, 30 mm off and more
    REQUIRE(loads.guides.size() == 1);
    CHECK(loads.guides[0].peak_moment == near(largest, exact));
    CHECK(loads.guides[0].mean_normal == near(mean, exact));
    CHECK(without.guides[0].mean_normal == near(flat, exact));
    CHECK(mean > 1.2 * flat);
    press::FrictionLaws laws(input, nullptr, &loads);
    CHECK(laws.heat("gib", input.operation[0]).heat(at_20).value == near(rubbed, exact));
    // calibrated: the load part follows the same duty, here over that without the moment at the reference
    auto& gib = input.friction.at("gib").law.emplace<casefile::CalibratedFriction>();
    gib.kind = FrictionKind::guide;
    gib.load_part = 100;
    gib.reference_speed = input.operation[0].speed;
    gib.reference_force = 0;
    press::FrictionLaws calibrated(input, nullptr, &loads);
    double idle = 0;
    for (const double speed : history.slide_speed)
        idle += 0.05 * 2 * preload * std::abs(speed) / count;
    CHECK(*calibrated.heat("gib", input.operation[0]).load_ratio == near(rubbed / idle, exact));
}

TEST_CASE("power: the drive gives the work of the process, friction comes on top and may exceed the motor")
{
    auto input = slider_crank();
    auto& process = input.process_force.emplace();
    process.kind = casefile::ProcessForce::Kind::travel_table;
    process.over_height = {{0, 0.01}, {1, 0}};
    auto& belt = input.crankshaft->belt.emplace();
    belt.power = 510;
    belt.pulley_diameter = 0.4;
    input.machine.initial_temperature = 283.15;
    press::FrictionLaws laws(input, nullptr, nullptr);
    const auto summaries = laws.summaries();
    REQUIRE(summaries.size() == 1);
    const auto& balance = *summaries[0].balance;
    // 20 kN falling to 0 over 10 mm, five times a second; the end of the push falls between two of 720 positions.
    CHECK(balance.process == near(0.5 * 2e4 * 0.01 * 5, 1e-3));
    CHECK(balance.mismatch() < press::power_tolerance);
    REQUIRE(balance.at.size() == 2);
    CHECK(balance.at[0].temperature == 283.15);
    CHECK(balance.at[1].temperature == 313.15);
    const double friction = summaries[0].rows[0].heat(283.15).value;
    // The side force stays within the preload of both faces: mu 1 kN over four throws per turn, 720 positions.
    CHECK(friction == near(0.05 * 1000 * 4 * 0.04 * 5, 1e-4));
    CHECK(balance.at[0].friction == friction);
    CHECK(balance.at[0].motor == near(balance.process + friction, 1e-5));
    CHECK(balance.at[0].torque == near(friction / (300 * rpm), 1e-5));
    CHECK(*balance.at[0].share_of_motor == near((balance.process + friction) / 510, 1e-5));
    CHECK(any_has(laws.warnings(summaries), "but crankshaft.belt.power is 510 W"));

    input.crankshaft->belt->power = 5000;
    press::FrictionLaws strong(input, nullptr, nullptr);
    CHECK_FALSE(any_has(strong.warnings(strong.summaries()), "crankshaft.belt.power"));
}

TEST_CASE("every speed and force is summed up once, and what their loads warn about is passed on once")
{
    auto input = slider_crank();
    auto& process = input.process_force.emplace();
    process.kind = casefile::ProcessForce::Kind::rectangular;
    process.from = 0;
    process.to = 1;
    auto segment_of = [&](double speed, double force) {
        auto each = input.operation[0];
        each.speed = speed * rpm;
        each.force = force;
        return each;
    };
    input.operation = {segment_of(300, 0), segment_of(0, 0), segment_of(300, 2e4), segment_of(300, 0),
                       segment_of(200, 3e4)};
    const auto known = press::compute_loads(input, nullptr, 0);
    CHECK_FALSE(any_has(texts(known.warnings), "past bottom dead point"));
    press::FrictionLaws laws(input, nullptr, &known);
    const auto summaries = laws.summaries();
    REQUIRE(summaries.size() == 3);
    CHECK(summaries[2].speed == near(200 * rpm, 1e-5));
    CHECK(summaries[2].force == 3e4);
    const auto warnings = laws.warnings(summaries);
    const auto said =
        std::ranges::count_if(warnings, [](const auto& text) { return has(text, "the process force acts at"); });
    CHECK(said == 1);
    CHECK(any_has(warnings, "at 300 rpm and 20 kN: the process force acts at"));
}

TEST_CASE("the table of a friction law is the law within its tolerance")
{
    // 1e-10 between the points of a table; a tenth of that besides for rounding of the sums.
    const auto near_law = [](const casefile::Case& input, double speed) {
        press::FrictionLaws laws(input, &press_machine(), nullptr);
        for (const auto& [row, friction] : input.friction) {
            const auto table = laws.table(row, segment(speed, 2e5));
            const auto& law = laws.heat(row, segment(speed, 2e5)).heat;
            for (double at = 255; at < 420; at += 0.173) {
                CAPTURE(row);
                CAPTURE(at);
                CHECK(table(at).value == near(law(at).value, 1.1e-10));
            }
        }
    };
    const auto at_rest = press_case({});
    press::FrictionLaws resting(at_rest, &press_machine(), nullptr);
    CHECK_FALSE(resting.table("crank_pin", segment(0, 2e5)));
    for (const double speed : {120.0, 200.0}) {
        near_law(press_case({"friction.crank_pin.scale=1.7", "friction.crank_bearings.scale=0.6"}), speed);
        near_law(press_case({"friction.crank_pin.scale=1.7"}, "physics.toml"), speed);
    }
}
