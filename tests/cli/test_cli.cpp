#include "near.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("deadpoint-cli-" + std::to_string(std::random_device{}()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path / name).string(); }
};

std::string content(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

/// Runs the command with arguments in shell syntax.
Outcome deadpoint(const std::string& arguments)
{
    const Folder folder;
    const std::string line = std::string(DEADPOINT_COMMAND) + " " + arguments + " >" + (folder / "out") + " 2>" +
                             (folder / "err") + " </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err")};
}

/// Starts the command through the shell, sends it SIGINT once `sign` appears on its standard error, and waits for it.
Outcome interrupted(const std::string& arguments, const std::string& sign)
{
    using namespace std::chrono_literals;
    const Folder folder;
    const std::string line = "exec " + std::string(DEADPOINT_COMMAND) + " " + arguments + " >" + (folder / "out") +
                             " 2>" + (folder / "err") + " </dev/null";
    const pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    for (int i = 0; i < 600 && content(folder / "err").find(sign) == std::string::npos; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    std::this_thread::sleep_for(500ms);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err")};
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

const std::string crank = std::string(DEADPOINT_TEST_DATA) + "/study/balanced-crank.toml";
const std::string two_blocks = std::string(DEADPOINT_TEST_DATA) + "/cli/two-blocks.toml";

}  // namespace

TEST_CASE("--version and --help answer on standard output with exit code 0")
{
    const auto version = deadpoint("--version");
    CHECK(version.code == 0);
    CHECK(version.out.find("deadpoint 0.") == 0);
    const auto help = deadpoint("--help");
    CHECK(help.code == 0);
    for (const char* piece : {"init", "check", "mesh", "loads", "run", "compare", "Examples:", "Exit codes:"}) {
        CHECK_MESSAGE(has(help.out, piece), piece);
    }
    const auto run = deadpoint("run --help").out;
    CHECK(has(run, "--force"));
    CHECK(has(run, "Examples:\n  deadpoint run my-press/case.toml -o my-press/results "));
    CHECK(has(run, "Exit codes:"));
    CHECK_FALSE(has(run, "deadpoint init"));  // each subcommand shows its own examples
}

TEST_CASE("a wrong command line is exit code 2 and says what is wrong")
{
    CHECK(deadpoint("").code == 2);
    const auto misspelt = deadpoint("rnu case.toml");
    CHECK(misspelt.code == 2);
    CHECK(has(misspelt.err, "did you mean 'run'?"));
    const auto missing = deadpoint("run " + two_blocks);
    CHECK(missing.code == 2);
    CHECK(has(missing.err, "-o is missing"));
    CHECK(deadpoint("check " + two_blocks + " --size 0").code == 2);
}

TEST_CASE("a missing case file is exit code 5, a broken one exit code 2 with its place")
{
    const auto missing = deadpoint("check no/such/case.toml");
    CHECK(missing.code == 5);
    CHECK(has(missing.err, "no/such/case.toml"));

    const Folder folder;
    auto text = content(two_blocks);
    text.replace(text.find("\"7800 kg/m^3\""), 13, "\"7800 kg\"    ");
    std::ofstream(folder / "broken.toml") << text;
    const auto broken = deadpoint("check " + (folder / "broken.toml"));
    CHECK(broken.code == 2);
    CHECK(has(broken.err, "broken.toml:8:11: error["));  // line and column of the value
    CHECK(has(broken.err, "materials.steel.density"));
    CHECK(has(broken.err, "^^^"));
    CHECK(has(broken.err, "help:"));
}

TEST_CASE("names of files that move the cursor are shown, not obeyed, and overlong ones are file trouble")
{
    const auto odd = deadpoint("check \"$(printf 'a\\033[31m.toml')\"");
    CHECK(odd.code == 5);
    CHECK(has(odd.err, "a\\u001b[31m.toml"));
    CHECK_FALSE(has(odd.err, "\x1b"));
    const Folder folder;
    const std::string overlong(300, 'n');
    const auto results = folder / "r";
    REQUIRE(deadpoint("run -q " + two_blocks + " -o " + results).code == 0);
    for (const auto& line :
         {"check " + overlong, "run " + two_blocks + " -o " + (folder / overlong), "init " + overlong,
          "report " + results + " -o " + (folder / overlong), "report " + overlong,
          "run " + two_blocks + " --from " + overlong + " -o " + (folder / "s"), "view " + overlong,
          "compare " + results + " " + overlong, "sweep " + overlong + " -o " + (folder / "t"),
          "sweep " + overlong + " -o " + overlong}) {
        CAPTURE(line.substr(0, 60));
        const auto outcome = deadpoint(line);
        CAPTURE(outcome.err);
        CHECK(outcome.code == 5);
        CHECK_FALSE(has(outcome.err, "defect of the program"));
    }
}

TEST_CASE("init writes a case that passes its check, and never overwrites one")
{
    const Folder folder;
    const auto file = folder / "press/case.toml";
    const auto first = deadpoint("init " + (folder / "press"));
    CHECK(first.code == 0);
    CHECK(has(first.out, "deadpoint check " + file));
    const auto text = content(file);
    REQUIRE_FALSE(text.empty());
    const auto second = deadpoint("init " + (folder / "press"));
    CHECK(second.code == 5);
    CHECK(has(second.err, "not overwritten"));
    CHECK(content(file) == text);
    CHECK(deadpoint("check " + file).code == 0);
}

TEST_CASE("check prints the plan and warns of a mass that does not fit")
{
    const auto result = deadpoint("check " + two_blocks);
    CHECK(result.code == 0);
    CHECK(result.out.find("two blocks\n") == 0);
    CHECK(has(result.out, "15.60        16.00      -2.5 %"));
    CHECK(has(result.out, "lower|upper       100.0"));         // bonded over 100 mm x 100 mm
    CHECK(has(result.out, "0.1000  convection 10.0 W/m2/K"));  // ten faces of 100 mm x 100 mm
    CHECK(has(result.out, "16 hexahedra"));                    // 2 x 2 x 2 cells of 50 mm in each block
    CHECK(has(result.out, "no errors, 1 warning\n"));
    CHECK(
        has(result.err, "bodies.frame.mass\n  body 'frame' has 15.6 kg by its parts, but 16 kg are stated (-2.5 %)\n"));
    CHECK(has(result.err, "mesh\n"));
    const auto quiet = deadpoint("check --quiet " + two_blocks);
    CHECK(quiet.out == two_blocks + ": no errors, 1 warning\n");
    CHECK(has(quiet.err, "warning[mass]: bodies.frame.mass\n"));
    CHECK_FALSE(has(quiet.err, "mesh\n"));
}

TEST_CASE("--set changes a value, --size the cells")
{
    const auto heavier = deadpoint("check " + two_blocks + " --set 'materials.steel.density=8000 kg/m^3'");
    CHECK(has(heavier.out, "no errors, 0 warnings\n"));
    CHECK(has(deadpoint("check --size 0.5 " + two_blocks).out, "128 hexahedra"));  // eight times as many
    const auto wrong = deadpoint("check " + two_blocks + " --set materials.steel.densty=1");
    CHECK(wrong.code == 2);
    CHECK(has(wrong.err, "density"));  // the remedy
}

TEST_CASE("mesh writes a new folder, refuses an old one and replaces it on request")
{
    const Folder folder;
    const auto target = folder / "mesh";
    CHECK(deadpoint("mesh " + two_blocks + " -o " + target).code == 0);
    CHECK(has(content(target + "/mesh.vtu"), "NumberOfPoints=\"54\" NumberOfCells=\"16\""));  // 3 x 3 x 3 nodes each
    CHECK(has(content(target + "/mesh.vtu"), "hash "));
    CHECK(has(content(target + "/surfaces.vtu"), "NumberOfCells=\"48\""));  // 6 x 4 faces each
    CHECK(has(content(target + "/names.csv"), "body 'frame' has 15.6 kg by its parts"));
    CHECK(has(content(target + "/names.csv"), "surface,0,air\n"));

    std::ofstream(target + "/mine.txt") << "mine";
    const auto refused = deadpoint("mesh " + two_blocks + " -o " + target);
    CHECK(refused.code == 5);
    CHECK(has(refused.err, "--force"));
    CHECK(fs::exists(target + "/mine.txt"));
    CHECK_FALSE(fs::exists(target + "/mesh.inp"));
    const auto holds_more = deadpoint("mesh " + two_blocks + " --force -o " + target);
    CHECK(holds_more.code == 5);
    CHECK(has(holds_more.err, "mine.txt', which deadpoint did not write"));
    fs::remove(target + "/mine.txt");
    CHECK(deadpoint("mesh " + two_blocks + " --force --calculix -o " + target).code == 0);
    CHECK(has(content(target + "/mesh.inp"), "*ELEMENT, TYPE=C3D8, ELSET=PART_"));
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator{}) == 1);
}

TEST_CASE("run refuses an existing folder before it computes anything")
{
    const Folder folder;
    fs::create_directories(folder / "results");
    const auto refused = deadpoint("run " + two_blocks + " -o " + (folder / "results"));
    CHECK(refused.code == 5);
    CHECK(has(refused.err, "exists already"));
    CHECK(fs::is_empty(folder / "results"));
}

TEST_CASE("run writes every file with version, hash and warnings, and says where")
{
    const Folder folder;
    const auto target = folder / "results";
    const auto result =
        deadpoint("run " + two_blocks + " -o " + target + " --set 'machine.initial_temperature=30 degC'");
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "results are in " + target));
    for (const char* name : {"case.toml", "summary.json", "history.csv", "temperatures.svg", "fields.pvd"}) {
        CHECK_MESSAGE(fs::exists(fs::path(target) / name), name);
    }
    const auto history = content(target + "/history.csv");
    CHECK(history.find("# deadpoint ") == 0);
    CHECK(has(history, "hash "));
    CHECK(has(history, "body 'frame' has 15.6 kg by its parts"));
    CHECK(has(history, "time [s],top [degC]"));
    CHECK(has(history, "\n0,30"));  // it starts where it was told to
    CHECK(has(content(target + "/summary.json"), "\"interrupted\": false"));
    // The resolved case means the same: same hash.
    const auto hash = history.substr(history.find("hash ") + 5, 16);
    const auto again = folder / "again";
    REQUIRE(deadpoint("run -q " + target + "/case.toml -o " + again).code == 0);
    CHECK(has(content(again + "/history.csv"), hash));
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator{}) == 2);
}

