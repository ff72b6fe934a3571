/// Requirement: sweeps, refinement and comparison of a press give what single runs give.
#include "../../scratch_folder.hpp"
#include "deadpoint/study.hpp"
#include "near.hpp"
#include "starter.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

TEST_CASE("a sweep's runs are those of single presses, by name; one that fails says why")
{
    const auto press = starter();
    const auto runs =
        sweep(press, {{"operation.0.speed", {"40 rpm", "60 rpm"}}, {"numerics.time_tolerance", {"0.1 K", "1e-30 K"}}});
    REQUIRE(runs.size() == 4);
    CHECK(runs[2].settings[0] == std::pair<std::string, std::string>("operation.0.speed", "60 rpm"));
    REQUIRE(runs[2].result);
    auto alone = starter({"operation.0.speed=60 rpm"});
    CHECK(runs[2].result->gap().values.back() == near(alone.run().gap().values.back(), 1e-6));
    REQUIRE(runs[0].result);
    CHECK(runs[0].result->joint_heat("guide").values.back() < runs[2].result->joint_heat("guide").values.back());
    CHECK_FALSE(runs[1].result);
    CHECK(runs[1].error.find("the time step collapsed") != std::string::npos);
    CHECK_THROWS_AS(sweep(press, {{"operation.0.speed", {}}}), InputError);
}

TEST_CASE("a refinement says what it took, and leaves the press it ended with")
{
    const std::string file = std::string(DEADPOINT_SOURCE_DIR) + "/tests/verification/cases/bar.toml";
    const auto press = Press::read(file);
    auto refined = refine(press, "5 K");  // more than its elements err by
    REQUIRE(refined.rounds.size() == 2);  // the second one confirms the first
    CHECK(refined.reached);
    CHECK(refined.why_not.empty());
    CHECK_FALSE(refined.rounds[0].change);
    CHECK(*refined.rounds[1].change < 5);
    CHECK(refined.rounds[1].cells > refined.rounds[0].cells);
    CHECK(refined.rounds[1].cells == refined.result.cells);
    CHECK(refined.press.mesh().cells == static_cast<std::size_t>(refined.result.cells));
    CHECK_THROWS_AS(refine(press), InputError);
}

TEST_CASE("results are held against a reference by their names")
{
    const ScratchFolder scratch;
    auto press = starter();
    const auto result = press.run({.folder = scratch.path / "results"});
    const double rise = result.value(result.probe("slide"), 600) - result.initial_temperature;
    const auto reference = scratch.file("reference.toml", R"(format = 1
name = "made up"
source = "a test"
[[rises]]
time = "10 min"
[rises.values]
slide = "1 K"
)");
    const auto comparison = compare(scratch.path / "results", reference);
    REQUIRE(comparison.values.size() == 1);
    CHECK(comparison.values[0].unit == "K");
    CHECK(comparison.values[0].reference == near(1, 1e-5));
    CHECK(comparison.values[0].computed == near(rise, 1e-6));
    CHECK(comparison.text.find("slide") != std::string::npos);
}
