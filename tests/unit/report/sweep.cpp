#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/csv_table.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/sweep/sweep_charts.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "near.hpp"

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::report;
using State = twin::PointOutcome::State;
namespace fs = std::filesystem;

namespace {

struct Folder : ScratchFolder {
    [[nodiscard]] std::string content(const std::string& name) const { return ::content(path / name); }
};

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

twin::SweepAxis axis(const std::string& name, const std::vector<std::string>& values,
                     const std::vector<double>& numbers, Dimension dimension)
{
    twin::SweepAxis a;
    a.name = name;
    a.keys = {"operation.0." + name};
    for (const auto& value : values) {
        a.values.push_back({value});
    }
    a.labels = values;
    a.numbers = numbers;
    a.dimension = dimension;
    return a;
}

/// A gap that closes to -20 um times a factor within the first hour and comes half way back over two more.
press::RunRecord record(double factor)
{
    press::RunRecord run;
    run.machine = "press";
    run.hash = "0123";
    run.initial_temperature = 293.15;
    run.probes = {"top", "side"};
    for (int k = 0; k <= 36; ++k) {
        const double hours = k / 12.0;
        run.time.push_back(3600 * hours);
        run.rises["top"].push_back(8 * factor * (1 - std::exp(-hours)));
        run.rises["side"].push_back(4 * factor * (1 - std::exp(-hours / 2)));
        run.chain["E_SW"].push_back(-20e-6 * factor * (hours <= 1 ? hours : 1 - (hours - 1) / 4));
        run.joint_heat["pin"].push_back(100 * factor);
        run.joint_heat["bearing"].push_back(50);
    }
    run.gap = press::GapFigures{-20e-6 * factor, 20e-6 * factor, 9000};
    run.has_loads = true;
    run.loads = {{"crankshaft.flexible.seats.B.peak_N", 1000 * factor}, {"crankshaft.flexible.seats.B.rms_N", 7}};
    return run;
}

const std::vector<double> rpm{100, 200, 300, 400};

/// Speed by force, and speed alone; the drift goes with the product of both. The last point failed, one is left.
SweepResult example()
{
    SweepResult result;
    auto& study = result.study;
    study.name = "two sets";
    study.base = "case.toml";
    study.limits = {30e-6, 12e-6};
    std::vector<double> speeds;
    for (const double n : rpm) {
        speeds.push_back(n * std::numbers::pi / 30);
    }
    const auto speed = axis("speed", {"100 rpm", "200 rpm", "300 rpm", "400 rpm"}, speeds, Dimension::angular_velocity);
    const auto force = axis("force", {"500 N", "1 kN", "2 kN"}, {500, 1000, 2000}, Dimension::force);
    study.sets = {{"speed and force", {speed, force}},
                  {"speed", {speed}},
                  {"model", {axis("model", {"rigid", "flexible"}, {}, Dimension::none)}}};
    for (std::size_t s = 0; s < 4; ++s) {
        for (std::size_t f = 0; f < 3; ++f) {
            twin::SweepPoint point{fmt::format("s{}f{}", s, f), {}, {{0, {s, f}}}};
            if (f == 1) {
                point.places.push_back({1, {s}});
            }
            if (s == 1 && f == 1) {
                point.places.push_back({2, {1}});
            }
            result.points.push_back(point);
            result.outcomes.push_back({State::done, "", 12});
            result.records.emplace_back(record(rpm[s] / 200 * force.numbers[f] / 1000));
        }
    }
    result.points.push_back({"rigid", {"model=rigid"}, {{2, {0}}}});
    result.outcomes.push_back({State::kept, "", 10});
    result.records.emplace_back(record(1.3));
    result.outcomes[11] = {State::failed, "it did not converge\n  help: take smaller steps", 3};
    result.records[11].reset();
    result.outcomes[0] = {State::left, "", 0};
    result.records[0].reset();
    return result;
}

std::size_t count_of(const std::string& text, const std::string& piece)
{
    std::size_t count = 0;
    for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + piece.size())) {
        ++count;
    }
    return count;
}

}  // namespace

TEST_CASE("a run's figures: largest drift with its time, rises and heat at the end, peaks of the seats")
{
    const auto figures = sweep_figures(record(2));
    REQUIRE(figures.drift);
    CHECK(figures.drift->largest == near(-40e-6, 1e-12));
    CHECK(figures.drift->largest_time == 3600);
    CHECK(figures.drift->final == near(-20e-6, 1e-12));
    CHECK(figures.rises.at("top") == near(16 * (1 - std::exp(-3.0)), 1e-14));
    CHECK(*figures.joint_heat == near(250, 1e-14));
    CHECK(figures.bearing_forces == std::map<std::string, double>{{"flexible B", 2000}});
    auto bare = record(1);
    bare.chain.clear();
    bare.joint_heat.clear();
    CHECK_FALSE(sweep_figures(bare).drift);
    CHECK_FALSE(sweep_figures(bare).joint_heat);
}

