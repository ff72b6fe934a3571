/// Requirement: every file of a result folder holds what the schema says, all of it and nothing else, and whoever reads
/// results asks for nothing that the schema does not know.
#include "deadpoint/report/schema/schema.hpp"

#include "../../scratch_folder.hpp"
#include "calibration_of_all.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/calibration/calibration_files.hpp"
#include "deadpoint/report/compare/compare_files.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/folder/point_table.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_table.hpp"
#include "deadpoint/report/folder/table_style.hpp"
#include "deadpoint/report/heat/heat_files.hpp"
#include "deadpoint/report/mesh/mesh_files.hpp"
#include "deadpoint/report/run/run_files.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "everything.hpp"
#include "schema_coverage.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/ranges.h>
#include <fstream>
#include <regex>

using namespace deadpoint;
using namespace deadpoint::report;
using namespace everything;
namespace fs = std::filesystem;

namespace {

/// Writes every file of every command.
void write_all(const fs::path& folder)
{
    const auto input = case_of_all();
    const auto machine = machine_of_all();
    write_run_files(folder, input, machine, run_of_all(input), {"be careful"});
    write_heat_files(folder, input, heat_of_all(), {});
    write_mesh_files(folder, machine, {});
    write_sweep_files(folder, sweep_of_all(), {});
    PointTable(folder / "points.csv", "a study").add({"slow", "mark", {}, brief(record())});
    write_plan_files(folder, plan_of_all());
    write_calibration_files(folder, calibration_of_all());
    write_compare_files(folder / "compare", record(), comparison_of_all(), IfThere::replace);
    write_sensitivity_files(folder, sensitivity_of_all().report(), {});
    write_optimise_files(folder, optimise_of_all().report(), {});
    fs::create_directory(folder / "screening");
    write_sensitivity_files(folder / "screening", screening_of_all().report(), {});
    write_manifest(folder);
}

std::string source(const std::string& name) { return content(fs::path(DEADPOINT_SOURCE_DIR) / name); }

/// All names that the schema knows: kinds of columns, keys and the steps on the way to them.
std::set<std::string> known_names()
{
    std::set<std::string> names;
    for (const auto& file : schema::files()) {
        for (const auto& column : file.columns) {
            names.insert(std::string(column.kind));
        }
        for (const auto& key : file.keys) {
            const auto steps = steps_of(key.path);
            names.insert(steps.begin(), steps.end());
        }
    }
    return names;
}

std::set<std::string> matches(const std::string& text, const std::string& pattern)
{
    std::set<std::string> found;
    const std::regex expression(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at) {
        found.insert((*at)[1]);
    }
    return found;
}

/// Where in the schema a variable of a script stands.
struct Place {
    std::string file;
    std::string path;
};

/// Whether keys read one after the other, like ".drift_um.final", lead to something that the file has. What a language
/// does with a value (".length") ends them.
bool known_chain(const Place& place, const std::string& chain)
{
    static const std::set<std::string> methods{"length",        "map",     "flatMap", "filter", "find",
                                               "some",          "every",   "forEach", "join",   "reduce",
                                               "toExponential", "toFixed", "sort"};
    auto steps = steps_of(place.path);
    const std::regex word(R"(\w+)");
    for (std::sregex_iterator at(chain.begin(), chain.end(), word), end; at != end && !methods.contains(at->str());
         ++at) {
        steps.push_back(at->str());
    }
    return std::ranges::any_of(schema::file(place.file).keys, [&](const auto& key) {
        auto pattern = steps_of(key.path);
        std::erase(pattern, "[]");
        return fits(steps, pattern, false);
    });
}

}  // namespace

TEST_CASE("docs/result-files.md is the page of this program")
{
    // To renew the page, run this test with DEADPOINT_RENEW_DOCS=1.
    const fs::path page = DEADPOINT_SOURCE_DIR "/docs/result-files.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(page) << schema::page();
    }
    CHECK(content(page) == schema::page());
}

