#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <doctest/doctest.h>
#include <limits>

using namespace deadpoint::report;

TEST_CASE("a table aligns its columns and counts letters, not bytes")
{
    TextTable table({"probe", "here [K]", "µm"});
    table.add_row({"A", "15.4", "1"});
    table.add_row({"upper", "9"});
    CHECK(table.text() == "  probe  here [K]  µm\n"
                          "  ─────  ────────  ──\n"
                          "  A          15.4   1\n"
                          "  upper         9\n");
    table.align_left(1);
    CHECK(table.text(0).find("A      15.4       1\n") != std::string::npos);
}

TEST_CASE("significant digits")
{
    CHECK(significant(15.3912) == "15.4");
    CHECK(significant(-0.012345) == "-0.0123");
    CHECK(significant(123456) == "123000");
    CHECK(significant(9.996) == "10.0");
    CHECK(significant(99.96, 2) == "100");
    CHECK(significant(0) == "0");
    CHECK(significant(1.23456e-9) == "1.23e-09");
    CHECK(significant(std::numeric_limits<double>::quiet_NaN()) == "-");
}

TEST_CASE("lengths of time")
{
    CHECK(duration_text(41.6) == "42 s");
    CHECK(duration_text(303) == "5 min 03 s");
    CHECK(duration_text(4320) == "1 h 12 min");
    CHECK(duration_text(-1) == "-");
}

TEST_CASE("ticks are round and cover the range")
{
    const auto ticks = nice_ticks(-0.7, 15.4, 6);  // 16.1 / 6 = 2.7: steps of 5
    REQUIRE(ticks.size() == 6);
    CHECK(ticks.front() == -5);
    CHECK(ticks.back() == 20);
    CHECK(nice_ticks(0, 3, 6).size() == 7);  // steps of 0.5
    CHECK(nice_ticks(2, 2, 6) == std::vector<double>{2});
}

TEST_CASE("a chart draws each line through its points, lifts the pen at gaps and marks references")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Chart chart;
    chart.title = "a < b & c";
    chart.series.push_back({.name = "one", .x = {0, 1, 2, 3}, .y = {0, 10, nan, 10}, .markers = {{3, 5}}});
    const auto svg = svg_chart(chart);
    CHECK(svg.find("a &lt; b &amp; c") != std::string::npos);
    // Both axes begin at zero, so the line starts in the lower left corner (62 from the left, 56 above the lower edge);
    // the largest value lies on the last tick (10) at the top, 74 below the upper edge.
    CHECK(svg.find("<path d=\"M62.0 424.0L") != std::string::npos);
    const auto path = svg.substr(svg.find("<path d=\"M62.0"), 60);
    CHECK(path.find(" 74.0M") != std::string::npos);
    CHECK(svg.find("<circle") != std::string::npos);
    CHECK(svg.find("cy=\"249.0\"") != std::string::npos);  // half way between 74 and 424
    CHECK(svg.find(">one</text>") != std::string::npos);
}

TEST_CASE("a chart of nothing and one of a constant are still charts")
{
    CHECK(svg_chart({}).find("</svg>") != std::string::npos);
    Chart chart;
    chart.include_zero = false;
    chart.series.push_back({"flat", {1, 1}, {7, 7}, {}});
    const auto svg = svg_chart(chart);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
}