TEST_CASE("probe tells what a probe of the case tells, at the times of the fields")
{
    const Folder folder;
    const auto target = folder / "results", table = folder / "p.csv";
    REQUIRE(deadpoint("run -q " + two_blocks + " -o " + target +
                      " --set 'machine.initial_temperature=30 degC' --set 'output.field_times=[\"5 min\"]'")
                .code == 0);
    const auto probe = "probe " + target + " --at 'top=upper,50 mm,200 mm,50 mm'";
    const auto shown = deadpoint(probe);
    CHECK(shown.code == 0);
    CHECK(has(shown.err, "fields at 2 times"));
    const auto value = [](const std::string& csv, const std::string& time) {
        const auto at = csv.find("\n" + time + ",") + time.size() + 2;
        return std::stod(csv.substr(at));
    };
    const auto history = content(target + "/history.csv");
    for (const char* time : {"300", "600"}) {  // single precision of the files: 2e-6 K
        CHECK(value(shown.out, time) == near(value(history, time), 1e-6));
    }
    REQUIRE(deadpoint(probe + " -o " + table).code == 0);
    CHECK(content(table) == shown.out);
    CHECK(has(content(folder / "p.svg"), "times with fields"));
    CHECK(deadpoint(probe + " -o " + table).code == 5);
    const auto outside = deadpoint("probe " + target + " --at 'upper,50 mm,230 mm,50 mm'");
    CHECK(outside.code == 2);
    CHECK(has(outside.err, "30 mm outside of part 'upper'"));
    CHECK(outside.out.empty());
}

TEST_CASE("tables without comment lines are read as those with them")
{
    const Folder folder;
    const auto usual = folder / "usual", comma = folder / "comma";
    REQUIRE(deadpoint("run -q " + two_blocks + " -o " + usual).code == 0);
    REQUIRE(deadpoint("run -q " + two_blocks + " --csv comma -o " + comma).code == 0);
    const auto table = content(comma + "/history.csv");
    CHECK(table.find("time [s];top [degC]") == 0);
    CHECK(has(table, "\n0;20;"));
    CHECK(has(content(comma + "/tables.json"), "columns: time, "));
    std::ofstream(folder / "m.toml") << "format = 1\nname = \"m\"\nsource = \"s\"\n[[rises]]\ntime = \"7 min\"\n"
                                        "values = { top = \"0.1 K\" }\n";
    const auto of_usual = deadpoint("compare " + usual + " " + (folder / "m.toml"));
    const auto of_comma = deadpoint("compare " + comma + " " + (folder / "m.toml"));
    CHECK(of_comma.code == 0);
    CHECK(of_comma.out.substr(0, of_comma.out.find("comparison is in")) ==
          of_usual.out.substr(0, of_usual.out.find("comparison is in")));
    CHECK(deadpoint("report " + comma + " -o " + (folder / "page.html")).code == 0);
    // By the locale: a point in C, a comma in German, where that can be made.
    setenv("LC_ALL", "C", 1);
    REQUIRE(deadpoint("run -q " + two_blocks + " --csv locale -o " + (folder / "english")).code == 0);
    CHECK(content(folder / "english/history.csv").find("time [s],top [degC]") == 0);
    if (std::system(("localedef -i de_DE -f UTF-8 " + (folder / "de_DE.UTF-8") + " >/dev/null 2>&1").c_str()) == 0) {
        setenv("LOCPATH", (folder / "").c_str(), 1);
        setenv("LC_ALL", "de_DE.UTF-8", 1);
        REQUIRE(deadpoint("run -q " + two_blocks + " --csv locale -o " + (folder / "german")).code == 0);
        CHECK(content(folder / "german/history.csv").find("time [s];top [degC]") == 0);
        unsetenv("LOCPATH");
    }
    unsetenv("LC_ALL");
    const auto wrong = deadpoint("run " + two_blocks + " --csv german -o " + (folder / "x"));
    CHECK(wrong.code == 2);
    CHECK(has(wrong.err, "--csv"));
}

TEST_CASE("run goes on from a result folder, and says when there is none")
{
    const Folder folder;
    const auto first = folder / "first", second = folder / "second";
    REQUIRE(deadpoint("run -q " + two_blocks + " -o " + first).code == 0);
    REQUIRE(deadpoint("run -q " + two_blocks + " --from " + first + " -o " + second).code == 0);
    const auto last_row = [](const std::string& csv) {
        const auto end = csv.find_last_not_of('\n');
        const auto start = csv.rfind('\n', end) + 1;
        return csv.substr(csv.find(',', start), end + 1 - csv.find(',', start));
    };
    const auto first_row = [](const std::string& csv) {
        const auto start = csv.find("\n0,") + 2;
        return csv.substr(start, csv.find('\n', start) - start);
    };
    // Temperatures of the first probe, as printed, go on where they were.
    const auto at_end = last_row(content(first + "/history.csv")),
               at_start = first_row(content(second + "/history.csv"));
    CHECK(at_end.substr(0, at_end.find(',', 1)) == at_start.substr(0, at_start.find(',', 1)));
    const auto nowhere = deadpoint("run " + two_blocks + " --from " + (folder / "none") + " -o " + (folder / "third"));
    CHECK(nowhere.code == 5);
    CHECK(has(nowhere.err, "there is no folder"));
    CHECK(!fs::exists(folder / "third"));
}

TEST_CASE("Ctrl-C keeps the results so far, marked as interrupted, with exit code 130")
{
    const Folder folder;
    const auto target = folder / "results";
    // 100 hours in steps of a second would take minutes.
    const auto result = interrupted("run " + two_blocks + " -o " + target +
                                        " --set 'operation.0.duration=100 h' --set 'numerics.max_step=1 s'",
                                    "time steps\n");
    CHECK(result.code == 130);
    CHECK(has(result.err, "stopping after this step"));
    CHECK(has(content(target + "/summary.json"), "\"interrupted\": true"));
    CHECK(has(content(target + "/history.csv"), "time [s]"));
    CHECK(fs::exists(target + ".checkpoint"));  // to go on from; and nothing else is left
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator{}) == 2);
}

TEST_CASE("an interrupted run keeps the gap, and does not go on to which heat moved it")
{
    const Folder folder;
    const auto target = folder / "results";
    const auto result = interrupted("run " DEADPOINT_SOURCE_DIR "/cases/starter/case.toml --size 3 -o " + target +
                                        " --set output.fields=false --set 'operation.0.duration=100 h'"
                                        " --set 'numerics.max_step=1 s'",
                                    "time steps\n");
    CHECK(result.code == 130);
    CHECK(has(content(target + "/history.csv"), "E_SW"));
    CHECK(!fs::exists(target + "/causes.csv"));
}

TEST_CASE("loads writes every file of a linkage without parts and prints its figures")
{
    const Folder folder;
    const auto target = folder / "loads";
    const auto result = deadpoint("loads " + crank + " -o " + target + " --set crankshaft.model=flexible");
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "slider-crank: 300.0 rpm, 20.00 kN (elastic)"));
    CHECK(has(result.out, "stroke 80.000 mm, bottom dead point with the crank at 270.000 deg"));  // twice the throw
    CHECK(has(result.out, "natural frequencies [Hz]:"));
    CHECK(has(result.out, "loads are in " + target));
    for (const char* name : {"loads.json", "joints.csv", "bearings.csv", "campbell.csv", "slide.svg", "joints.svg",
                             "bearings.svg", "campbell.svg", "linkage.svg"}) {
        CHECK_MESSAGE(fs::exists(fs::path(target) / name), name);
        CHECK_MESSAGE(has(content(fs::path(target) / name), "hash"), name);
    }
    CHECK(has(content(target + "/joints.csv"), "past bottom dead point [deg],time [s],crank speed [rad/s]"));
    CHECK(has(content(target + "/loads.json"), "\"stroke_mm\": "));
    CHECK(has(content(target + "/loads.json"), "\"process_force_kind\": \"elastic\""));
    CHECK(has(content(target + "/bearings.csv"), "flexible bearing_1 x [N]"));
    CHECK(deadpoint("loads " + crank + " -o " + target).code == 5);  // exists
    CHECK(deadpoint("loads -q " + crank + " --force -o " + target).code == 0);
    CHECK_FALSE(has(content(target + "/bearings.csv"), "flexible"));  // the case itself is rigid
}

TEST_CASE("heat prints Table 5 for the shipped press and writes its tables")
{
    const Folder folder;
    const auto target = folder / "heat";
    const auto result = deadpoint("heat -q " DEADPOINT_SOURCE_DIR "/cases/jl75g-60/case.toml --size 3 -o " + target);
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "crank_bearing.1_inner  given"));
    CHECK(has(result.out, "heat tables are in " + target));
    for (const char* name : {"heat.json", "joint_heat.csv", "conductances.csv", "films.csv"}) {
        CHECK_MESSAGE(has(content(fs::path(target) / name), "hash"), name);
    }
    // Zheng et al. 2018, Table 5, 20 to 70 degC: within the rounding of its digits, of which two rows print none behind
    // the point and the first row two.
    struct Row {
        std::string name;
        double tolerance;
        std::vector<double> heat;
    };
    const std::vector<Row> printed{
        {"crank_bearings", 0.0032, {2023.66, 1647.07, 1273.22, 1028.90, 850.11, 727.83}},
        {"crank_pin", 0.5, {927, 697, 494, 379, 304, 258}},
        {"links_3_4_5", 0.0032, {485.7186, 373.725, 275.7306, 219.7338, 183.3358, 160.937}},
        {"links_5_6", 0.0032, {490.7624, 378.7686, 280.7742, 224.7774, 188.3794, 165.9808}},
        {"pivot_h", 0.0032, {222.6266, 179.5456, 141.8498, 120.3094, 106.308, 97.6918}},
        {"links_5_7", 0.0032, {215.1616, 172.0806, 134.3848, 112.8442, 98.843, 90.2268}},
        {"links_7_8_9", 0.0032, {480.4978, 368.5042, 270.5096, 214.5128, 178.115, 155.7162}},
        {"link_9_slider_10", 0.5, {710, 565, 437, 365, 318, 288}},
        {"pivot_p18", 0.0032, {898.0688, 667.1818, 465.1556, 349.712, 274.6738, 228.4964}},
        {"links_8_11", 0.0032, {940.192, 751.8956, 564.9734, 442.8144, 353.4174, 292.2802}},
        {"link_11_slider_12", 0.0032, {303.9306, 243.07, 182.6536, 143.1698, 114.2752, 94.5146}},
        {"guide_10", 0.0032, {362.23, 362.23, 362.23, 362.23, 362.23, 362.23}},
        {"guide_12", 0.0032, {276.8344, 276.8344, 276.8344, 276.8344, 276.8344, 276.8344}},
        {"guide_4", 0.0032, {158.2957, 158.2957, 158.2957, 158.2957, 158.2957, 158.2957}},
    };
    std::istringstream lines(content(target + "/joint_heat.csv"));
    std::string line;
    while (std::getline(lines, line) && line.starts_with("#")) {
    }
    const auto cells = [](const std::string& row) {
        std::vector<std::string> parts;
        std::istringstream in(row);
        for (std::string cell; std::getline(in, cell, ',');) {
            parts.push_back(cell);
        }
        return parts;
    };
    const auto titles = cells(line);
    for (std::size_t row = 0; std::getline(lines, line); ++row) {
        const auto values = cells(line);
        REQUIRE(row < 6);
        for (const auto& [name, tolerance, heat] : printed) {
            CAPTURE(name);
            const auto column = std::find(titles.begin(), titles.end(), name + " [W]") - titles.begin();
            REQUIRE(column < std::ssize(titles));
            CHECK(std::abs(std::stod(values[static_cast<std::size_t>(column)]) - heat[row]) <= tolerance);
        }
    }
    CHECK(deadpoint("heat -q " + crank + " -o " + target).code == 5);                 // exists
    const auto alone = deadpoint("heat -q " + crank + " -o " + target + " --force");  // no parts: no interfaces
    CHECK(alone.code == 0);
    CHECK(deadpoint("heat " + crank + " -o " + (folder / "none") + " --segment 9").code == 2);
    CHECK_FALSE(fs::exists(folder / "none"));
}