TEST_CASE("no file states a column or a key twice, and every column says what it means")
{
    for (const auto& file : schema::files()) {
        CAPTURE(file.name);
        std::set<std::string> kinds, paths;
        for (const auto& column : file.columns) {
            CHECK_MESSAGE(kinds.insert(std::string(column.kind)).second, column.kind);
            CHECK_MESSAGE(!column.meaning.empty(), column.kind);
        }
        for (const auto& key : file.keys) {
            CHECK_MESSAGE(paths.insert(key.path).second, key.path);
        }
    }
    CHECK_THROWS_AS((void)schema::file("other.csv"), std::logic_error);
}

TEST_CASE("what is written is what the schema says, all of it and nothing else")
{
    const ScratchFolder folder;
    write_all(folder.path);
    SchemaCoverage coverage;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path)) {
        const auto name = entry.path().filename().string();
        std::vector<std::string> unknown;
        if (name.ends_with(".json")) {
            unknown = coverage.document(name, nlohmann::ordered_json::parse(content(entry.path())));
        } else if (name.ends_with(".csv")) {
            unknown = coverage.table(name, content(entry.path()));
        }
        CHECK(unknown == std::vector<std::string>{});
    }
    const ScratchFolder plain;
    report::write_csv(plain.path / "history.csv", std::vector<std::string>{"a head"}, {});
    report::style_tables(plain.path, CsvStyle::plain);
    const auto heads = nlohmann::ordered_json::parse(content(plain.path / "tables.json"));
    CHECK(coverage.document("tables.json", heads) == std::vector<std::string>{});
    CHECK(fmt::format("{}", fmt::join(coverage.unwritten(), ", ")) == "");
}

TEST_CASE("a key or a column that the schema does not know is noticed")
{
    SchemaCoverage coverage;
    CHECK(coverage.document("summary.json", {{"warnings", {}}, {"probe_rises_K", nullptr}}).empty());
    CHECK(coverage.document("summary.json", {{"probe_rises_K", {{"top", {{"end", 1}}}}}}).empty());
    CHECK(coverage.document("summary.json", {{"wind", 1}}) == std::vector<std::string>{"summary.json:/wind"});
    CHECK(coverage.document("summary.json", {{"case", {{"name", {{"deep", 1}}}}}}).size() == 1);
    const ScratchFolder folder;
    const std::vector<CsvColumn> columns{csv_column(schema::films::rise, std::vector<double>{1})};
    CHECK_THROWS_AS(write_table(folder.path / "history.csv", {}, columns), std::logic_error);
    CHECK_NOTHROW(write_table(folder.path / "films.csv", {}, columns));
}

TEST_CASE("columns are found by kind and name, whatever the names look like")
{
    const std::string text = "# columns: mine\n# columns: time, probe_temperature, joint_heat, source_heat, dimension\n"
                             "time [s],'=A heat [degC],=A heat heat [W],source =A heat [W],E_SW [um]\n0,20,5,9,1\n";
    const ResultTable table(text, "history.csv");
    CHECK(table.names(schema::history::probe) == std::vector<std::string>{"=A heat"});
    CHECK(table.names(schema::history::joint_heat) == std::vector<std::string>{"=A heat"});
    CHECK(table.numbers(schema::history::joint_heat, "=A heat") == std::vector<double>{5});
    CHECK(table.numbers(schema::history::source, "=A") == std::vector<double>{9});
    CHECK(table.numbers(schema::time) == std::vector<double>{0});
    CHECK_FALSE(table.has(schema::history::air));
    CHECK_THROWS_WITH_AS((void)table.numbers(schema::history::probe, "top"),
                         doctest::Contains("there is no column 'top'"), InputError);
    for (const char* broken :
         {"time [s]\n0\n", "# columns: time, time\ntime [s]\n0\n", "# columns: wind\ntime [s]\n0\n"}) {
        CHECK_THROWS_WITH_AS(ResultTable(broken, "history.csv"), doctest::Contains("does not fit its heading"),
                             InputError);
    }
}

TEST_CASE("headings and the names in them")
{
    CHECK(schema::filled("{joint} heat", "pin") == "pin heat");
    CHECK(schema::filled("time", "pin") == "time");
    CHECK(schema::name_in("oil {circuit} inlet", "oil main inlet") == "main");
    CHECK(schema::name_in("oil {circuit} inlet", "air main inlet").empty());
    CHECK(schema::name_in("time", "time").empty());
}

