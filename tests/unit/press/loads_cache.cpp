/// Requirement: cases that agree in what loads depend on share them, and no others.
#include "deadpoint/press/loads/loads_cache.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <string>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::full;

namespace {

casefile::Case made_press(const std::vector<std::string>& overrides = {})
{
    return casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml", overrides).value;
}

const Machine& machine()
{
    static const Machine built = [] {
        Observer quiet;
        return prepare_machine(made_press(), 3, quiet);
    }();
    return built;
}

LoadsResult loads_of(const casefile::Case& input) { return compute_loads(input, &machine(), 0, Vibration::left_out); }

// All numbers of a turn that a law or a table reads.
std::vector<double> numbers_of(const LoadsResult& loads)
{
    std::vector<double> numbers{loads.drive.mean_power, loads.stroke.stroke, loads.throw_at_bottom};
    for (const auto& joint : loads.history.joints)
        for (std::size_t k = 0; k < joint.force.size(); ++k)
            numbers.insert(numbers.end(), {joint.force[k][0], joint.force[k][1], joint.moment[k], joint.sliding[k]});
    for (const auto& guide : loads.guides)
        numbers.push_back(guide.mean_normal);
    return numbers;
}

const std::vector<std::string> unread{
    "machine.ambient=35 degC",     "machine.initial_temperature=25 degC", "machine.name=other",
    "operation.0.duration=10 min", "numerics.time_tolerance=0.001 K",     "output.history_interval=10 s"};
const std::vector<std::string> read_by_loads{"operation.0.speed=71 rpm", "operation.0.force=123 kN",
                                             "mechanism.positions=360", "machine.gravity_direction=[0, 1, 0]"};

}  // namespace

TEST_CASE("what loads do not read changes neither them nor their key")
{
    const auto key = loads_part(made_press(), 0);
    const auto numbers = numbers_of(loads_of(made_press()));
    for (const auto& change : unread) {
        CAPTURE(change);
        CHECK(loads_part(made_press({change}), 0) == key);
        CHECK(numbers_of(loads_of(made_press({change}))) == numbers);
    }
}

TEST_CASE("what loads read changes their key")
{
    const auto key = loads_part(made_press(), 0);
    const auto numbers = numbers_of(loads_of(made_press()));
    for (const auto& change : read_by_loads) {
        CAPTURE(change);
        CHECK(loads_part(made_press({change}), 0) != key);
        CHECK(numbers_of(loads_of(made_press({change}))) != numbers);
    }
    auto preloaded = made_press();
    for (auto& [name, joint] : preloaded.joints)
        joint.preload += 100;
    CHECK(loads_part(preloaded, 0) != key);
    auto heavy = made_press();
    for (auto& [name, body] : heavy.bodies)
        body.mass = 1234;
    CHECK(loads_part(heavy, 0) != key);
    CHECK(loads_part(made_press(), 1) != key);
}

TEST_CASE("loads are computed once for equal cases, and those of the last ones are kept")
{
    LoadsCache cache(2);
    const auto get = [&](const std::string& change) {
        return cache.get(made_press({change}), &machine(), 0, Vibration::left_out);
    };
    const auto first = get("machine.ambient=20 degC");
    CHECK(get("machine.ambient=30 degC") == first);
    CHECK(cache.get(made_press(), &machine(), 0, Vibration::computed) != first);
    CHECK(numbers_of(*first) == numbers_of(loads_of(made_press())));
    const auto fast = get("operation.0.speed=71 rpm");
    CHECK(fast->speed != first->speed);
    CHECK(numbers_of(*fast) ==
          numbers_of(loads_of(made_press({"operation.0.speed=71 rpm"}))));  // on the same positions
    CHECK(get("operation.0.speed=71 rpm") == fast);
    CHECK(get("operation.0.speed=72 rpm") != fast);
    CHECK(get("operation.0.speed=71 rpm") == fast);
    CHECK(get("machine.ambient=20 degC") != first);  // two others were asked for since
}

TEST_CASE("an error of the loads is that of each case that has it")
{
    LoadsCache cache;
    auto standing = made_press();
    standing.operation[0].speed = 0;
    for (int k = 0; k < 2; ++k)
        CHECK_THROWS_AS(std::ignore = cache.get(standing, &machine(), 0, Vibration::left_out), Error);
}

TEST_CASE("friction laws that cases share are those of each case by itself")
{
    const std::string pin = "friction.pins={law=\"pin\", lubricant=\"oil\", coefficient=0.08, length=\"60 mm\", "
                            "clearance=\"45 um\", scale=";
    const std::vector<std::vector<std::string>> cases{
        {},
        {"friction.pins.scale=1.5"},
        {"friction.pins.load_part=70 W", "friction.gibs.viscous_part=0 W"},
        {"friction.pins.exponent=0.9"},
        {"friction.pins.reference_force=100 kN"},
        {"friction.pins.reference_force=100 kN", "friction.pins.reference_speed=50 rpm"},
        {"friction.pins.reference_force=100 kN", "operation.0.force=90 kN"},
        {"friction.pins.reference_force=100 kN", "joints.wrist_pin.friction=journals"},
        {"lubricants.oil.library=ISO-VG-100"},
        {pin + "1}"},
        {pin + "1.5}"},
        {pin + "1.5}", "joints.crank_pin.interfaces.0.diameter=88 mm"},
        {pin + "1.5}", "lubricants.oil.library=ISO-VG-100"}};
    LoadsCache cache;
    for (int round = 0; round < 2; ++round)
        for (const auto& change : cases) {
            CAPTURE(change);
            const auto input = made_press(change);
            const auto loads = cache.get(input, &machine(), 0, Vibration::left_out);
            FrictionLaws shared(input, &machine(), loads.get(), &cache), alone(input, &machine(), loads.get());
            for (const auto& [row, friction] : input.friction)
                for (const double speed : {input.operation[0].speed, 5.0}) {
                    auto segment = input.operation[0];
                    segment.speed = speed;
                    CAPTURE(row);
                    CHECK(shared.table(row, segment) == alone.table(row, segment));
                    const auto& heat = shared.heat(row, segment);
                    const auto& own = alone.heat(row, segment);
                    CHECK(heat.heat(310).value == own.heat(310).value);
                    // The tolerance of the table, and no other law's.
                    CHECK(shared.table(row, segment)(310).value == near(own.heat(310).value, 1e-9));
                    CHECK(heat.load_part == own.load_part);
                    CHECK(heat.load_ratio == own.load_ratio);
                    CHECK(heat.joints == own.joints);
                }
            CHECK(shared.warnings(shared.summaries()) == alone.warnings(alone.summaries()));
        }
}
