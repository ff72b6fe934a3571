#include "../../scratch_folder.hpp"
#include "deadpoint/exchange/stress.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/report/run/frame_files.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::report;

namespace {

/// Two rods, of which the second slackens and recovers, a bond that opens, and stress at two times.
press::FrameResult example()
{
    press::FrameResult frame;
    frame.rods.resize(2);
    frame.rods[0].part = "left_rod";
    frame.rods[0].preload = "left";
    frame.rods[0].start = 200e3;
    frame.rods[0].change.value = {0, 1e3, 4e3};
    frame.rods[1].part = "right_rod";
    frame.rods[1].preload = "right";
    frame.rods[1].start = 100e3;
    frame.rods[1].change.value = {0, -5e3, -2e3};
    frame.bonds.resize(1);
    frame.bonds[0].name = "crown|column";
    frame.bonds[0].preload = "left";
    frame.bonds[0].start = -300e3;
    frame.bonds[0].change.value = {0, 10e3, 25e3};
    frame.bonds[0].openings.resize(2);
    frame.bonds[0].openings[0].time = 0;
    frame.bonds[0].openings[1] = {.time = 60, .largest = 3e6, .place = {0.1, -0.2, 1.5}, .share = 0.125};
    frame.support_force = 130e3;
    for (const double time : {0.0, 60.0}) {
        press::StressPeak peak;
        peak.part = "crown";
        peak.time = time;
        peak.von_mises = 20e6 + time * 1e5;
        peak.place = {0.25, 0.5, -0.75};
        peak.principal = {21e6, 1e6, -4e6};
        peak.highest_principal = 30e6;
        peak.lowest_principal = -12e6;
        frame.stress.push_back(peak);
    }
    return frame;
}

std::string line_with(const std::string& text, const std::string& words)
{
    const auto at = text.find(words);
    if (at == std::string::npos)
        return {};
    const auto begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
}

bool holds(const std::string& line, std::initializer_list<const char*> words)
{
    std::size_t at = 0;
    return std::ranges::all_of(words, [&](const char* word) {
        at = line.find(word, at);
        return at != std::string::npos;
    });
}

}  // namespace

TEST_CASE("forces of rods and what they close, in words")
{
    const auto text = frame_text(example());
    // In kN: at the start, least, at the end, change; in per cent of the start.
    CHECK(holds(line_with(text, "left_rod"), {"200.0", "200.0", "204.0", "+4.00", "+2.00"}));
    CHECK(holds(line_with(text, "right_rod"), {"100.0", "95.0", "98.0", "-2.00", "-2.00"}));
    CHECK(holds(line_with(text, "crown|column"), {" 300.0", " 275.0", "12"}));
    CHECK(holds(line_with(text, "250, 500, -750"), {"crown", "26.00", "+30.00", "-12.00"}));  // the end alone
    CHECK(text.find("20.00") == std::string::npos);
    CHECK(frame_text({}).empty());
}

TEST_CASE("forces of rods and what they close, in summary.json")
{
    const auto json = frame_json(example(), {0, 30, 60});
    CHECK(json["support_force_kN"] == 130.0);
    const auto& rod = json["rods"]["right_rod"];
    CHECK(rod["start_kN"] == 100.0);
    CHECK(rod["change_at_end_kN"] == -2.0);
    CHECK(rod["change_at_end_percent"] == -2.0);
    CHECK(rod["least_kN"] == 95.0);
    CHECK(rod["time_of_least_s"] == 30);
    const auto& bond = json["closed"]["crown|column"];
    CHECK(bond["start_kN"] == -300.0);
    CHECK(bond["change_at_end_kN"] == 25.0);
    REQUIRE(bond["openings"].size() == 2);
    CHECK(bond["openings"][1]["largest_tension_MPa"] == 3.0);
    CHECK(bond["openings"][1]["place_mm"][2] == 1500.0);
    CHECK(bond["openings"][1]["share_under_tension"] == 0.125);
    REQUIRE(json["stress"].size() == 2);
    CHECK(json["stress"][1]["von_mises_MPa"] == 26.0);
    CHECK(json["stress"][1]["principal_there_MPa"][2] == -4.0);
    CHECK(json["stress"][1]["highest_principal_MPa"] == 30.0);
    CHECK(frame_json({}, {0}).empty());
}

TEST_CASE("forces of rods and what they close, as columns over time")
{
    const SeriesSampler sample = [](const Series& series, double factor, double offset) {
        std::vector<double> values;
        for (const double value : series.value)
            values.push_back(offset + factor * value);
        return values;
    };
    std::vector<CsvColumn> columns;
    add_frame_columns(columns, example(), sample);
    REQUIRE(columns.size() == 3);
    const ScratchFolder folder;
    write_csv(folder.path / "forces.csv", {}, columns);
    const auto text = content(folder.path / "forces.csv");
    CHECK(text.find("left_rod force [kN]") != std::string::npos);
    CHECK(holds(text, {"200", "100", "-300", "201", "95", "-290", "204", "98", "-275"}));
}

TEST_CASE("stress.csv: a row for each part and time, in MPa and mm")
{
    const ScratchFolder folder;
    write_stress(folder.path / "stress.csv", example(), {"a comment"});
    const auto text = content(folder.path / "stress.csv");
    CHECK(text.find("a comment") != std::string::npos);
    CHECK(holds(line_with(text, "60,"), {"crown", "26", "21", "1", "-4", "250", "500", "-750", "30", "-12"}));
}