TEST_CASE("the page reads no column and no key that the schema does not know")
{
    auto known = known_names();
    known.insert({"rigid_bearing_force", "flexible_bearing_force", "joint_force"});  // with _x and _y behind
    known.insert({"case_file"});                                                     // of the page itself
    for (const std::string name : {"calibration", "charts", "data", "flow", "gaps", "linkage", "main", "optimise",
                                   "sections", "sensitivity", "stage", "sweep", "view"}) {
        const auto text = source("web/" + name + ".js");
        for (const char* pattern : {R"(\.([a-zA-Z]+_\w+))", R"(\{ *(\w+_\w+) *[,:}])", R"re("([a-z]+_\w+)")re"}) {
            for (const auto& read : matches(text, pattern)) {
                CHECK_MESSAGE(known.contains(read), name << ".js reads '" << read << "'");
            }
        }
        for (const auto& [variable, place] : std::map<std::string, Place>{{"summary", {"summary.json", ""}},
                                                                          {"drift", {"summary.json", "drift_um"}},
                                                                          {"loads", {"loads.json", ""}},
                                                                          {"view", {"view.json", ""}},
                                                                          {"motion", {"motion.json", ""}},
                                                                          {"sensitivity", {"sensitivity.json", ""}},
                                                                          {"calibration", {"calibration.json", ""}},
                                                                          {"optimise", {"optimise.json", ""}},
                                                                          {"study", {"sweep.json", ""}}}) {
            for (const auto& chain : matches(text, "\\b" + variable + R"(((?:\??\.[a-zA-Z]\w*)+))")) {
                CHECK_MESSAGE(known_chain(place, chain), name << ".js reads " << variable << chain);
            }
        }
    }
}

TEST_CASE("the scripts read no key that the schema does not know")
{
    const std::map<std::string, Place> places{{"summar(?:y|ies\\[-?\\d\\])", {"summary.json", ""}},
                                              {"(?:loads|loads\\([^)]*\\))", {"loads.json", ""}},
                                              {"comparison", {"compare.json", ""}},
                                              {"study", {"sweep.json", ""}}};
    std::size_t reads = 0;
    for (const std::string name : {"scripts/independence.py", "scripts/paper-results.py", "scripts/paper-loads.py",
                                   "scripts/paper-heat.py", "benchmarks/scale.py"}) {
        const auto text = source(name);
        REQUIRE_MESSAGE(!text.empty(), name);
        for (const auto& [variable, place] : places) {
            for (const auto& chain : matches(text, variable + R"re(((?:\["\w+"\])+))re")) {
                ++reads;
                CHECK_MESSAGE(known_chain(place, chain), name << " reads " << variable << chain);
            }
        }
    }
    CHECK(reads > 20);  // what is looked for is found
}

TEST_CASE("what reads results in the program asks for nothing that the schema does not know")
{
    auto known = known_names();
    known.insert({"runs", "summary", "loads", "points", "machine"});  // of the page's own data
    known.insert("end");                                              // a {time}
    for (const std::string name : {"folder/read_result", "page/page", "page/page_tables", "page/sweep_page",
                                   "design/optimise_page", "design/sensitivity_page"}) {
        const auto text = source("src/deadpoint/report/" + name + ".cpp");
        for (const auto& read : matches(text, R"re((?:\.at|\.value|\.contains)\("(\w+)")re")) {
            CHECK_MESSAGE(known.contains(read), name << " reads '" << read << "'");
        }
    }
}

TEST_CASE("a chain of keys that leads nowhere is noticed")
{
    CHECK(known_chain({"summary.json", ""}, ".drift_um.final_E_SW.toFixed"));
    CHECK(known_chain({"summary.json", ""}, R"(["drift_um"]["final"]["E_SW"])"));
    CHECK(known_chain({"summary.json", "drift_um"}, "?.final_by_part"));
    CHECK_FALSE(known_chain({"summary.json", ""}, ".drift.final_E_SW"));
    CHECK_FALSE(known_chain({"summary.json", ""}, ".drift_um.last"));
}
