#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/report/run/gaps_files.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

Series line(double rate, const std::vector<double>& time)
{
    Series series;
    for (const double t : time) {
        series.value.push_back(rate * t);
        series.rate.push_back(rate);
    }
    return series;
}

// Two corners 0.4 m apart, a guide and a pin, and a gap that closes by 1 um a second.
struct Fixture {
    casefile::Case input;
    press::GapModel model;
    ThermalHistory history;

    Fixture()
    {
        input.chain.emplace();
        input.chain->press_stiffness = 2e9;
        input.joints["guide"].clearance = 50e-6;
        input.joints["pin"];
        model.mirrored = true;
        model.corners = {{"front left", -0.3, -0.2, {}}, {"back left", -0.3, 0.2, {}}};
        model.clearances = {{"guide", ClearanceSeries::Kind::guide, "guide"},
                            {"pin", ClearanceSeries::Kind::bearing, "pin"}};
        history.time = {0, 10, 30, 100};
        history.functionals.assign(drift::dimension_count, line(0, history.time));
        history.functionals[drift::gap] = line(-1.1e-6, history.time);
        for (const double rate : {-1.2e-6, -0.8e-6, -2e-6, 3e-7})
            history.functionals.push_back(line(rate, history.time));
    }
    // The crank's play opens the gap by 0.1 um a second.
    [[nodiscard]] GapSeries series() const
    {
        DriftSeries drift;
        drift.gap = line(-1e-6, history.time);
        drift.play = line(1e-7, history.time);
        return press::gap_series(input, model, history, drift::dimension_count, drift);
    }
};

}  // namespace

TEST_CASE("corners of a half model have their mirror images, and slopes are differences over distances")
{
    const auto gaps = Fixture().series();
    REQUIRE(gaps.parallelism);
    const auto& corners = gaps.parallelism->corners;
    REQUIRE(corners.size() == 4);
    CHECK(corners[1].name == "front right");
    CHECK(corners[1].x == 0.3);
    CHECK(corners[3].name == "back right");
    CHECK(corners[3].gap.value.back() == near(-70e-6, 1e-5));
    // (-80 - (-120)) um over 0.4 m at the end
    CHECK(gaps.parallelism->front_back.value.back() == near(100e-6, 1e-5));
    CHECK(gaps.parallelism->front_back.rate.back() == near(1e-6, 1e-5));
    CHECK(gaps.parallelism->left_right.value.back() == 0);
}

TEST_CASE("the force rises by the stiffness of the press as the gap closes")
{
    auto fixture = Fixture();
    CHECK(fixture.series().force->value.back() == near(2e9 * 100e-6, 1e-5));
    fixture.input.chain->press_stiffness.reset();
    CHECK_FALSE(fixture.series().force);
}

TEST_CASE("a stated clearance is used up when its change has eaten it, and said to be")
{
    const auto gaps = Fixture().series();
    REQUIRE(gaps.clearances.size() == 2);
    // 50 um at 2 um/s
    CHECK(gaps.clearances[0].used_up.value() == near(25, 1e-5));
    CHECK_FALSE(gaps.clearances[1].initial);
    CHECK_FALSE(gaps.clearances[1].used_up);
    const auto warnings = press::gap_warnings(gaps);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].starts_with("the clearance of 50 um of 'guide' is used up 0.01 h after the start"));
    auto wide = Fixture();
    wide.input.joints["guide"].clearance = 201e-6;
    CHECK_FALSE(wide.series().clearances[0].used_up);
    CHECK(press::gap_warnings(wide.series()).empty());
}

TEST_CASE("gaps in files and text: units, signs, what is not followed is left out")
{
    const auto fixture = Fixture();
    const auto gaps = fixture.series();
    const auto columns = report::gap_columns(gaps, [](const Series& series, double factor, double) {
        return std::vector<double>{factor * series.value.back()};
    });
    const std::vector<std::tuple<std::string, std::string, double>> wanted{
        {"gap front left", "um", -110},  {"gap front right", "um", -110},    {"gap back left", "um", -70},
        {"gap back right", "um", -70},   {"slope left to right", "um/m", 0}, {"slope front to back", "um/m", 100},
        {"clearance guide", "um", -200}, {"clearance pin", "um", 30},        {"force change", "kN", 200}};
    REQUIRE(columns.size() == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto& [name, unit, value] = wanted[i];
        CHECK(columns[i].name == name);
        CHECK(columns[i].unit == unit);
        CHECK(std::get<std::vector<double>>(columns[i].values).front() == near(value, 1e-5));
    }
    const auto json = report::gaps_json(gaps, fixture.history.time);
    CHECK(json["parallelism"]["corners"]["front left"]["largest_um"].get<double>() == near(-110, 1e-5));
    CHECK(json["clearances"][0]["least_um"].get<double>() == near(-150, 1e-5));
    CHECK(json["clearances"][0]["used_up_s"].get<double>() == near(25, 1e-5));
    CHECK_FALSE(json["clearances"][1].contains("initial_um"));
    CHECK(json["force"]["largest_kN"].get<double>() == near(200, 1e-5));
    CHECK(report::gaps_text(gaps, fixture.history.time) ==
          "  slide against table at the end: left to right +0.0 um/m, front to back +100.0 um/m\n"
          "  clearances that close most at the end: guide -200.0 (least -150.0 of 50.0), pin +30.0 um\n"
          "  force at a fixed die height: +200.0 kN at most, after 1 min 40 s, +200.0 kN at the end\n");
    CHECK(report::gaps_json({}, fixture.history.time).is_null());
    CHECK(report::gaps_text({}, fixture.history.time).empty());
}
