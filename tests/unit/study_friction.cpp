/// Requirement: friction heat follows speed, process force, shaft model and stiffness as its law and the computed loads
/// say, and the shipped press keeps its published heat at the base case.
#include "deadpoint/casefile/read.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/study/prepare.hpp"
#include "deadpoint/study/translate_friction.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using doctest::Approx;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double exact = 1e-9;  // the same sums, in another order
constexpr double rpm = pi / 30;
constexpr double at_20 = 293.15;

casefile::Case press_case(const std::vector<std::string>& overrides = {}, const char* file = "case.toml")
{
    return casefile::read_case(std::string(DEADPOINT_SOURCE_DIR "/cases/jl75g-60/") + file, overrides).value;
}

/// Coarse, for the masses only; made once.
const Machine& press_machine()
{
    static const Machine machine = [] {
        Observer quiet;
        return study::prepare_machine(press_case(), 2.5, quiet);
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

study::FrictionHeat heat(const casefile::Case& input, const std::string& row, double speed = 200, double force = 3e5)
{
    study::FrictionLaws laws(input, &press_machine(), nullptr);
    return laws.heat(row, segment(speed, force));
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

std::string error_of(const auto& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("the press at its reference has the published heat")
{
    const auto input = press_case();
    study::FrictionLaws laws(input, &press_machine(), nullptr);
    // Table 5 at 20 degC: four decimals, two rows rounded to whole watts
    CHECK(laws.heat("crank_bearings", segment(200, 3e5)).heat(at_20).value == Approx(2023.66).epsilon(0.003 / 2024));
    CHECK(std::abs(laws.heat("crank_pin", segment(200, 3e5)).heat(at_20).value - 927) < 0.5);
    for (const auto& [name, row] : input.friction) {
        const auto result = laws.heat(name, segment(200, 3e5));
        CHECK(*result.load_part == Approx(row.load_part).epsilon(exact));
        CHECK(result.unloaded == (name == "guide_10"));
    }
}

TEST_CASE("without force the load parts fall by the ratio of duties, the viscous parts stay")
{
    const auto input = press_case();
    study::FrictionLaws laws(input, &press_machine(), nullptr);
    const auto full = laws.heat("crank_bearings", segment(200, 3e5));
    const auto none = laws.heat("crank_bearings", segment(200, 0));
    const auto& loaded = *laws.loads(segment(200, 3e5)).crankshaft;
    const auto& unloaded = *laws.loads(segment(200, 0)).crankshaft;
    const double ratio = rolling_duty(unloaded.flexible->bearings) / rolling_duty(loaded.flexible->bearings);
    CHECK(std::abs(ratio - 1) > 0.01);  // above 1: the short push from below relieves the bearings of the weight
    CHECK(*laws.heat("link_9_slider_10", segment(200, 0)).load_ratio < 0.9);
    CHECK(*none.load_ratio == Approx(ratio).epsilon(exact));
    CHECK(full.heat(at_20).value - none.heat(at_20).value == Approx((1 - ratio) * 149.46406).epsilon(exact));
    CHECK(none.heat(at_20).value - *none.load_part == Approx(full.heat(at_20).value - *full.load_part).epsilon(exact));
    // a row that follows no load
    CHECK(laws.heat("guide_10", segment(200, 0)).heat(at_20).value == Approx(362.23).epsilon(exact));
}

TEST_CASE("the rigid shaft and soft bearings load the bearings otherwise, and the peak measure sees more of it")
{
    const auto rigid = press_case({"crankshaft.model=rigid", "process_force.kind=elastic"});
    study::FrictionLaws laws(rigid, &press_machine(), nullptr);
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
    CHECK(*laws.heat("crank_pin", segment(200, 3e5)).load_ratio == Approx(1).epsilon(exact));

    const auto soft =
        press_case({"crankshaft.bearings.0.stiffness=5e7 N/m", "crankshaft.bearings.1.stiffness=5e7 N/m",
                    "crankshaft.bearings.2.stiffness=5e7 N/m", "crankshaft.bearings.3.stiffness=5e7 N/m"});
    CHECK(std::abs(*heat(soft, "crank_bearings").load_ratio - 1) > 1e-3);
}

TEST_CASE("friction heat grows with force and speed and rests with the press")
{
    const auto input = press_case();
    study::FrictionLaws laws(input, &press_machine(), nullptr);
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
    study::FrictionLaws laws(input, &press_machine(), nullptr);
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
    CHECK(*result.load_part == Approx(0.02 * 0.1 * coulomb).epsilon(exact));
    const double density = 870 * (1 - 7e-4 * 5);  // at 20 degC
    const double film = 2 * pi * density * 70e-6 * 1e-3 * 0.2 * square / 1e-4;
    CHECK(result.heat(at_20).value - *result.load_part == Approx(film).epsilon(1e-8));
    CHECK(laws.heat("pivot_h", segment(0, 3e5)).heat(at_20).value == 0.0);
    const auto summary = laws.summary(segment(200, 3e5));
    // without friction the drive gives what the process takes, to the quadrature of the pulse
    CHECK(summary.balance->drive == Approx(summary.balance->process).epsilon(0.02));
}

TEST_CASE("what a law lacks is said with the row's name")
{
    auto input = press_case({}, "physics.toml");
    input.lubricants.at("oil").density = 0;
    CHECK(has(error_of([&] { heat(input, "crank_pin"); }), "friction.crank_pin: the shear of an oil film needs"));
    input = press_case({}, "physics.toml");
    input.friction.at("crank_pin").length.reset();
    CHECK(has(error_of([&] { heat(input, "crank_pin"); }), "the length of the pin of joints.crank_pin is missing"));
}