TEST_CASE("heat names the surface whose length is missing")
{
    const Folder folder;
    const auto result = deadpoint("heat -q " DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml --size 3 -o " +
                                  (folder / "heat") + " --set 'surfaces.air_crankshaft.film={ law = \"cylinder\" }'");
    CHECK(result.code == 2);
    CHECK(has(result.err, "surfaces.air_crankshaft.film\n  law = \"cylinder\" needs `diameter`"));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("loads names a wrong segment, a linkage that does not close and a missing slide")
{
    const Folder folder;
    const auto out = " -o " + (folder / "loads");
    const auto standing = deadpoint("loads " + crank + out + " --segment 1");
    CHECK(standing.code == 2);
    CHECK(has(standing.err, "stands still in segment 1"));
    CHECK(deadpoint("loads " + crank + out + " --segment 9").code == 2);
    const auto open = deadpoint("loads " + crank + out + " --set 'joints.wrist.centre=[\"0 mm\", \"-70 mm\"]'");
    CHECK(open.code == 2);
    CHECK(has(open.err, "cannot close"));
    CHECK(has(open.err, "help:"));
    CHECK(fs::is_empty(folder.path));  // no half results
}

TEST_CASE("check and run say what to do with a linkage without parts")
{
    const Folder folder;
    const auto plan = deadpoint("check " + crank);
    CHECK(plan.code == 0);
    CHECK(has(plan.out, "a linkage without parts"));
    CHECK(has(plan.out, "revolute, driver"));
    const auto refused = deadpoint("run " + crank + " -o " + (folder / "results"));
    CHECK(refused.code == 2);
    CHECK(has(refused.err, "deadpoint loads"));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("the shipped simple presses pass their check, with the warnings of a run")
{
    for (const char* name : {"slider-crank", "knuckle-joint", "starter", "starter-by-laws"}) {
        CAPTURE(name);
        const auto result = deadpoint("check -q " DEADPOINT_SOURCE_DIR "/cases/" + std::string(name) + "/case.toml");
        const bool asymmetric = std::string(name) == "knuckle-joint";  // its knuckle leans on the guide
        CHECK(result.code == 0);
        CHECK(has(result.out, asymmetric ? "no errors, 1 warning\n" : "no errors, 0 warnings"));
        CHECK(has(result.err, "warning: guide 'guide' carries a moment") == asymmetric);
    }
}

TEST_CASE("run computes the loads first and writes them beside its results")
{
    const Folder folder;
    const auto target = folder / "results";
    const auto result = deadpoint("run -v " DEADPOINT_SOURCE_DIR "/cases/slider-crank/case.toml -o " + target +
                                  " --size 3 --set 'operation.0.duration=5 min' --set output.fields=false");
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "loads: stroke 60.00 mm, largest joint force 395 kN (wrist_pin)"));
    for (const char* name : {"summary.json", "drift.svg", "loads.json", "joints.csv", "bearings.csv", "linkage.svg"}) {
        CHECK_MESSAGE(fs::exists(fs::path(target) / name), name);
    }
}

TEST_CASE("compare holds a run against a reference file, and writes its tables beside the run or where asked")
{
    const Folder folder;
    const auto results = folder / "results";
    // A coarse mesh and half an hour: what is compared is the reading of files, not the press.
    REQUIRE(deadpoint("run -q " DEADPOINT_SOURCE_DIR "/cases/starter/case.toml --size 3 --set output.fields=false"
                      " --set 'operation.0.duration=30 min' --set 'reference.source=made up' --set "
                      "'reference.time=15 min' --set 'reference.rises={ slide = \"0.5 K\" }' --set "
                      "'reference.calibrated_on=[\"films\"]' -o " +
                      results)
                .code == 0);
    const auto summary = content(results + "/summary.json");
    CHECK(has(summary, "\"drift_summary\""));
    CHECK(has(summary, "\"run_was_shorter\": true"));
    // The history's own values at a row, as a reference: no error is left but the rounding to nine digits.
    const auto row = content(results + "/history.csv");
    std::ofstream(folder / "measured.csv") << row;
    const std::string head = "format = 1\nname = \"test bench\"\nsource = \"made up\"\n";
    std::ofstream(folder / "measured.toml")
        << head << "[points.fast]\nset = [\"operation.0.speed=90 rpm\"]\n"
        << "[[rises]]\ntime = \"15 min\"\nvalues = { slide = \"1 K\", upright = \"100 K\" }\n"
        << "[[curves]]\nfile = \"measured.csv\"\ncolumn = \"slide\"\nmeasures = \"temperature\"\nprobe = \"slide\"\n"
        << "[[curves]]\nfile = \"measured.csv\"\ncolumn = \"E_SW\"\nmeasures = \"E_SW\"\n"
        << "[[loads]]\nquantity = \"slide.stroke_mm\"\nlength = \"79 mm\"\n"
        << "[[claims]]\ntext = \"The bearing is warmest.\"\nkind = \"hottest\"\nprobes = [\"bearing_front\"]\n"
        << "[[claims]]\ntext = \"The gap opens.\"\nkind = \"opens\"\n"
        << "[[chain]]\npoint = \"fast\"\ndimension = \"E_BG\"\nat = \"end\"\nvalue = \"1 um\"\n";
    const auto measured = folder / "measured.toml";
    const auto first = deadpoint("compare " + results + " " + measured);
    REQUIRE(first.code == 0);
    CHECK(first.err == "reading the results\ncomparison\n");
    CHECK(has(first.out, "starter press against test bench"));
    CHECK(has(first.out, "slide.stroke_mm"));
    CHECK(has(first.out, "+1.3 %"));  // 80 mm against 79 mm
    CHECK(has(first.out, "calibrated"));
    CHECK(has(first.out, "holds         The bearing is warmest."));
    CHECK(has(first.out, "does not hold The gap opens."));
    CHECK(has(first.out, "comparison is in " + results + "/compare.md"));
    const auto page = content(results + "/compare.md");
    CHECK(has(page, "| slide of measured.csv | K |"));
    CHECK(has(page, "hash "));
    const auto json = content(results + "/compare.json");
    CHECK(has(json, "\"verdict\": \"does not hold\""));
    CHECK(has(json, "\"calibrated\": true"));
    const auto at = json.find("\"name\": \"slide of measured.csv\"");
    REQUIRE(at != std::string::npos);
    const auto rms = json.find("\"rms\": ", at);
    CHECK(std::stod(json.substr(rms + 7)) < 1e-6);  // nine digits of 20 degC

    const auto other = deadpoint("compare -q " + results + " " + measured + " --point fast --baseline " + results +
                                 " -o " + (folder / "fast.md"));
    CHECK(other.code == 0);
    CHECK(has(other.err, "warning: the result was not computed at the operating point 'fast'"));
    CHECK(has(content(folder / "fast.md"), "# starter press against test bench at fast"));
    CHECK(has(content(folder / "fast.md"), "rms: baseline"));
    CHECK(fs::exists(folder / "fast.json"));
    const auto again = "compare -q " + results + " " + measured + " -o " + (folder / "fast.json");
    const auto refused = deadpoint(again);
    CHECK(refused.code == 5);
    CHECK(has(refused.err, "fast.json' exists"));
    CHECK(has(content(folder / "fast.md"), "rms: baseline"));
    CHECK(deadpoint(again + " --force").code == 0);

    std::ofstream(folder / "late.toml") << head
                                        << "[[rises]]\ntime = \"4 h\"\nvalues = { slide = \"1 K\", tool = \"1 K\" }\n";
    const auto late = deadpoint("compare " + results + " " + (folder / "late.toml"));
    CHECK(late.code == 2);
    CHECK(has(late.err, "late.toml:5:8: error[beyond-the-run]"));
    CHECK(has(late.err, "there is no probe 'tool'"));
    CHECK(has(late.err, "2 errors in the reference file"));
    CHECK(deadpoint("compare " + results + " " + (folder / "none.toml")).code == 5);
    CHECK(deadpoint("compare " + (folder / "none") + " " + measured).code == 5);
    CHECK(deadpoint("compare " + folder.path.string() + " " + measured).code == 2);  // no results in it
    CHECK(deadpoint("compare " + results).code == 2);
    fs::remove(results + "/summary.json");
    std::ofstream(results + "/summary.json") << "{}";
    const auto foreign = deadpoint("compare " + results + " " + measured);
    CHECK(foreign.code == 2);
    CHECK(has(foreign.err, "summary.json"));
}

