#include "deadpoint/press/compare/compare.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/drift/drift_summary.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/compare/compare_files.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/run/drift_summary_text.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::report;
namespace fs = std::filesystem;

namespace {

/// A result folder as a run leaves it, reduced to what is read.
struct Folder : ScratchFolder {
    Folder()
    {
        put("summary.json", R"({"case": {"name": "press", "hash": "0123"}, "interrupted": false,
            "initial_temperature_degC": 20.0, "probe_rises_K": {"top": {"end": 2}},
            "reference": {"rises_K": {"top": {"computed": 2, "reference": 3}}, "time_s": 3600,
                          "calibrated_on": ["oil.pins"]}})");
        put("history.csv", "# columns: time, probe_temperature, joint_temperature, joint_heat, dimension, dimension\n"
                           "time [s],top [degC],pin temperature [degC],pin heat [W],E_SW [um],E_BG [um]\n"
                           "0,20,20,5,0,0\n3600,22,30,4,-7.5,2\n");
        put("loads.json", R"({"slide": {"stroke_mm": 80}, "seats": {"B": {"mean_N": [1, -2]}}, "text": "x"})");
    }
    void put(const std::string& name, const std::string& text) const
    {
        (void)file(name, text);
        write_manifest(path);
    }
    [[nodiscard]] std::string content(const std::string& name) const { return ::content(path / name); }
};

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("a result folder is read back: rises, chain in metres, every number of its loads, what was fitted")
{
    const Folder folder;
    const auto run = read_result(folder.path);
    CHECK(run.machine == "press");
    CHECK(run.initial_temperature == near(293.15, 1e-5));
    CHECK(run.time == std::vector<double>{0, 3600});
    REQUIRE(run.probes == std::vector<std::string>{"top"});
    CHECK(run.rises.at("top")[1] == near(2, 1e-5));
    CHECK(run.rises.size() == 1);  // joints are no probes
    CHECK(run.chain.size() == 2);
    CHECK(run.chain.at("E_SW")[1] == near(-7.5e-6, 1e-5));
    CHECK(run.has_loads);
    CHECK(run.loads.size() == 3);
    CHECK(run.loads.at("seats.B.mean_N.1") == -2);
    CHECK(run.calibrated_on == std::vector<std::string>{"oil.pins"});
    CHECK(run.calibrated_time == 3600);
    CHECK(run.calibrated_probes == std::vector<std::string>{"top"});
    fs::remove(folder.path / "loads.json");
    write_manifest(folder.path);
    CHECK_FALSE(read_result(folder.path).has_loads);
}

TEST_CASE("a folder that no run has written, or an older version, is refused in words")
{
    const Folder folder;
    CHECK_THROWS_WITH_AS((void)read_result(folder.path / "none"), doctest::Contains("there is no folder"), IoError);
    folder.put("history.csv", "# columns: time, probe_temperature\ntime [s],tpo [degC]\n0,20\n");
    CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("there is no column 'top'"), InputError);
    folder.put("summary.json", R"({"case": {"name": "press", "hash": "0123"}, "interrupted": false})");
    CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("another version"), InputError);
    folder.put("summary.json", "{");
    CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("not the JSON"), InputError);
    fs::remove(folder.path / "summary.json");
    CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("summary.json' is missing"), IoError);
    write_manifest(folder.path);
    CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("there is no"), IoError);
}

TEST_CASE("a history that was cut, emptied or edited is refused, and so is one that runs backwards or holds no number")
{
    const std::string head = "# columns: time, probe_temperature\ntime [s],top [degC]\n";
    for (const std::string& text : {std::string(), head, head + "0,20\n", head + "0,20\n3600,23\n"}) {
        CAPTURE(text);
        const Folder folder;
        (void)folder.file("history.csv", text);
        CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains("history.csv' was changed"), InputError);
    }
    const Folder folder;
    const auto refused = [&](const std::string& rows, const char* what) {
        folder.put("history.csv", head + rows);
        CHECK_THROWS_WITH_AS((void)read_result(folder.path), doctest::Contains(what), InputError);
    };
    refused("0,20\n3600,22\n1800,21\n", "history.csv:5: the time does not increase");
    refused("0,20\n0,22\n", "history.csv:4: the time does not increase");
    refused("0,20\n3600,nan\n", "is not a finite number");
    refused("", "there are no rows");
}

TEST_CASE("the comparison as text, page and JSON: shown units, signs, baselines, notes and verdicts")
{
    const Folder folder;
    const auto run = read_result(folder.path);
    casefile::ReferenceFile file;
    file.name = "bench";
    file.source = "made up";
    file.rises.emplace_back().time = 3600;
    file.rises[0].values = {{"top", 3}};
    file.rises[0].note = "read by eye | twice";
    casefile::ReferenceChain chain;
    chain.dimension = "E_SW";
    chain.at = casefile::ReferenceChain::At::end;
    chain.value = 5e-6;
    chain.opposite_sign = true;
    chain.group = "dial";
    file.chain.push_back(chain);
    casefile::ReferenceClaim claim;
    claim.text = "The gap opens.";
    claim.kind = casefile::ReferenceClaim::Kind::opens;
    file.claims.push_back(claim);
    const auto comparison = press::compare(run, file);
    const auto text = compare_text(run, comparison);
    CHECK(has(text, "press against bench"));
    CHECK(has(text, "-1.000   -33.3 %  calibrated"));
    CHECK(has(text, "E_SW at the end (dial)"));
    CHECK(has(text, "-5.000    -7.500  -2.500   -50.0 %  predicted"));
    CHECK(has(text, "the case was fitted to the rises"));
    CHECK(has(text, "does not hold The gap opens."));

    write_compare_files(folder.path / "compare", run, comparison);
    const auto page = folder.content("compare.md");
    CHECK(has(page, "| chain: dial | um | 1 | 2.500 | -2.500 | -2.500 (E_SW at the end) | 5.000 | - | predicted |"));
    CHECK(has(page, "- top at 1 h: read by eye | twice\n"));
    const auto json = nlohmann::json::parse(folder.content("compare.json"));
    CHECK(json.at("values").at(1).at("error").get<double>() == near(-2.5, 1e-5));
    CHECK(json.at("values").at(0).at("calibrated") == true);
    CHECK(json.at("sets").size() == 2);
    CHECK(json.at("claims").at(0).at("verdict") == "does not hold");
    CHECK(json.at("baseline").is_null());
}

TEST_CASE("the drift in one line names what a short run did not reach")
{
    press::CourseSummary gap;
    gap.first_hour = {3600, false, -50e-6, 51e-6};
    gap.four_hours = {10800, true, -40e-6, 55e-6};
    gap.largest_rate = -100e-6 / 3600;
    gap.largest_rate_from = 60;
    gap.window = 600;
    gap.range = 55e-6;
    CHECK(drift_summary_line(gap) ==
          "  change -50.0 um in the first hour, -40.0 um over the run of 3 h 00 min; fastest "
          "-100.0 um/h over 10 min 00 s from 1 min 00 s; range 55.0 um\n");
    gap.first_hour = {1800, true, -50e-6, 51e-6};
    CHECK(has(drift_summary_line(gap), "  change -50.0 um over the run of 30 min 00 s; fastest"));
}