TEST_CASE("the numbers of an axis are in the unit of its values, or the preferred one where they differ")
{
    const auto result = example();
    const auto speed = axis_numbers(result.study.sets[0].axes[0]);
    CHECK(speed.unit == "rpm");
    CHECK(speed.values == rpm);
    const auto force = axis_numbers(result.study.sets[0].axes[1]);
    CHECK(force.unit == "kN");
    CHECK(force.values[0] == near(0.5, 1e-14));
    CHECK(axis_numbers(result.study.sets[2].axes[0]).values.empty());
    const auto warm = axis_numbers(axis("a", {"20 degC", "300 K"}, {293.15, 300}, Dimension::temperature));
    CHECK(warm.unit == "degC");
    CHECK(warm.values[1] == near(26.85, 1e-12));
}

TEST_CASE("sweep.csv has a row for each place, and empty cells for what is not known")
{
    const Folder folder;
    write_sweep_files(folder.path, example(), {"be careful"});
    const auto table = read_csv(folder.path / "sweep.csv");
    REQUIRE(table.rows.size() == 4 * 3 + 4 + 2);
    const auto cell = [&](std::size_t row, const std::string& name) { return table.rows[row][table.column(name)]; };
    CHECK(has(folder.content("sweep.csv"), "# warning: be careful"));
    // The second row: 100 rpm, 1 kN, half of the drift of the base case.
    CHECK(cell(1, "set") == "speed and force");
    CHECK(cell(1, "point") == "s0f1");
    CHECK(cell(1, "state") == "done");
    CHECK(cell(1, "speed") == "100 rpm");
    CHECK(cell(1, "speed value") == "100");
    CHECK(table.columns[table.column("speed value")].unit == "rpm");
    CHECK(cell(1, "force value") == "1");
    CHECK(cell(1, "largest E_SW") == "-10");
    CHECK(cell(1, "time of largest E_SW") == "3600");
    CHECK(cell(1, "E_SW at end") == "-5");
    CHECK(cell(1, "E_SW change in first hour") == "-10");
    CHECK(cell(1, "E_SW range") == "10");
    CHECK(cell(1, "steady from") == "9000");
    CHECK(cell(1, "joint heat") == "100");
    CHECK(cell(1, "peak force flexible B") == "500");
    CHECK(cell(1, "keeps limits") == "yes");
    CHECK(cell(1, "wall time") == "12");
    CHECK(cell(0, "state") == "left");
    CHECK(cell(0, "largest E_SW") == "");
    CHECK(cell(0, "wall time") == "");
    CHECK(cell(11, "state") == "failed");
    CHECK(has(cell(11, "reason"), "did not converge"));
    CHECK(cell(11, "keeps limits") == "");
    // Rows 12 to 15: speed alone; its force is not an axis there.
    CHECK(cell(12, "point") == "s0f1");
    CHECK(cell(12, "force") == "");
    CHECK(cell(16, "model") == "rigid");
    CHECK(cell(16, "speed value") == "");
}

TEST_CASE("windows: final drift up to 12 um allows 200 rpm at 1 kN, and what is less")
{
    // The end is 10 um times rpm/200 times kN: 12 um allow products up to 240 rpm kN. Of the map, without the point
    // that is left (100 rpm, 500 N): 200 rpm at both lower forces, 100 rpm at 1 and 2 kN, 300 and 400 rpm at 500 N.
    const auto result = example();
    const auto windows = sweep_windows(result);
    REQUIRE(windows.size() == 3);
    // Three points of one force (200 to 400 rpm at 500 N) are more than any box of two.
    CHECK(windows[0]->points == 3);
    CHECK(windows[0]->steps[0] == std::vector<std::size_t>{1, 2, 3});
    CHECK(windows[0]->steps[1] == std::vector<std::size_t>{0});
    CHECK(window_text(result.study.sets[0], windows[0]) == "speed 200 rpm to 400 rpm; force 500 N (3 points)");
    CHECK(window_text(result.study.sets[1], windows[1]) == "speed 100 rpm to 200 rpm (2 points)");
    CHECK(window_text(result.study.sets[2], windows[2]) == "model flexible (1 point)");
    auto strict = example();
    strict.study.limits = {1e-9, {}};
    CHECK(window_text(strict.study.sets[1], sweep_windows(strict)[1]) == "no point keeps the limits");
    auto cut_short = example();
    cut_short.records[4]->interrupted = true;  // 200 rpm at 1 kN
    CHECK(sweep_windows(cut_short)[1]->steps[0] == std::vector<std::size_t>{0});
    strict.study.limits = {};
    CHECK_FALSE(sweep_windows(strict)[1]);
}

