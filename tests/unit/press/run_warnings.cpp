/// Requirement: results that no press survives are named at the end of a run, and those that are no numbers end it.
#include "deadpoint/press/run/run_warnings.hpp"

#include "../messages.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>
#include <vector>

using namespace deadpoint;
using messages::has;

namespace {

class Collected : public Observer {
public:
    void warn(std::string_view text) override { texts.emplace_back(text); }
    std::vector<std::string> texts;
};

std::vector<std::string> warnings_of(double gap, double highest)
{
    Machine machine;
    machine.parts.resize(2);
    machine.parts[0].name = "bed";
    machine.parts[1].name = "bush";
    casefile::Case input;
    input.parts["bed"].initial_temperature = 900;  // a part that starts hot is meant to
    press::RunResult result;
    result.drift.emplace();
    result.drift->gap.value = {0, gap, 0};
    result.thermal.part_highest = {900, highest};
    Collected collected;
    press::finish_run(input, machine, {}, nullptr, result, collected);
    return collected.texts;
}

}  // namespace

TEST_CASE("a gap beyond 1 mm and a part above 250 degC are named, and nothing below")
{
    CHECK(warnings_of(9e-4, 523).empty());
    const auto open = warnings_of(-8.1e-3, 523);
    REQUIRE(open.size() == 1);
    CHECK(has(open.front(), "the gap E_SW changes by -8.1 mm, but presses drift by less than 1 mm"));
    const auto hot = warnings_of(2e-4, 873.15);
    REQUIRE(hot.size() == 1);
    CHECK(has(hot.front(), "part 'bush' reaches 600 degC"));
}

TEST_CASE("a result that is not finite ends the run with its name and time")
{
    const auto refused = [](auto&& set) {
        press::RunResult result;
        result.thermal.time = {0, 60};
        set(result);
        Observer quiet;
        return messages::error_of<DomainError>([&] { press::finish_run({}, {}, {}, nullptr, result, quiet); });
    };
    CHECK(refused([](auto&) {}).empty());
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        const std::vector<double> values{0, value};
        CHECK(has(refused([&](auto& r) {
                      r.probes = {{"top", {values, values}}};
                  }),
                  "the temperature of probe 'top' is not a finite number at t = 60 s\n  help: "));
        CHECK(has(refused([&](auto& r) { r.drift.emplace().gap.value = values; }), "E_SW is not a finite number"));
        CHECK(has(refused([&](auto& r) { r.joints = {{"pin", {{}, values}}}; }), "the heat of joint 'pin'"));
        CHECK(has(refused([&](auto& r) {
                      r.gaps.clearances = {{"guide", {}, {values, {}}, {}, {}}};
                  }),
                  "the clearance of 'guide'"));
        CHECK(has(refused([&](auto& r) { r.thermal.energy.stored = value; }), "the energy balance"));
    }
}
