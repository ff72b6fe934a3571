/// Files, pictures and text of the loads, on a slider-crank that is solved in milliseconds.
#include "deadpoint/press/loads/loads.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/loads/linkage_drawing.hpp"
#include "deadpoint/report/loads/loads_charts.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct Solved {
    casefile::Case input;
    press::LoadsResult loads;
};

const Solved& solved()
{
    static const Solved result = [] {
        auto input = casefile::read_case(fs::path(DEADPOINT_TEST_DATA) / "study/balanced-crank.toml",
                                         {"crankshaft.model=flexible"})
                         .value;
        auto loads = press::compute_loads(input, nullptr, 0);
        return Solved{std::move(input), std::move(loads)};
    }();
    return result;
}

std::size_t count(const std::string& text, const std::string& piece)
{
    std::size_t found = 0;
    for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1))
        ++found;
    return found;
}

std::string content(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

}  // namespace

TEST_CASE("the drawing shows every joint, guide and body at every position")
{
    const auto& loads = solved().loads;
    const auto svg = report::linkage_svg("press", loads);
    CHECK(count(svg, "<circle") == 5 * 3);                                // three pins in five panels
    CHECK(count(svg, "stroke=\"#8a8a8a\" stroke-width=\"1\"") == 5 * 2);  // two faces of one guide
    CHECK(count(svg, ">bottom dead point<") == 1);
    for (const char* name : {">crank<", ">rod<", ">slide<"})
        CHECK(count(svg, name) == 1);
    CHECK(count(svg, ">frame<") == 0);
    CHECK(count(svg, "nan") == 0);
    CHECK_THROWS_AS(report::linkage_drawing("press", loads.linkage, CycleHistory{}, {0}), InputError);
    CHECK_THROWS_AS(report::linkage_drawing("press", loads.linkage, loads.history, {}), InputError);
}

TEST_CASE("charts have bottom dead point in the middle and ticks at round angles")
{
    const auto& loads = solved().loads;
    for (const auto& svg : {report::slide_motion_svg("press", loads), report::joint_forces_svg("press", loads),
                            report::bearing_loads_svg("press", loads)}) {
        CHECK(count(svg, ">\u2212180<") >= 1);
        CHECK(count(svg, ">180<") >= 1);
        CHECK(count(svg, ">45<") >= 1);
        CHECK(count(svg, "nan") == 0);
    }
    CHECK(count(report::slide_motion_svg("press", loads), "<svg") == 4);  // three inside one
    const auto bearings = report::bearing_loads_svg("press", loads);
    CHECK(count(bearings, ">bearing_1<") == 2);  // x and y
    CHECK(count(bearings, ">bearing_1, rigid<") == 2);
    CHECK(count(report::campbell_svg("press", loads), ">1x<") == 1);
    auto without = loads;
    without.crankshaft.reset();
    CHECK_THROWS_AS(report::campbell_svg("press", without), InputError);
}

TEST_CASE("joints come by falling peak")
{
    const auto& loads = solved().loads;
    const auto order = report::joints_by_peak(loads);
    CHECK(order.size() == loads.linkage.joints.size());
    for (std::size_t i = 1; i < order.size(); ++i)
        CHECK(report::peak_force(loads.history.joints[order[i - 1]]) >=
              report::peak_force(loads.history.joints[order[i]]));
}

TEST_CASE("loads.json and the tables hold what was computed")
{
    const auto& [input, loads] = solved();
    const fs::path folder = fs::temp_directory_path() / ("deadpoint-loads-" + std::to_string(std::random_device{}()));
    fs::create_directories(folder);
    report::write_loads_files(folder, input, loads, {"a warning"});
    const auto json = nlohmann::json::parse(content(folder / "loads.json"));
    CHECK(json["slide"]["stroke_mm"].get<double>() == near(80, 1e-12));
    CHECK(json["operation"]["speed_rpm"].get<double>() == near(300, 1e-5));
    CHECK(json["warnings"] == nlohmann::json({"a warning"}));
    CHECK(json["bodies"]["rod"]["from"] == "stated");
    CHECK(json["joints"]["pin"]["force_N"]["peak"].get<double>() ==
          report::peak_force(loads.history.joints[2]));  // joints in the order of their names
    CHECK(json["guides"]["guide"]["preload_per_face_N"] == 500);
    CHECK(json["crankshaft"]["rigid"]["bearings"]["bearing_1"]["peak_N"].get<double>() ==
          loads.crankshaft->rigid.bearings[0].peak);
    CHECK(json["crankshaft"]["modes_at_speed"].size() == loads.crankshaft->modes.size());
    CHECK(json["crankshaft"]["unbalance_response_at_speed"]["largest_deflection_um"].get<double>() > 0);
    CHECK(json["mechanical_advantage"].size() == 5);
    // One rod: growing by a micrometre lowers the slide by one.
    bool found = false;
    for (const auto& length : json["height_by_length"])
        if (length["body"] == "rod") {
            found = true;
            CHECK(std::abs(length["slide_height_by_length"].get<double>()) == near(1, 1e-9));
        }
    CHECK(found);
    const auto joints = content(folder / "joints.csv");
    CHECK(count(joints, "# warning: a warning") == 1);
    CHECK(count(joints, "\n") == 720 + 6);  // version, case, segment, warning, kinds, header
    CHECK(count(content(folder / "campbell.csv"), "forward") > 10);
    fs::remove_all(folder);
}

TEST_CASE("text for the terminal")
{
    const auto& [input, loads] = solved();
    const auto text = report::loads_text(input, loads);
    CHECK(count(text, "stroke 80.000 mm") == 1);
    CHECK(count(text, "rigid") == 2);  // two bearings
    CHECK(report::loads_line(loads).find("loads: stroke 80.00 mm, largest joint force") == 0);
    CHECK(count(report::linkage_plan_text(input), "revolute, driver") == 1);
}

TEST_CASE("the vertical axis of a chart ends at its ticks")
{
    // -138..151 with six intervals wanted: steps of 50 from -150 to 200, not of 100 below the frame.
    report::Chart chart;
    chart.series.push_back({"a", {0, 1}, {-138, 151}, {}, false, false, true, -1});
    const auto svg = report::svg_chart(chart);
    CHECK(count(svg, ">\u2212150<") == 1);
    CHECK(count(svg, ">\u2212200<") == 0);
}