namespace {

/// A study of two-blocks with three powers and a broken point.
std::string study_file(const Folder& folder, const std::string& duration)
{
    const auto path = folder / "study.toml";
    std::ofstream(path) << "format = 1\nname = \"blocks\"\nbase = \"" << two_blocks
                        << "\"\nset = [\"operation.0.duration=" << duration
                        << "\"]\n[[sets]]\nname = \"start\"\n[[sets.axes]]\n"
                           "key = \"machine.initial_temperature\"\nvalues = [\"20 degC\", \"30 degC\", \"40 degC\"]\n"
                           "[[sets]]\nname = \"steps\"\n[[sets.axes]]\nkey = \"numerics.time_tolerance\"\n"
                           "values = [\"1e-30 K\"]\n";
    return path;
}

}  // namespace

TEST_CASE("sweep runs a study, records what fails, and goes on without repeating what is done")
{
    const Folder folder;
    const auto target = folder / "sweep";
    const auto study = study_file(folder, "1 h");
    const auto first = deadpoint("sweep " + study + " -o " + target + " --jobs 2");
    CHECK(first.code == 4);  // one point failed
    CHECK(has(first.out, "4 distinct points"));
    CHECK(has(first.out, "2 at a time: about"));
    CHECK(has(first.out, "results are in " + target));
    CHECK(has(first.out, "the page is " + target + "/report.html"));
    CHECK(has(first.err, "the time step collapsed"));
    const auto table = content(target + "/sweep.csv");
    CHECK(has(table, "40 degC"));
    CHECK(has(table, "failed"));
    const auto warm = target + "/points/initial_temperature=40_degC";
    REQUIRE(fs::exists(warm + "/summary.json"));
    // The same as the run by itself.
    const auto alone = folder / "alone";
    REQUIRE(deadpoint("run -q " + two_blocks +
                      " --set 'operation.0.duration=1 h' --set 'output.fields=false' "
                      "--set 'machine.initial_temperature=40 degC' -o " +
                      alone)
                .code == 0);
    CHECK(content(warm + "/history.csv") == content(alone + "/history.csv"));

    const auto stamp = fs::last_write_time(warm + "/summary.json");
    const auto second = deadpoint("sweep " + study + " -o " + target);
    CHECK(has(second.out, "3 of 4 points are there already"));
    CHECK(fs::last_write_time(warm + "/summary.json") == stamp);
    fs::remove(target + "/report.html");
    CHECK(deadpoint("report " + target).out == "the report is " + target + "/report.html\n");
    CHECK(has(content(target + "/report.html"), "the time step collapsed"));
    const auto mixed = deadpoint("report " + target + " " + warm + " -o " + (folder / "mixed.html"));
    CHECK(mixed.code == 2);
    CHECK(has(mixed.err, "is a study, which has its own page"));
    CHECK(deadpoint("report " + target + " --pictures " + (folder / "pictures")).code == 2);
    // Another size is another study: nothing of it is there.
    CHECK(!has(deadpoint("sweep " + study + " -o " + target + " --size 1.5").out, "there already"));
    CHECK(deadpoint("sweep " + study + " -o " + folder.path.string()).code == 5);  // holds other files
}

TEST_CASE("a study that is stopped keeps what is finished, and no half of a point")
{
    const Folder folder;
    const auto target = folder / "sweep";
    const auto study = study_file(folder, "100 h");
    // 100 hours in steps of a second would take minutes; the first point ends at once.
    std::ofstream(study, std::ios::app) << "[[sets]]\nname = \"long\"\n[[sets.axes]]\n"
                                           "key = \"numerics.max_step\"\nvalues = [\"1 s\"]\n";
    const auto result = interrupted("sweep " + study + " -o " + target + " --jobs 1", "max_step");
    CHECK(result.code == 130);
    CHECK(has(result.out, "results so far"));
    const auto names = [&] {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(target + "/points"))
            found.push_back(entry.path().filename().string());
        return found;
    }();
    CHECK(std::count(names.begin(), names.end(), "initial_temperature=40_degC") == 1);
    for (const auto& name : names)
        CHECK_MESSAGE(name.find("partial") == std::string::npos, name);
    CHECK(has(content(target + "/sweep.csv"), "left"));
}

TEST_CASE("shards of a study that run at once share its points, and a last call gathers them")
{
    const Folder folder;
    const auto study = study_file(folder, "1 h");
    const auto whole = folder / "whole", shared = folder / "shared";
    REQUIRE(deadpoint("sweep " + study + " -o " + whole).code == 4);
    REQUIRE(deadpoint("sweep " + study + " -o " + whole).code == 4);  // its points are now from a call before, as below

    const std::string line =
        std::string(DEADPOINT_COMMAND) + " sweep " + study + " -o " + shared + " --jobs 1 --shard ";
    const auto out = [&](int i) { return folder / ("shard" + std::to_string(i)); };
    std::string all;
    for (int i = 1; i <= 3; ++i)
        all += line + std::to_string(i) + "/3 >" + out(i) + " 2>&1 & ";
    (void)std::system((all + "wait").c_str());
    std::size_t computed = 0;
    for (int i = 1; i <= 3; ++i) {
        const auto text = content(out(i));
        CAPTURE(text);
        CHECK(has(text, "shard " + std::to_string(i) + "/3: "));
        CHECK(has(text, "--gather"));
        const auto at = text.find(" points computed");
        REQUIRE(at != std::string::npos);
        computed += static_cast<std::size_t>(text[at - 1] - '0');
    }
    CHECK(computed == 3);  // of four, of which one fails; none twice
    CHECK_FALSE(fs::exists(shared + "/sweep.csv"));

    const auto gathered = deadpoint("sweep " + study + " -o " + shared + " --gather");
    CHECK(gathered.code == 4);
    // Only a call that computes meshes, and says what it finds then.
    const auto without_mesh_warnings = [](const std::string& text) {
        std::string result;
        std::istringstream in(text);
        for (std::string row; std::getline(in, row);)
            result += has(row, "warning[mass]") ? "" : row + "\n";
        return result;
    };
    CHECK(without_mesh_warnings(content(shared + "/sweep.csv")) ==
          without_mesh_warnings(content(whole + "/sweep.csv")));
    CHECK(fs::exists(shared + "/report.html"));

    // A shard that is repeated finds its points.
    CHECK(has(deadpoint("sweep " + study + " -o " + shared + " --shard 1/3").out,
              "shard 1/3: 0 points computed, 1 were there, 0 failed"));
}

TEST_CASE("shards refuse what would mix studies, and gathering names missing points")
{
    const Folder folder;
    const auto study = study_file(folder, "1 h");
    const auto target = folder / "shared";
    const auto line = "sweep " + study + " -o " + target;
    for (const char* wrong : {"5/4", "0/4", "1", "a/b", "1/4x", "1/0"}) {
        CAPTURE(wrong);
        const auto refused = deadpoint(line + " --shard " + wrong);
        CHECK(refused.code == 2);
        CHECK(has(refused.err, wrong));
    }
    CHECK_FALSE(fs::exists(target));
    REQUIRE(deadpoint(line + " --shard 1/2").code == 0);
    const auto early = deadpoint(line + " --gather");
    CHECK(early.code == 2);
    CHECK(has(early.err, "2 of 4 points are missing:\n  initial_temperature=40_degC\n  time_tolerance=1e-30_K\n"));
    const auto other_count = deadpoint(line + " --shard 2/3");
    CHECK(other_count.code == 2);
    CHECK(has(other_count.err, "is a study of 2 shards"));
    const auto other_study = deadpoint(line + " --size 1.5 --shard 2/2");
    CHECK(other_study.code == 2);
    CHECK(has(other_study.err, "shards of another study have begun"));
    CHECK(deadpoint(line + " --gather --shard 1/2").code == 2);
    // A shard at work excludes itself and a call that works alone, but no other shard.
    const auto held = [&](const std::string& arguments) {
        const auto out = folder / "held";
        const int status = std::system(("flock " + target + "/shards/1-of-2.lock " + std::string(DEADPOINT_COMMAND) +
                                        " " + arguments + " >" + out + " 2>&1")
                                           .c_str());
        return Outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(out)};
    };
    const auto same = held(line + " --shard 1/2");
    CHECK(same.code == 5);
    CHECK(has(same.err, "shard 1/2 of '" + target + "' is being computed"));
    CHECK(held(line).code == 5);
    CHECK(held(line + " --gather").code == 5);
    CHECK(held(line + " --shard 2/2").code == 4);  // one of its points fails
    CHECK(deadpoint(line + " --gather").code == 4);
}

// Value of the first key of this name.
double number(const std::string& json, const std::string& key)
{
    const auto at = json.find("\"" + key + "\": ");
    REQUIRE_MESSAGE(at != std::string::npos, key);
    return std::stod(json.substr(at + key.size() + 4));
}

// The gap moves least with the least heat, so that the optimum is the lower bound of the speed.
void check_optimise(const Folder& folder, const std::string& model)
{
    const auto study = folder / "best.toml", target = folder / "best";
    std::ofstream(study) << "format = 1\nname = \"least\"\nbase = \"press/case.toml\"\nset = "
                            "[\"operation.0.duration=30 min\"]\n[optimise]\nobjective = \"drift\"\nstarts = "
                            "1\nevaluations = 6\n[[optimise.variables]]\nname = \"speed\"\nkeys = "
                            "[\"operation.0.speed\"]\nfrom = \"54 rpm\"\nto = \"66 rpm\"\n";
    const auto found = deadpoint("optimise " + study + " --reduced " + model + " -o " + target);
    REQUIRE_MESSAGE(found.code == 0, found.err);
    CHECK(has(found.out, "54.00   rpm  54 to 66 rpm"));
    const auto json = content(target + "/optimise.json");
    const auto drift = [&](const std::string& run) {
        return number(json.substr(json.find('"' + run + "\": {")), "drift_rms_um");
    };
    CHECK(drift("promised") < 0.95 * drift("before"));
    // a press of 60 states on a coarse mesh is off by some per cent
    CHECK(std::abs(drift("full_run") / drift("promised") - 1) < 0.05);
    for (const auto* file : {"search.csv", "courses.csv", "optimum.toml", "report.html"})
        CHECK_MESSAGE(fs::exists(fs::path(target) / file), file);
    const auto page = content(target + "/report.html");
    fs::remove(target + "/report.html");
    REQUIRE(deadpoint("report " + target).code == 0);
    CHECK(content(target + "/report.html") == page);
}

