/// Requirement: a run tells friction heat row by row, its load part, and what the shaft model changes.
#include "deadpoint/report/friction_text.hpp"
#include "messages.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace deadpoint;
using messages::has;

namespace {

study::FrictionSummary example()
{
    study::FrictionSummary summary;
    summary.speed = 20.943951023931955;  // 200 rpm
    summary.force = 3e5;
    study::FrictionHeat row;
    row.row = "main";
    row.law = "calibrated";
    row.heat = [](double temperature) { return LawValue{temperature < 300 ? 150.0 : 110.0, -2, true}; };
    row.load_part = 40;
    row.load_ratio = 0.875;
    summary.rows.push_back(row);
    summary.bearings.push_back({"left", 1.087, 0.951});
    summary.balance = study::PowerBalance{1200, 1100, 110, 313.15};
    return summary;
}

}  // namespace

TEST_CASE("friction text: rows, contrast of the shafts, powers")
{
    const auto text = report::friction_text(example());
    CHECK(has(text, "at 200.0 rpm and 300.0 kN"));
    CHECK(has(text, "150.0    110.0       40.0           0.875"));
    CHECK(has(text, "rigid over flexible shaft: left 1.087 by mean, 0.951 by peak"));
    CHECK(has(text, "drive less process +100.0 W"));
    CHECK(has(text, "friction of all joints 110.0 W at 40 degC"));
}

TEST_CASE("friction in summary.json: load and viscous part add up to the heat")
{
    const auto json = nlohmann::json::parse(report::friction_json(example()));
    const auto& row = json["rows"]["main"];
    CHECK(row["20_degC"]["heat_W"] == 150.0);
    CHECK(row["20_degC"]["viscous_part_W"] == 110.0);
    CHECK(row["load_part_W"] == 40.0);
    CHECK(row["load_duty_over_reference"] == 0.875);
    CHECK(json["power_W"]["drive_less_process"] == 100.0);
    CHECK(json["load_part_rigid_over_flexible"]["left"]["by_peak"] == 0.951);
}
