/// Requirement: a run tells friction heat row by row, its load part, and what the shaft model changes.
#include "../messages.hpp"
#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/report/heat/friction_text.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace deadpoint;
using messages::has;

namespace {

press::FrictionSummary example()
{
    press::FrictionSummary summary;
    summary.speed = 20.943951023931955;  // 200 rpm
    summary.force = 3e5;
    press::FrictionHeat row;
    row.row = "main";
    row.law = "calibrated";
    row.heat = [](double temperature) { return LawValue{temperature < 300 ? 150.0 : 110.0, -2, true}; };
    row.load_part = 40;
    row.load_ratio = 0.875;
    summary.rows.push_back(row);
    summary.bearings.push_back({"left", 1.087, 0.951});
    press::PowerBalance balance;
    balance.drive = 1200;
    balance.process = 1100;
    balance.swing = 20000;
    balance.rated = 1000;
    balance.at = {{293.15, 150, 1250, 7.162, 1.25}, {313.15, 110, 1210, 5.252, 1.21}};
    summary.balance = balance;
    return summary;
}

}  // namespace

TEST_CASE("friction text: rows, contrast of the shafts, powers")
{
    auto unstated = example();
    unstated.speed *= 2;
    unstated.bearings.clear();
    unstated.balance->at.pop_back();
    unstated.balance->at[0].share_of_motor.reset();
    const auto text = report::friction_text({example(), unstated});
    CHECK(has(text, "at 200.0 rpm and 300.0 kN"));
    CHECK(has(text, "150.0    110.0       40.0           0.875"));
    CHECK(has(text, "rigid over flexible shaft: left 1.087 by mean, 0.951 by peak"));
    CHECK(has(text, "drive 1200.0 W, process 1100.0 W (difference 0.5 % of the mean absolute power, 20000.0 W)"));
    CHECK(has(text, "at 40 degC: friction 110.0 W, 5.252 N m at the crank; motor 1210.0 W with the process, 121 % of "
                    "its 1000.0 W\n"));
    CHECK(has(text, "at 400.0 rpm and 300.0 kN"));
    CHECK(has(text, "motor 1250.0 W with the process\n"));
    CHECK(report::friction_text({}).empty());
}

TEST_CASE("friction in summary.json: load and viscous part add up to the heat")
{
    const auto list = report::friction_json({example()});
    REQUIRE(list.size() == 1);
    const auto& json = list[0];
    const auto& row = json["rows"]["main"];
    CHECK(row["20_degC"]["heat_W"] == 150.0);
    CHECK(row["20_degC"]["viscous_part_W"] == 110.0);
    CHECK(row["load_part_W"] == 40.0);
    CHECK(row["load_duty_over_reference"] == 0.875);
    CHECK(json["power_W"]["drive_less_process"] == 100.0);
    CHECK(json["power_W"]["mismatch"] == 0.005);
    CHECK(json["power_W"]["with_friction"]["20_degC"]["motor"] == 1250.0);
    CHECK(json["power_W"]["with_friction"]["40_degC"]["share_of_motor"] == 1.21);
    CHECK(json["load_part_rigid_over_flexible"]["left"]["by_peak"] == 0.951);
}