// Data are a run with more journal friction, so that the fit must find the factor. 60 runs with derivatives of a press
// of 60 states take a few seconds.
void check_calibrate(const Folder& folder, const std::string& press, const std::string& model)
{
    const auto truth = folder / "truth";
    REQUIRE(
        deadpoint("run " + press + " --reduced " + model + " -o " + truth +
                  " --set friction.journals.load_part='\"90 W\"' --set friction.journals.viscous_part='\"0.75 W\"'" +
                  " --set output.history_interval='\"20 min\"'")
            .code == 0);
    std::istringstream history(content(truth + "/history.csv"));
    std::ofstream log(folder / "log.csv");
    log << "time [s],bearing_front [degC],slide [degC]\n";
    for (std::string line; std::getline(history, line);)
        if (std::isdigit(static_cast<unsigned char>(line.front())) != 0) {
            std::istringstream cells(line);
            std::string time, bearing, slide;
            std::getline(std::getline(std::getline(cells, time, ','), bearing, ','), slide, ',');
            log << time << ',' << bearing << ',' << slide << '\n';
        }
    log.close();
    const auto write = [&](const std::string& name, const std::string& keys, const std::string& data) {
        std::ofstream(folder / name)
            << "format = 1\nname = \"shop\"\n[[parameters]]\nname = \"journals\"\nkeys = [\"" << keys
            << "\"]\nfactor = 2\n[[runs]]\nname = \"slow\"\n"
            << data
            << "[[runs]]\nname = \"fast\"\nset = [\"operation.0.speed=90 rpm\"]\nhold_out = "
               "true\n[[sensors]]\ncolumns = [\"*\"]\nnoise = \"0.1 K\"\n[[sensors]]\ncolumns = "
               "[\"E_SW\"]\nnoise = \"1 um\"\n[options]\nstarts = 2\n";
        return folder / name;
    };
    const auto file = write("c.toml", "friction.journals.*_part", "data = \"log.csv\"\n");
    const auto call = [&](const std::string& with, const std::string& more) {
        return deadpoint("calibrate " + press + " " + with + " --reduced " + model + " " + more);
    };
    const auto fitted = call(file, "-o " + (folder / "fitted"));
    CHECK(fitted.code == 0);
    CHECK(has(fitted.out, "Known by the data: journals."));
    CHECK(has(fitted.out, "the data do not contradict the model"));
    const auto table = content(folder / "fitted/parameters.csv");
    const auto row = table.substr(table.find("journals,factor,,") + 17);
    CHECK(std::stod(row) == near(1.5, 0.03));  // 0.1 K of 9 K, and the model's stated error
    CHECK(has(content(folder / "fitted/prediction_fast.csv"), "E_SW upper [um]"));
    CHECK(has(content(folder / "fitted/report.html"), "What the data say"));
    CHECK(call(file, "-o " + (folder / "fitted")).code == 5);
    CHECK(call(file, "--force -o " + (folder / "fitted")).code == 0);

    // The file of values is one more include of the case.
    fs::copy_file(folder / "fitted/calibrated.toml", folder / "press/calibrated.toml");
    std::ofstream(folder / "press/with.toml") << "include = [\"case.toml\", \"calibrated.toml\"]\n";
    CHECK(deadpoint("check " + (folder / "press/with.toml") + " --size 4").code == 0);

    const auto plan = write("p.toml", "friction.journals.*_part", "measure = [\"slide\"]\n");
    const auto planned = call(plan, "--plan -o " + (folder / "planned"));
    CHECK(planned.code == 2);  // the second run measures nothing
    CHECK(has(planned.err, "the run 'fast' measures nothing"));
    const auto wrong =
        call(write("w.toml", "friction.journal.*_part", "data = \"log.csv\"\n"), "-o " + (folder / "no"));
    CHECK(wrong.code == 2);
    CHECK(has(wrong.err, "w.toml:5:"));
    CHECK(has(wrong.err, "did you mean"));
    const auto useless =
        call(write("u.toml", "joints.crank_bearing.clearance", "data = \"log.csv\"\n"), "-o " + (folder / "no"));
    CHECK(useless.code == 2);
    CHECK(has(useless.err, "u.toml:4: the parameter 'journals' has no influence"));
    CHECK_FALSE(fs::exists(folder / "no"));
}

TEST_CASE("a certificate is made by one process, and more of them are refused before any work")
{
    const Folder folder;
    REQUIRE(deadpoint("init " + (folder / "press")).code == 0);
    const auto press = folder / "press/case.toml";
    const auto model = folder / "press.rom";
    for (const std::string& command :
         {"reduce " + press + " -o " + model, "run " + press + " --reduce " + model + " -o " + (folder / "run")}) {
        const auto refused = deadpoint(command + " --certify --ranks 2");
        CHECK(refused.code == 2);
        CHECK(has(refused.err, "a certificate is made by one process, and 2 are wanted\n  help: use --ranks 1"));
        CHECK_FALSE(std::filesystem::exists(model + ".checkpoint"));
    }
}

