#include "deadpoint/report/run/heat_flows.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

double last(const report::CsvColumn& column) { return std::get<std::vector<double>>(column.values).back(); }

}  // namespace

TEST_CASE(
    "the air of an enclosure in the table, the summary and the text: temperatures as they are, heat of the whole press")
{
    press::RunResult result;
    result.symmetry_factor = 2;
    result.enclosures = {{"crank_case", {{{293.15, 313.15}, {0, 0}}, {0, 40}, {30, 30}, {0, 65}}}};
    std::vector<report::CsvColumn> columns;
    const auto at_steps = [](std::vector<double> values, double factor, double offset) {
        for (double& value : values)
            value = factor * value + offset;
        return values;
    };
    report::add_heat_flow_columns(
        columns, result,
        [&](const Series& series, double factor, double offset) { return at_steps(series.value, factor, offset); },
        at_steps);
    REQUIRE(columns.size() == 4);
    CHECK(columns[0].name == "air crank_case temperature");
    CHECK(columns[0].unit == "degC");
    CHECK(last(columns[0]) == near(40, 1e-5));
    CHECK(columns[1].name == "air crank_case heat from surfaces");
    CHECK(last(columns[1]) == 80);
    CHECK(last(columns[2]) == 60);
    CHECK(columns[3].name == "air crank_case heat to room");
    CHECK(last(columns[3]) == 130);
    const auto json = report::heat_flows_json(result);
    CHECK(json["enclosures"]["crank_case"]["temperature_degC"].get<double>() == near(40, 1e-5));
    CHECK(json["enclosures"]["crank_case"]["to_room_W"] == 130);
    CHECK(report::heat_flows_text(result) ==
          "  air in crank_case: 40.0 degC, 80 W from its surfaces and 60 W of its own, 130 W to the room\n");
    CHECK(report::heat_flows_json({}).is_null());
}