TEST_CASE("sweep.json has plan, states, figures and windows")
{
    const Folder folder;
    write_sweep_files(folder.path, example());
    const auto json = nlohmann::json::parse(folder.content("sweep.json"));
    CHECK(json.at("study").at("name") == "two sets");
    CHECK(json.at("limits").at("largest_um").get<double>() == near(30, 1e-12));
    CHECK(json.at("sets").at(0).at("axes").at(0).at("unit") == "rpm");
    CHECK_FALSE(json.at("sets").at(2).at("axes").at(0).contains("unit"));
    CHECK(json.at("sets").at(0).at("window").at("points") == 3);
    CHECK(json.at("sets").at(0).at("window").at("axes").at("speed") == nlohmann::json{"200 rpm", "300 rpm", "400 rpm"});
    REQUIRE(json.at("points").size() == 13);
    const auto& point = json.at("points").at(4);
    CHECK(point.at("places").size() == 3);
    CHECK(point.at("places").at(0).at("steps").at("force") == "1 kN");
    CHECK(point.at("figures").at("E_SW").at("largest_um").get<double>() == near(-20, 1e-12));
    CHECK(point.at("case_hash") == "0123");
    CHECK(json.at("points").at(0).at("figures").is_null());
    CHECK(has(json.at("points").at(11).at("reason"), "did not converge"));
}

TEST_CASE("charts: eight curves at most, limits drawn, steps without order are not joined")
{
    const auto result = example();
    const auto drift = sweep_drift_chart(result, 1);
    REQUIRE(drift.series.size() == 4);
    CHECK(drift.series[1].name == "200 rpm");
    CHECK(drift.series[1].x.back() == near(3, 1e-5));
    CHECK(drift.series[1].y[12] == near(-20, 1e-5));
    // Twelve places: the first axis only, at the first force, of which two have no result.
    const auto crossed = sweep_drift_chart(result, 0);
    CHECK(crossed.series.size() == 3);
    CHECK(has(crossed.subtitle, "at force 500 N"));
    const auto limits = sweep_limit_chart(result, 1);
    REQUIRE(limits.series.size() == 4);
    CHECK(limits.series[2].y[0] == near(30, 1e-5));
    CHECK(limits.series[2].dashed);
    CHECK(limits.series[0].joined);
    CHECK(limits.x_ticks.empty());
    const auto models = sweep_rise_chart(result, 2);
    CHECK_FALSE(models.series[0].joined);
    REQUIRE(models.x_ticks.size() == 2);
    CHECK(models.x_ticks[0].text == "rigid");
    auto many = example();
    auto& axis = many.study.sets[1].axes[0];
    axis.values.assign(20, {"1"});
    axis.labels.assign(20, "1");
    axis.numbers.resize(20);
    many.points.clear();
    for (std::size_t i = 0; i < 20; ++i) {
        axis.values[i] = {std::to_string(i)};
        axis.labels[i] = std::to_string(i);
        axis.numbers[i] = static_cast<double>(i);
        many.points.push_back({"p", {}, {{1, {i}}}});
    }
    many.outcomes.assign(20, {State::done, "", 1});
    many.records.assign(20, record(1));
    const auto some = sweep_drift_chart(many, 1);
    REQUIRE(some.series.size() == 8);
    CHECK(some.series.front().name == "0");
    CHECK(some.series.back().name == "19");
    CHECK(has(some.subtitle, "8 of 20 steps"));
}

TEST_CASE("numbers that span decades stand on a logarithmic axis with their own ticks")
{
    auto result = example();
    auto& axis = result.study.sets[1].axes[0];
    axis.values = {{"5e7 N/m"}, {"1e8 N/m"}, {"5e8 N/m"}, {"1e9 N/m"}};
    axis.numbers = {5e7, 1e8, 5e8, 1e9};
    axis.dimension = Dimension::stiffness;
    const auto chart = sweep_limit_chart(result, 1);
    REQUIRE(chart.x_ticks.size() == 4);
    CHECK(chart.x_ticks[1].x == near(8, 1e-5));
    CHECK(chart.x_ticks[1].text == "1e8");
    CHECK(chart.x_label == "speed [N/m]");
}