TEST_CASE("reduce makes a model that runs and sweeps like the press, and says where it does not fit")
{
    const Folder folder;
    REQUIRE(deadpoint("init " + (folder / "press")).code == 0);
    const auto press = folder / "press/case.toml";
    const auto model = folder / "press.rom";
    const auto made =
        deadpoint("reduce " + press +
                  " --size 3 --fields --certify --set reduce.states=60 --set reduce.gap='\"1 um\"' -o " + model);
    REQUIRE(made.code == 0);
    CHECK(has(made.out, "the fields of its states are in press.fields.rom ("));
    CHECK(has(made.out, "as in the case, to a full run"));
    CHECK(has(made.out, "the reduced model is in " + model + ", its large model beside it in press.large.rom"));

    // A reader that knows the file by its description only (docs/rom-file.md).
    for (const auto* file : {"press.rom", "press.large.rom"})
        CHECK(std::system(("python3 -B " + std::string(DEADPOINT_SOURCE_DIR) + "/scripts/shared/rom_file.py " +
                           (folder / file) +
                           (file == std::string("press.rom") ? " " + (folder / "press.fields.rom")
                                                             : " '' " + (folder / "press.certificate.rom")) +
                           " >" + (folder / "read"))
                              .c_str()) == 0);
    CHECK(has(content(folder / "read"), "37 free coefficients"));

    const auto full = folder / "full", quick = folder / "quick";
    REQUIRE(deadpoint("run -q " + press + " --size 3 --set output.fields=false -o " + full).code == 0);
    const auto run = deadpoint("run " + press + " --reduced " + model + " -o " + quick);
    REQUIRE(run.code == 0);
    CHECK(has(run.out, "this run, to the large model"));
    const auto exact = content(full + "/summary.json"), found = content(quick + "/summary.json");
    // 60 states are off by some 0.1 um; so is the law of convection at the mean of a surface
    CHECK(std::abs(number(found, "final_E_SW") - number(exact, "final_E_SW")) < 0.5);
    CHECK(number(found, "states") == 60);
    CHECK(has(found, "\"estimate\""));
    CHECK(has(found, "\"by_cause\""));
    for (const auto* name : {"history.csv", "contributions.csv", "causes.csv", "gaps.csv", "report.html"})
        CHECK_MESSAGE(fs::exists(quick + "/" + name), name);

    // The gap of the lifted field at the end, by its weights and by the deformation. Single precision of the states'
    // fields, some 1e-7 of 300 K, changes it by less than 1 nm.
    CHECK(std::abs(number(found, "E_SW_um_by_adjoint") - number(found, "final_E_SW")) < 0.001);
    CHECK(std::abs(number(found, "E_SW_um_by_deformation") - number(found, "final_E_SW")) < 0.001);
    for (const auto* name : {"fields.pvd", "fields_0000.vtu", "fields_0002.vtu", "view.json"})
        CHECK_MESSAGE(fs::exists(quick + "/" + name), name);

    fs::remove(folder / "press.fields.rom");
    const auto bare = deadpoint("run " + press + " --reduced " + model + " --full-run -o " + (folder / "bare"));
    CHECK(bare.code == 0);
    CHECK(has(bare.out, "um: this run, to a full run\n"));
    const auto compared = content(folder / "bare/summary.json");
    const auto of_full = compared.substr(compared.find("\"full_run\""));
    // the largest difference at any time, so at least that at the end; 60 states are off by some 0.1 um
    const double at_end = std::abs(number(compared, "final_E_SW") - number(exact, "final_E_SW"));
    CHECK(number(of_full, "E_SW_um") > at_end - 1e-6);
    CHECK(number(of_full, "E_SW_um") < 0.5);
    CHECK(number(of_full, "temperature_K") < 0.2);
    CHECK(has(content(folder / "bare/report.html"), "this run, to a full run"));
    CHECK(has(bare.out, "'deadpoint reduce --fields' writes it"));
    CHECK(!fs::exists(folder / "bare/fields.pvd"));

    // (60 rpm / 15 rpm)^0.5 = 2
    const auto with_oil = [&](const std::string& name, const std::string& settings) {
        const auto into = folder / name;
        CHECK(deadpoint("run " + press + " --reduced " + model + " -o " + into + settings).code == 0);
        const auto table = content(into + "/history.csv");
        return table.substr(table.find("\ntime"));
    };
    CHECK(with_oil("oil", " --set 'oil.journals=\"1000 W/m^2/K\"'") ==
          with_oil("growing", " --set 'oil.journals=\"500 W/m^2/K\"' --set "
                              "'oil_with_speed.journals={exponent=0.5,reference_speed=\"15 rpm\"}'"));

    // Films that follow the temperature have no certificate; constant ones have. The bound is that of the error.
    const auto uncertain =
        deadpoint("run " + press + " --reduced " + model + " --certify -o " + (folder / "uncertain"));
    CHECK(uncertain.code == 0);
    CHECK(has(uncertain.out, "no certified bound: the convection of surface 'air_frame' follows its temperature"));
    const auto certain = deadpoint("run " + press + " --reduced " + model +
                                   " --certify --full-run --set surfaces.air_frame.film.emissivity=0 --set "
                                   "surfaces.air_moving.film.emissivity=0 -o " +
                                   (folder / "certain"));
    CHECK(certain.code == 0);
    CHECK(has(certain.out, "at the end of the run: certified"));
    const auto bounds = content(folder / "certain/summary.json");
    const double bound = number(bounds.substr(bounds.find("\"certified\"")), "E_SW_um");
    CHECK(bound >= number(bounds.substr(bounds.find("\"full_run\"")), "E_SW_um") - 0.02);  // that of any time
    CHECK(bound < 5);                                                                      // of a warm-up of 50 um
    CHECK(has(content(folder / "certain/report.html"), "Certified: at the end of the run"));

    const auto hot =
        deadpoint("run " + press + " --reduced " + model + " --set 'machine.ambient=45 degC' -o " + (folder / "hot"));
    CHECK(hot.code == 0);
    CHECK(has(hot.err, "outside the range of the reduced model: ambient"));
    CHECK(has(content(folder / "hot/history.csv"), "outside the range of the reduced model: ambient"));

    // The change of E_SW by the derivatives is that of runs with 0.5 K more and less of ambient, to the errors of the
    // time steps, which are chosen anew in each run.
    const auto ambient = [&](const std::string& degrees, const std::string& more) {
        const auto name = folder / ("ambient" + degrees);
        const auto ran = deadpoint("run " + press + " --reduced " + model + " --set output.fields=false" +
                                   " --set 'machine.ambient=" + degrees + " degC' -o " + name + more);
        REQUIRE_MESSAGE(ran.code == 0, ran.err);
        return ran.out;
    };
    const auto text = ambient("20", " --sensitivities");
    ambient("20.5", "");
    ambient("19.5", "");
    CHECK(has(text, "what moves the gap at the end:"));
    const auto sensitivities = content(folder / "ambient20/sensitivities.csv");
    CHECK(has(sensitivities, "coefficient,value,unit,change,E_SW per unit [um],E_SW by change [um],"));
    for (const auto* name : {"\noperation.speed,", "\noperation.force,", "\nfriction.", "\nsurfaces.", "\njoints."})
        CHECK_MESSAGE(has(sensitivities, name), name);
    const auto row = sensitivities.find("\nambient,20,degC,1,");
    REQUIRE(row != std::string::npos);
    const double derivative = std::stod(sensitivities.substr(row + 19));
    const auto end = [&](const std::string& degrees) {
        return number(content(folder / ("ambient" + degrees + "/summary.json")), "final_E_SW");
    };
    CHECK(std::abs(derivative - (end("20.5") - end("19.5"))) < 0.02 * std::abs(derivative));
    CHECK(has(content(folder / "ambient20/report.html"), "\"strongest\""));

    const auto refused = [&](const std::string& more, int code, const std::string& reason) {
        const auto result = deadpoint("run " + more + " -o " + (folder / "refused"));
        CHECK(result.code == code);
        CHECK_MESSAGE(has(result.err, reason), result.err);
        CHECK(!fs::exists(folder / "refused"));
    };
    refused(press + " --reduced " + model + " --size 2", 2, "--reduced computes without a mesh");
    refused(press + " --reduced " + model + " --set 'parts.bed.material=steel'", 2, "only in this case");
    refused(press + " --reduced " + (folder / "none.rom"), 5, "none.rom");
    refused(press + " --full-run", 2, "--reduced");
    refused(press + " --sensitivities", 2, "--reduced");
    refused(press + " --certify", 2, "--reduced");
    check_calibrate(folder, press, model);
    check_optimise(folder, model);

    fs::resize_file(folder / "press.certificate.rom", 1000);
    refused(press + " --reduced " + model + " --certify", 5, "press.certificate.rom");
    fs::remove(folder / "press.certificate.rom");
    refused(press + " --reduced " + model + " --certify", 2, "there is no certificate");
    fs::resize_file(folder / "press.large.rom", 1000);
    refused(press + " --reduced " + model, 5, "press.large.rom");

    std::ofstream(folder / "map.toml") << "format = 1\nname = \"map\"\nbase = \"press/case.toml\"\n[[sets]]\nname = "
                                          "\"map\"\n[[sets.axes]]\nkey = \"operation.0.speed\"\nvalues = [\"60 rpm\", "
                                          "\"80 rpm\"]\n[[sets.axes]]\nkey = \"machine.ambient\"\nvalues = [\"18 "
                                          "degC\", \"22 degC\"]\n";
    const auto map = deadpoint("sweep " + (folder / "map.toml") + " --reduced " + model + " -o " + (folder / "map"));
    CHECK(map.code == 0);
    const auto table = content(folder / "map/sweep.csv");
    CHECK(has(table, "done,80 rpm,80,22 degC,22,"));
    CHECK(!has(table, "failed"));
    CHECK(has(content(folder / "map/report.html"), "80 rpm"));

    // In two shards: the same table.
    const auto parted = "sweep " + (folder / "map.toml") + " --reduced " + model + " -o " + (folder / "parted");
    CHECK(deadpoint(parted + " --shard 1/2").code == 0);
    CHECK(has(deadpoint(parted + " --gather").err, "2 of 4 points are missing"));
    CHECK(deadpoint(parted + " --shard 2/2").code == 0);
    CHECK(deadpoint(parted + " --gather").code == 0);
    const auto without_wall_times = [](const std::string& of) {  // the last column but one
        std::string result;
        std::istringstream in(of);
        for (std::string line; std::getline(in, line);)
            result += line.substr(0, line.rfind(',', line.rfind(',') - 1)) + '\n';
        return result;
    };
    CHECK(without_wall_times(content(folder / "parted/sweep.csv")) == without_wall_times(table));

    // The same study with more points continues from whole rows; those whose course is drawn are computed again.
    auto longer = content(folder / "map.toml");
    longer.replace(longer.find("\"18 degC\", "), 10,
                   "\"16 degC\", \"17 degC\", \"18 degC\", \"19 degC\", \"20 degC\", \"21 degC\", ");
    std::ofstream(folder / "map.toml") << longer;
    const auto all = deadpoint("sweep " + (folder / "map.toml") + " --reduced " + model + " -o " + (folder / "map"));
    CHECK(all.code == 0);
    const auto points = content(folder / "map/points.csv");
    fs::resize_file(folder / "map/points.csv", points.size() - 5);  // as if it had been killed in the last row
    const auto again = deadpoint("sweep " + (folder / "map.toml") + " --reduced " + model + " -o " + (folder / "map"));
    CHECK(again.code == 0);
    CHECK(has(again.out, "11 of 14 points are there already"));  // the cut one is not, nor a drawn one of each speed
    const auto without_times = [](const std::string& of) {
        std::string result;
        std::istringstream in(of);
        for (std::string line, cell; std::getline(in, line);) {
            const auto from = line.find("done,");  // behind the name, which may hold a comma
            REQUIRE(from != std::string::npos);
            std::istringstream cells(
                line.substr(from, line.rfind(',') - from));  // before the checksum, which is of the time too
            for (int column = 0; std::getline(cells, cell, ','); ++column)
                result += column == 3 ? "" : cell + ",";  // the wall time
            result += '\n';
        }
        return result;
    };
    const auto rows = [](const std::string& of) { return of.substr(of.rfind("reason,checksum\n") + 16); };
    CHECK(without_times(rows(content(folder / "map/points.csv"))) == without_times(rows(points)));
}

TEST_CASE("sensitivity tells which parameters matter, writes what it says and refuses what it cannot do")
{
    const Folder folder;
    const auto model = folder / "blocks.rom", study = folder / "study.toml", target = folder / "matters";
    REQUIRE(deadpoint("reduce -q " + two_blocks + " -o " + model).code == 0);
    const auto write = [&](const std::string& method, const std::string& key) {
        std::ofstream(study) << "format = 1\nname = \"matters\"\nbase = \"" << two_blocks
                             << "\"\n[sensitivity]\npoints = 16\ntrajectories = 4\nmethod = \"" << method
                             << "\"\nsamples = true\n[[sensitivity.parameters]]\nname = \"room\"\nkeys = "
                                "[\"machine.ambient\"]\nshift = \"5 K\"\n[[sensitivity.parameters]]\nname = "
                                "\"air\"\nkeys = [\""
                             << key << "\"]\nfactor = 2\n";
    };
    const auto call = "sensitivity " + study + " --reduced " + model + " -o " + target;
    write("sobol", "surfaces.air.film.coefficient");
    const auto found = deadpoint(call);
    REQUIRE(found.code == 0);
    CHECK(has(found.out, "top at the end: "));
    CHECK(has(found.out, "64 runs in "));
    CHECK(has(found.out, "results are in " + target));
    for (const auto* file : {"indices.csv", "indices_over_time.csv", "samples.csv", "sensitivity.json", "report.html"})
        CHECK_MESSAGE(fs::exists(fs::path(target) / file), file);
    CHECK(has(content(target + "/indices.csv"), "\ntop,end,room,"));
    // 64 rows of samples: the room within 5 K, the end of the run within what the room may give.
    std::istringstream samples(content(target + "/samples.csv"));
    std::size_t rows = 0;
    for (std::string line; std::getline(samples, line);)
        rows += line.starts_with("#") || line.starts_with("parameter") ? 0 : 1;
    CHECK(rows == 64);

    // The same study gives the same numbers on one thread.
    REQUIRE(deadpoint(call + " --force -j 1").code == 0);
    const auto once = content(target + "/indices.csv");
    REQUIRE(deadpoint(call + " --force -j 3").code == 0);
    CHECK(once == content(target + "/indices.csv"));
    const auto there = deadpoint(call);
    CHECK(there.code == 5);
    CHECK(has(there.err, "exists"));

    const auto page = content(target + "/report.html");
    fs::remove(target + "/report.html");
    REQUIRE(deadpoint("report " + target).code == 0);
    CHECK(content(target + "/report.html") == page);

    write("morris", "surfaces.air.film.coefficient");
    const auto screened = deadpoint(call + " --force");
    CHECK(screened.code == 0);
    CHECK(has(screened.out, "mu* [K]"));
    CHECK(has(screened.out, "12 runs in "));
    write("morris", "surfaces.air.film.coeficient");
    const auto wrong = deadpoint(call + " --force");
    CHECK(wrong.code == 2);
    CHECK(has(wrong.err, "study.toml:15:9: error[unknown-key]: sensitivity.parameters.1.keys.0"));
    CHECK(has(wrong.err, "did you mean 'surfaces.air.film.coefficient'?"));
    write("morris", "materials.steel.density");
    const auto fixed = deadpoint(call + " --force");
    CHECK(fixed.code == 2);
    CHECK(has(fixed.err, "changes what a reduced model cannot change"));
    std::ofstream(study) << "format = 1\nname = \"n\"\nbase = \"" << two_blocks << "\"\n[[sets]]\nname = \"s\"\n";
    CHECK(has(deadpoint(call + " --force").err, "has no section [sensitivity]"));
    const auto optimise = "optimise " + study + " --reduced " + model + " -o " + (folder / "best");
    CHECK(has(deadpoint(optimise).err, "has no section [optimise]"));
    std::ofstream(study) << "format = 1\nname = \"n\"\nbase = \"" << two_blocks
                         << "\"\n[[optimise.variables]]\nkeys = [\"surfaces.air.film.coefficient\"]\nfactor = 2\n";
    const auto without_chain = deadpoint(optimise);
    CHECK(without_chain.code == 2);
    CHECK(has(without_chain.err, "the base case has no dimension chain"));
    CHECK_FALSE(fs::exists(folder / "best"));
}

