/// Requirement: results that no press survives are named at the end of a run.
#include "deadpoint/study/pipeline/run_warnings.hpp"

#include "../messages.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/study/result/run_result.hpp"

#include <doctest/doctest.h>
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
    study::RunResult result;
    result.drift.emplace();
    result.drift->gap.value = {0, gap, 0};
    result.thermal.part_highest = {900, highest};
    Collected collected;
    study::warn_of_extremes(input, machine, result, collected);
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