TEST_CASE("the map prints every value, says what is missing, and outlines the window")
{
    const auto result = example();
    const auto map = sweep_map(result, 0, sweep_windows(result)[0]);
    CHECK(has(map, ">30.0</text>"));  // 300 rpm at 1 kN, largest
    CHECK(has(map, ">15.0</text>"));  // at the end
    CHECK(count_of(map, ">failed</text>") == 2);
    CHECK(count_of(map, ">left</text>") == 2);
    CHECK(count_of(map, "<rect") == 2 + 2 * 12);  // background and pattern, then the cells
    CHECK(has(map, "outlined: speed 200 rpm to 400 rpm; force 500 N (3 points)"));
    CHECK(count_of(map, "stroke=\"#d55e00\"") == 2);
    CHECK(count_of(sweep_map(result, 0, std::nullopt), "stroke=\"#d55e00\"") == 0);
    CHECK_THROWS_AS((void)sweep_map(result, 1, std::nullopt), DomainError);
}

TEST_CASE("which charts are written; without a single result there are none")
{
    const Folder folder;
    write_sweep_files(folder.path, example());
    for (const char* name : {"speed_and_force-map.svg", "speed_and_force-drift.svg", "speed-rises.svg",
                             "speed-limits.svg", "model-drift.svg"}) {
        CHECK(fs::exists(folder.path / name));
    }
    CHECK_FALSE(fs::exists(folder.path / "speed-map.svg"));
    auto alike = example();
    alike.study.sets[2].name = "sp/eed";
    alike.study.sets[1].name = "sp eed";
    const Folder twins;
    write_sweep_files(twins.path, alike);
    CHECK(fs::exists(twins.path / "sp_eed-drift.svg"));
    CHECK(fs::exists(twins.path / "sp_eed-3-drift.svg"));
    const Folder empty;
    auto nothing = example();
    nothing.records.assign(nothing.points.size(), std::nullopt);
    nothing.outcomes.assign(nothing.points.size(), {State::left, "", 0});
    write_sweep_files(empty.path, nothing);
    CHECK(fs::exists(empty.path / "sweep.csv"));
    CHECK_FALSE(fs::exists(empty.path / "speed-drift.svg"));
    CHECK(has(sweep_text(nothing), "left"));
    nothing.records.pop_back();
    CHECK_THROWS_AS(write_sweep_files(empty.path, nothing), DomainError);
}

TEST_CASE("the plan and the table for the terminal")
{
    const auto result = example();
    const auto plan = sweep_plan_text(result.study, result.points);
    CHECK(has(plan, "speed and force, 12 points"));
    CHECK(has(plan, "speed: 100 rpm, 200 rpm, 300 rpm, 400 rpm"));
    CHECK(has(plan, "13 distinct points to compute for 18 places; shared: s0f1 (2 places)"));
    CHECK(has(plan, "s1f1 (3 places)"));
    const auto text = sweep_text(result);
    CHECK(has(text, "window: speed 100 rpm to 200 rpm (2 points)"));
    CHECK(has(text, "s3f2: it did not converge\n"));
    CHECK(has(text, "limits: largest |E_SW| up to 30 um, |E_SW| at the end up to 12 um"));
    CHECK(has(text, "exceeded"));
}

TEST_CASE("what a run says of its gap and its joints is read back")
{
    const Folder folder;
    const auto put = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.path / name) << text;
    };
    put("summary.json", R"({"case": {"name": "press", "hash": "0123"}, "interrupted": false,
        "initial_temperature_degC": 20.0, "probe_rises_K": {"top": {"end": 2}}, "drift_summary": {"E_SW": {
        "first_hour": {"change_um": -3.5}, "range_um": 7.5, "steady_from_s": 1200}}})");
    put("history.csv", "# columns: time, probe_temperature, joint_temperature, joint_heat, source_heat, dimension\n"
                       "time [s],top [degC],pin temperature [degC],pin heat [W],source motor heat [W],E_SW [um]\n"
                       "0,20,20,5,9,0\n3600,22,30,4,9,-7.5\n");
    write_manifest(folder.path);
    const auto run = read_result(folder.path);
    REQUIRE(run.gap);
    CHECK(run.gap->first_hour_change == near(-3.5e-6, 1e-14));
    CHECK(run.gap->range == near(7.5e-6, 1e-14));
    CHECK(*run.gap->steady_from == 1200);
    CHECK(run.joint_heat.size() == 1);  // a motor is no joint
    CHECK(run.joint_heat.at("pin") == std::vector<double>{5, 4});
}

TEST_CASE("charts to look at" * doctest::skip(std::getenv("DEADPOINT_CHARTS") == nullptr))
{
    // DEADPOINT_CHARTS=folder writes the charts of the example there.
    const fs::path folder = std::getenv("DEADPOINT_CHARTS");
    write_sweep_files(folder, example());
    std::ofstream(folder / "sweep.txt") << sweep_plan_text(example().study, example().points) << sweep_text(example());
}