TEST_CASE("run --reduce builds after the run what reduce builds by itself")
{
    const Folder folder;
    fs::create_directory(folder / "apart");
    const auto together = folder / "press.rom", apart = folder / "apart/press.rom", target = folder / "results";
    const auto run = deadpoint("run " + two_blocks + " --certify --fields --reduce " + together + " -o " + target);
    REQUIRE(run.code == 0);
    CHECK(has(run.out, "results are in " + target));
    CHECK(has(run.out, "as in the case, to a full run"));
    REQUIRE(deadpoint("reduce " + two_blocks + " --certify --fields -o " + apart).code == 0);
    for (const std::string file : {"press.rom", "press.large.rom", "press.certificate.rom", "press.fields.rom"})
        CHECK(content(folder / file) == content(folder / ("apart/" + file)));
    CHECK_FALSE(fs::exists(together + ".checkpoint"));
    const auto refining = deadpoint("run " + two_blocks + " --accuracy 1K --reduce " + together + " -o " + target);
    CHECK(refining.code == 2);
    CHECK(has(refining.err, "--reduce builds on the mesh of the case"));
}

TEST_CASE("run leaves a page beside its results and says how to open it")
{
    const Folder folder;
    const auto target = folder / "results";
    const auto result = deadpoint("run --quiet " + two_blocks + " -o " + target);
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "deadpoint view " + target));
    const auto page = content(target + "/report.html");
    CHECK(has(page, "<h1>two blocks</h1>"));
    CHECK(has(page, "</html>\n"));
    CHECK(has(content(target + "/view.json"), "\"temperature_K\""));
    CHECK_FALSE(has(content(target + "/view.json"), "\"displacement_m\""));  // no dimension chain, no deformation
}

TEST_CASE("report puts folders on one page, and does not replace a file unasked")
{
    const Folder folder;
    REQUIRE(deadpoint("run --quiet " + two_blocks + " -o " + (folder / "a")).code == 0);
    REQUIRE(deadpoint("loads --quiet " + crank + " -o " + (folder / "b")).code == 0);
    const auto page = folder / "both.html";
    const std::string both = "report " + (folder / "a") + " " + (folder / "b");
    const auto nameless = deadpoint(both);
    CHECK(nameless.code == 2);
    CHECK(has(nameless.err, "-o compared.html"));
    CHECK(deadpoint(both + " -o " + page).out == "the report is " + page + "\n");
    CHECK(has(content(page), "<h1>two blocks, "));
    const auto refused = deadpoint(both + " -o " + page);
    CHECK(refused.code == 5);
    CHECK(has(refused.err, "--force"));
    CHECK(deadpoint(both + " --force -o " + page).code == 0);

    fs::remove(folder / "a/report.html");
    CHECK(deadpoint("report " + (folder / "a")).code == 0);  // its own page needs no name and is renewed
    CHECK(deadpoint("report " + (folder / "a")).code == 0);
    CHECK(fs::exists(folder / "a/report.html"));
    const auto empty = deadpoint("report " + folder.path.string());
    CHECK(empty.code == 2);
    CHECK(has(empty.err, "holds no results"));
}

TEST_CASE("view makes the page where it is missing and hands it to the browser")
{
    const Folder folder;
    REQUIRE(deadpoint("run --quiet " + two_blocks + " -o " + (folder / "a")).code == 0);
    fs::remove(folder / "a/report.html");
    const auto browser = folder / "browser";
    std::ofstream(browser) << "#!/bin/sh\nbasename \"$1\" >\"" << (folder / "shown") << "\"\n";
    fs::permissions(browser, fs::perms::owner_all);
    setenv("BROWSER", browser.c_str(), 1);
    const auto result = deadpoint("view " + (folder / "a"));
    unsetenv("BROWSER");
    CHECK(result.code == 0);
    CHECK(has(result.out, "opened "));
    CHECK(content(folder / "shown") == "report.html\n");
    CHECK(fs::exists(folder / "a/report.html"));
    CHECK(deadpoint("view " + (folder / "nothing")).code != 0);
    // Openers that find no desktop are not heard: the page is named instead.
    fs::create_directories(folder / "bin");
    for (const char* name : {"xdg-open", "open", "wslview"}) {
        const auto opener = folder / ("bin/" + std::string(name));
        std::ofstream(opener) << "#!/bin/sh\necho no method available >&2\nexit 3\n";
        fs::permissions(opener, fs::perms::owner_all);
    }
    const std::string path = std::getenv("PATH");
    setenv("PATH", ((folder / "bin") + ":" + path).c_str(), 1);
    const auto nowhere = deadpoint("view " + (folder / "a"));
    setenv("PATH", path.c_str(), 1);
    CHECK(nowhere.code == 0);
    CHECK(has(nowhere.out, "found no browser to open; the page is "));
    CHECK(nowhere.err.empty());
}

TEST_CASE("init tells editors the schema of its case, which lies beside it")
{
    const Folder folder;
    REQUIRE(deadpoint("init " + (folder / "plain")).code == 0);
    REQUIRE(deadpoint("init --step " DEADPOINT_SOURCE_DIR "/cases/c-frame/press.step " + (folder / "drawn")).code == 0);
    const auto schema = deadpoint("schema case").out;
    for (const char* name : {"plain", "drawn"}) {
        const auto file = folder / (std::string(name) + "/case.toml");
        const auto text = content(file);
        CHECK(text.starts_with("#:schema ./case.schema.json\n"));
        CHECK(content(folder / (std::string(name) + "/case.schema.json")) == schema);
    }
    CHECK(content(folder / "plain/case.toml").ends_with(content(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml")));
    CHECK(content(folder / "drawn/case.toml").ends_with(content(DEADPOINT_SOURCE_DIR "/cases/c-frame/case.toml")));
}

TEST_CASE("check --view draws a case that passes and one that does not")
{
    const Folder folder;
    const auto page = folder / "case.check.html";
    fs::copy_file(two_blocks, folder / "case.toml");
    setenv("BROWSER", "true", 1);
    const auto good = deadpoint("check --view " + (folder / "case.toml"));
    CHECK(good.code == 0);
    CHECK(has(good.out, "opened "));
    CHECK(has(content(page), "\"severity\":\"warning\""));  // the stated mass is 2.5 % off
    CHECK_FALSE(has(content(page), "\"severity\":\"error\""));
    CHECK(fs::file_size(page) < 3e6);
    // Both blocks are drawn although the probe is off its part; the page next to the case is renewed.
    const auto wrong =
        deadpoint("check --view --set \"probes.top.position=[\\\"90 mm\\\", \\\"300 mm\\\", \\\"0 mm\\\"]\" " +
                  (folder / "case.toml"));
    CHECK(wrong.code == 2);
    CHECK(has(wrong.err, "probes.top"));
    CHECK(has(content(page), "{\"kind\":\"probe\",\"name\":\"top\"}"));
    CHECK(has(content(page), "{\"name\":\"upper\",\"body\":\"frame\""));
    // Where a face of the dimension chain is not there, the dimension ends where the case says.
    CHECK(deadpoint("check -q --view --size 6 --set \"surfaces.table_top.position=-905 mm\" -o " +
                    (folder / "off.html") + " " DEADPOINT_SOURCE_DIR "/cases/starter/case.toml")
              .code == 2);
    CHECK(has(content(folder / "off.html"), "\"table\":[0.0,-0.905,0.0]"));
    // A case that cannot even be read as TOML has no picture.
    fs::remove(page);
    std::ofstream(folder / "broken.toml") << "format = = 1\n";
    CHECK(deadpoint("check --view " + (folder / "broken.toml")).code == 2);
    CHECK_FALSE(fs::exists(folder / "broken.check.html"));
    // A file that the user names is not replaced unasked.
    std::ofstream(folder / "mine.html") << "mine";
    CHECK(deadpoint("check -q --view -o " + (folder / "mine.html") + " " + (folder / "case.toml")).code == 5);
    CHECK(content(folder / "mine.html") == "mine");
    CHECK(deadpoint("check -q --view --force -o " + (folder / "mine.html") + " " + (folder / "case.toml")).code == 0);
    unsetenv("BROWSER");
    CHECK(deadpoint("check -o x.html " + (folder / "case.toml")).code != 0);  // only with --view
}

TEST_CASE("check --view and init replace no file that deadpoint did not write")
{
    const Folder folder;
    fs::copy_file(two_blocks, folder / "case.toml");
    const auto page = folder / "case.check.html";
    setenv("BROWSER", "true", 1);
    std::ofstream(page) << "mine";
    const auto foreign = deadpoint("check -q --view " + (folder / "case.toml"));
    CHECK(foreign.code == 5);
    CHECK(has(foreign.err, "case.check.html' exists\n  help: choose another name, or add --force"));
    CHECK(content(page) == "mine");
    CHECK(deadpoint("check -q --view --force " + (folder / "case.toml")).code == 0);
    CHECK(deadpoint("check -q --view " + (folder / "case.toml")).code == 0);  // its own page is renewed
    std::ofstream(page, std::ios::app) << "<p>a note of mine</p>\n";
    CHECK(deadpoint("check -q --view " + (folder / "case.toml")).code == 5);
    CHECK(has(content(page), "a note of mine"));
    unsetenv("BROWSER");

    fs::create_directories(folder / "press");
    std::ofstream(folder / "press/case.schema.json") << "mine";
    const auto schema = deadpoint("init " + (folder / "press"));
    CHECK(schema.code == 5);
    CHECK(has(schema.err, "case.schema.json' exists already and is not overwritten"));
    CHECK(content(folder / "press/case.schema.json") == "mine");
    CHECK_FALSE(fs::exists(folder / "press/case.toml"));
    std::ofstream(folder / "press/case.schema.json") << deadpoint("schema case").out;
    CHECK(deadpoint("init " + (folder / "press")).code == 0);  // as it would be written
}

TEST_CASE("no command replaces a file of results, not even by force")
{
    const Folder folder;
    const auto results = folder / "results";
    REQUIRE(deadpoint("run -q " + two_blocks + " -o " + results + " --set 'output.field_times=[\"5 min\"]'").code == 0);
    std::ofstream(folder / "m.toml") << "format = 1\nname = \"m\"\nsource = \"s\"\n[[rises]]\ntime = \"7 min\"\n"
                                        "values = { top = \"0.1 K\" }\n";
    const auto compare = "compare " + results + " " + (folder / "m.toml");
    const auto probe = "probe " + results + " --at 'upper,50 mm,200 mm,50 mm'";
    const auto refused = [&](const std::string& line, const char* name) {
        const auto before = content(results + "/" + name);
        const auto outcome = deadpoint(line + " --force");
        CAPTURE(line);
        CAPTURE(outcome.err);
        CHECK(outcome.code == 5);
        CHECK(has(outcome.err, std::string(name) + "' belongs to the results in '"));
        CHECK(content(results + "/" + name) == before);
    };
    refused(compare + " -o " + results + "/summary", "summary.json");
    refused(compare + " -o " + results + "/deadpoint", "deadpoint.json");
    refused(probe + " -o " + results + "/history.csv", "history.csv");
    refused(probe + " -o " + results + "/temperatures.csv", "temperatures.svg");  // the chart beside it
    refused("report " + results + " -o " + results + "/history.csv", "history.csv");
    refused("check --view " + two_blocks + " -o " + results + "/case.toml", "case.toml");
    refused("report " + results + " -o " + results + "/../results/view.json", "view.json");

    // Page and comparison of the folder are made anew, unless they are not as deadpoint wrote them.
    CHECK(deadpoint(compare).code == 0);
    CHECK(deadpoint(compare).code == 0);
    std::ofstream(results + "/compare.md") << "mine";
    CHECK(deadpoint(compare).code == 5);
    CHECK(content(results + "/compare.md") == "mine");
    CHECK(deadpoint(compare + " --force").code == 0);
    std::ofstream(results + "/report.html") << "mine";
    CHECK(deadpoint("report " + results).code == 5);
    CHECK(deadpoint("report --force " + results).code == 0);
    CHECK(deadpoint("report " + results).code == 0);

    const auto chart = deadpoint(probe + " -o " + (folder / "p.svg"));
    CHECK(chart.code == 2);
    CHECK(has(chart.err, "is the name of the chart beside the table"));
    std::ofstream(folder / "deadpoint.1") << "mine";
    CHECK(deadpoint("--write-manual " + folder.path.string()).code == 5);
    CHECK(content(folder / "deadpoint.1") == "mine");
}

TEST_CASE("--accuracy refuses what is no accuracy of something in the case")
{
    const Folder folder;
    const auto refused = [&](const std::string& value) {
        const auto result = deadpoint("run " + two_blocks + " --accuracy " + value + " -o " + (folder / "results"));
        CHECK(result.code == 2);
        CHECK_FALSE(fs::exists(folder / "results"));
        return result.err;
    };
    CHECK(has(refused("3"), "numerics.accuracy"));
    CHECK(has(refused("3"), "\"0.1 K\" for the rises"));
    CHECK(has(refused("3kg"), "neither a temperature difference nor a length"));
    CHECK(has(refused("3degC"), "neither a temperature difference nor a length"));
    CHECK(has(refused("0K"), "not positive"));
    CHECK(has(refused("-1um"), "not positive"));
    CHECK(has(refused("0.2um"), "needs a dimension chain"));
    REQUIRE(deadpoint("run --quiet " + two_blocks + " -o " + (folder / "first")).code == 0);
    CHECK(has(refused("0.1K --from " + (folder / "first")), "leave out --accuracy"));
}

TEST_CASE("--accuracy refines, says what it took, and leaves the sizes")
{
    const Folder folder;
    const auto cooling = two_blocks + " --set \"machine.initial_temperature=60 degC\" ";
    const auto result = deadpoint("run --quiet " + cooling + "--accuracy 0.02K -o " + (folder / "a"));
    REQUIRE(result.code == 0);
    CHECK(has(result.out, "accuracy of 0.0200 K reached: change 0.0"));
    CHECK(has(result.out, "estimate [K]"));
    const auto table = content(folder / "a/accuracy.csv");
    CHECK(has(table, "cells,finer parts,largest rise [K],change [K],estimate [K],worst part,time [s]"));
    CHECK(has(content(folder / "a/summary.json"), "\"reached\": true"));
    CHECK(has(content(folder / "a/sizes.toml"), "[parts.lower]\nsize = \""));
    // the case that was written gives the same without asking for an accuracy
    const auto again = deadpoint("run --quiet " + (folder / "a/case.toml") + " -o " + (folder / "b"));
    REQUIRE(again.code == 0);
    const auto history = content(folder / "a/history.csv"), repeated = content(folder / "b/history.csv");
    CHECK(history.substr(history.find("\ntime")) == repeated.substr(repeated.find("\ntime")));

    const auto limited = deadpoint("run --quiet " + cooling +
                                   "--accuracy 0.00001K --set numerics.accuracy_cells=40 -o " + (folder / "c"));
    CHECK(limited.code == 0);
    CHECK(has(limited.out, "not reached: "));
}

TEST_CASE("init --step writes a case from an assembly that passes its check, or nothing")
{
    const Folder folder;
    const std::string drawing = DEADPOINT_SOURCE_DIR "/cases/c-frame/press.step";
    const auto result = deadpoint("init --step " + drawing + " " + (folder / "press"));
    CHECK(result.code == 0);
    CHECK(has(result.out, "17 solids in 4 bodies, 19 contacts: 6 of them in 4 joints"));
    CHECK(has(result.out, "slide: slide, wrist_pin"));
    CHECK(content(folder / "press/press.step") == content(drawing));
    const auto file = folder / "press/case.toml";
    const auto text = content(file);
    const auto checked = deadpoint("check " + file + " --size 3");
    CHECK(checked.code == 0);
    CHECK(has(checked.out, "rod_crank.connecting_rod_crankshaft"));
    const auto again = deadpoint("init --step " + drawing + " " + (folder / "press"));
    CHECK(again.code == 5);
    CHECK(has(again.err, "name another folder"));
    CHECK(content(file) == text);

    const auto renamed =
        deadpoint("init --step " + drawing + " --body ram=slide --body rod=connecting_rod,wrist_pin " + (folder / "c"));
    CHECK(renamed.code == 0);
    CHECK(has(renamed.out, "ram: slide\n"));
    CHECK(has(renamed.out, "rod: connecting_rod, wrist_pin\n"));
    CHECK(has(content(folder / "c/case.toml"), "[bodies.ram]"));
    const auto unnamed = deadpoint("init --step " + drawing + " --body slide " + (folder / "d"));
    CHECK(unnamed.code == 2);
    CHECK(has(unnamed.err, "write it like --body slide="));

    const auto none = deadpoint("init --step " + (folder / "none.step") + " " + (folder / "a"));
    CHECK(none.code == 5);
    CHECK(has(none.err, "there is no file"));
    const auto other = deadpoint("init --step " DEADPOINT_SOURCE_DIR "/README.md " + (folder / "b"));
    CHECK(other.code == 2);
    CHECK(has(other.err, "is not a STEP file"));
    CHECK_FALSE(std::filesystem::exists(folder / "a"));
    CHECK_FALSE(std::filesystem::exists(folder / "b"));
}

TEST_CASE("init --step writes the name of its drawing as a text, whatever is in it, and leaves nothing if it fails")
{
    const Folder folder;
    const fs::path source = DEADPOINT_SOURCE_DIR "/cases/c-frame/press.step";
    const auto shown = [&](const std::string& name, const std::string& written) {
        CAPTURE(name);
        const auto drawing = folder.path / name;
        fs::copy_file(source, drawing);
        const auto target = folder / "drawn";
        const auto made = deadpoint("init --step '" + drawing.string() + "' " + target);
        CAPTURE(made.err);
        CHECK(made.code == 0);
        const auto text = content(target + "/case.toml");
        CHECK(has(text, "step = " + written + "\n"));
        CHECK_FALSE(has(text, "\ninclude"));
        CHECK(deadpoint("check -q --size 3 " + target + "/case.toml").code == 0);
        CHECK(std::distance(fs::directory_iterator(target), fs::directory_iterator{}) == 3);
        fs::remove_all(target);
    };
    shown("a \"quoted\" back\\slash.step", R"("a \"quoted\" back\\slash.step")");
    shown("x\ninclude = [\"y.toml\"]\n#.step", R"("x_include = [\"y.toml\"]_#.step")");
    shown("bell\a tab\t\xff.step", "\"bell_ tab__.step\"");
    shown("Presse \xC3\xBC.step", "\"Presse \xC3\xBC.step\"");

    // The schema that is in the way ends it after drawing and case are there.
    fs::create_directories(folder / "full");
    std::ofstream(folder / "full/case.schema.json") << "mine";
    CHECK(deadpoint("init --step " + source.string() + " " + (folder / "full")).code == 5);
    CHECK(std::distance(fs::directory_iterator(folder / "full"), fs::directory_iterator{}) == 1);
}

TEST_CASE("messages about the command line are in words of the program")
{
    const std::vector<std::pair<std::string, const char*>> lines{
        {"check " + two_blocks + " --size", "--size needs a value"},
        {"check " + two_blocks + " --size big", "'big' is no value that --size takes"},
        {"check", "CASE is missing"},
        {"check " + two_blocks + " more", "there is no room for 'more' in this command"},
        {"check " + two_blocks + " -o x.html", "--output works with --view only"},
        {"sweep s.toml -o s --gather --shard 1/2", "exclude each other"}};
    for (const auto& [line, said] : lines) {
        CAPTURE(line);
        const auto outcome = deadpoint(line);
        CAPTURE(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.err, std::string("error: ")));
        CHECK(has(outcome.err, said));
        CHECK(has(outcome.err, "help: "));
    }
}
