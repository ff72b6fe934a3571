/// Requirement: a calibration file is read with all that it names, and every mistake is told with its place and remedy.
#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/reference/reference.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>

using namespace deadpoint;
using namespace deadpoint::casefile;
namespace fs = std::filesystem;

namespace {

const fs::path starter = fs::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml";

/// Keys as they are: patterns are study's.
std::vector<std::string> keys_of(const Case& /*input*/, const std::vector<std::string>& patterns)
{
    for (const auto& pattern : patterns)
        if (pattern == "wrong")
            throw InputError("the case has no number 'wrong'\n  help: did you mean 'right'?");
    return patterns;
}

const std::string head = "format = 1\nname = \"n\"\n";
const std::string film =
    "[[parameters]]\nname = \"film\"\nkeys = [\"surfaces.air_frame.film.coefficient\"]\nfactor = 2\n";
const std::string run = "[[runs]]\nname = \"r\"\ndata = \"log.csv\"\n";
const std::string sensor = "[[sensors]]\ncolumns = [\"*\"]\nnoise = \"0.2 K\"\n";
const std::string logged = "time [min],slide [degC],upright [degC]\n0,20,20\n10,21,20.5\n20,22,20.75\n";

CalibrationFile read(const std::string& body, const std::string& csv = logged, bool plan = false)
{
    const ScratchFolder scratch;
    (void)scratch.file("log.csv", csv);
    return read_calibration(scratch.file("c.toml", body), {starter, {}, FileAccess::below, keys_of}, plan);
}

std::string error_of(const std::string& body, const std::string& csv = logged, bool plan = false)
{
    try {
        (void)read(body, csv, plan);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& piece)
{
    if (text.find(piece) != std::string::npos)
        return true;
    MESSAGE(text);
    return false;
}

}  // namespace

TEST_CASE("a logger's file becomes curves in SI units, each with its sensor")
{
    const auto file = read(
        head + film + run + "set = [\"operation.0.speed=90 rpm\"]\nuntil = \"15 min\"\n" +
        "[[sensors]]\ncolumns = [\"slide\"]\nnoise = \"0.1 K\"\nbias = \"0.5 K\"\nmodel_error = \"0.3 K\"\n" + sensor);
    REQUIRE(file.runs.front().curves.size() == 2);
    const auto& slide = file.runs.front().curves.front();
    CHECK(slide.output == "slide");
    CHECK(slide.sensor == 0);
    CHECK(slide.time == std::vector<double>{0, 600});
    CHECK(slide.value.back() == near(294.15, 1e-14));
    CHECK(file.runs.front().curves.back().sensor == 1);
    CHECK(file.sensors.front().bias_sigma == 0.5);
    CHECK(file.sensors.front().model_sigma == 0.3);
    CHECK(file.parameters.front().prior == near(std::log(2), 1e-5));
    CHECK(file.runs.front().input->operation.front().speed == near(90 * 2 * M_PI / 60, 1e-5));
}

TEST_CASE("columns of other names, rises, gaps and dimensions are read as the file says")
{
    const auto file = read(head + film + run + "shows = \"rise\"\ngaps = \"leave_out\"\nignore = [\"room\"]\n" +
                               "[[sensors]]\ncolumns = [\"TC4\"]\nprobe = \"slide\"\nnoise = \"0.1 K\"\n" +
                               "[[sensors]]\ncolumns = [\"E_SW\"]\nnoise = \"1 um\"\n",
                           "time [s],TC4 [K],room [degC],E_SW [um]\n60,1.5,20,-2\n120,,20,nan\n180,2.5,20,-6\n");
    const auto& curves = file.runs.front().curves;
    REQUIRE(curves.size() == 2);
    CHECK(curves[0].rise);
    CHECK(curves[0].output == "slide");
    CHECK(curves[0].value == std::vector<double>{1.5, 2.5});
    CHECK(curves[1].of_gap);
    CHECK(curves[1].value.back() == near(-6e-6, 1e-5));
    CHECK(file.notes.size() == 2);  // one for each column with a gap
}

TEST_CASE("reference files are read as compare reads them")
{
    const ScratchFolder scratch;
    (void)scratch.file(
        "paper.toml",
        "format = 1\nname = \"p\"\nsource = \"s\"\n[[rises]]\ntime = \"1 h\"\nvalues = { slide = \"3 K\" }\n"
        "[[rises]]\ntime = \"2 h\"\nvalues = { slide = \"3.5 K\" }\n[[rises]]\ntime = \"2 h\"\nvalues = { slide = "
        "\"4.5 K\" "
        "}\n[[chain]]\ndimension = \"E_SW\"\nat = "
        "\"end\"\nvalue = \"5 um\"\nopposite_sign = true\n[[chain]]\ndimension = \"E_SW\"\nat = \"largest\"\n"
        "value = \"6 um\"\n");
    const auto path =
        scratch.file("c.toml", head + film +
                                   "[[runs]]\nname = \"r\"\nreference = \"paper.toml\"\n[[sensors]]\ncolumns "
                                   "= [\"E_SW\"]\nnoise = \"1 um\"\n" +
                                   sensor);
    const auto file = read_calibration(path, {starter, {}, FileAccess::below, keys_of}, false);
    const auto& curves = file.runs.front().curves;
    REQUIRE(curves.size() == 2);
    CHECK(curves[0].output == "E_SW");
    CHECK(curves[0].time == std::vector<double>{10800});  // the end of the case
    CHECK(curves[0].value == std::vector<double>{-5e-6});
    CHECK(curves[1].value == std::vector<double>{3, 4});
    REQUIRE(file.notes.size() == 2);
    CHECK(has(file.notes[0], "'slide' has 2 values at"));
    CHECK(has(file.notes[1], "1 value of"));
}

TEST_CASE("curves of more values than the statistics can take are thinned, which is said")
{
    std::string csv = "time [s],slide [degC]\n";
    for (int k = 0; k < 1000; ++k)
        csv += std::to_string(k) + ",20\n";
    const auto file = read(head + film + run + sensor, csv);
    CHECK(file.runs.front().curves.front().time.size() == most_values_of_curve);
    CHECK(file.runs.front().curves.front().time.back() == 999);
    CHECK(has(file.notes.front(), "300 of 1000 values of 'slide' are used"));
    const auto few = read(head + film + run + "interval = \"100 s\"\n" + sensor, csv);
    CHECK(few.runs.front().curves.front().time.size() == 10);
}

TEST_CASE("mistakes in data are told with their place")
{
    const auto wrong_column = error_of(head + film + run + sensor, "time [s],slid [degC]\n0,20\n");
    CHECK(has(wrong_column, "c.toml:9:"));
    CHECK(has(wrong_column, "the case has no probe and no dimension 'slid'"));
    CHECK(has(wrong_column, "did you mean 'slide'?"));
    CHECK(has(error_of(head + film + run + sensor, "time [s],slide\n0,20\n"), "states no unit"));
    CHECK(has(error_of(head + film + run + sensor, "time [s],slide [kg]\n0,20\n"), "column 'slide'"));
    const auto gap = error_of(head + film + run + sensor, "time [s],slide [degC]\n0,20\n5,nan\n");
    CHECK(has(gap, "log.csv:3"));
    CHECK(has(gap, "gaps = \"leave_out\""));
    CHECK(has(error_of(head + film + run + sensor, "time [s],slide [degC]\n5,20\n5,21\n"), "log.csv:3"));
    CHECK(has(error_of(head + film + run + sensor, "time [h],slide [degC]\n5,20\n"), "lies beyond the run"));
    CHECK(has(error_of(head + film + run + "[[sensors]]\ncolumns = [\"upright\"]\nnoise = \"1 K\"\n"),
              "no sensor says how exact 'slide' is"));
    CHECK(has(error_of(head + film + run + "[[sensors]]\ncolumns = [\"*\"]\nnoise = \"1 um\"\n"),
              "'slide' of the run 'r' is a temperature"));
    CHECK(
        has(error_of(head + film + run + "[[sensors]]\ncolumns = [\"*\"]\nnoise = \"0 K\"\n"), "the fit is singular"));
}

TEST_CASE("a logger's decimal commas are read as compare reads them, and a heading that stands twice is refused")
{
    const auto logger = [](const std::string& name) {
        return content(fs::path(DEADPOINT_SOURCE_DIR) / "tests/data/loggers" / name);
    };
    const std::string sensors = "[[sensors]]\ncolumns = [\"bearing_front\"]\nnoise = \"0.1 K\"\n"
                                "[[sensors]]\ncolumns = [\"E_SW\"]\nnoise = \"1 um\"\n";
    const auto file = read(head + film + run + sensors, logger("decimal-commas.csv"));
    const auto& curves = file.runs.front().curves;
    REQUIRE(curves.size() == 2);
    CHECK(curves[0].time.at(1) == near(60, 1e-14));
    CHECK(curves[0].value.at(1) == near(273.15 + 20.6684, 1e-14));  // "20,6684"
    CHECK(curves[1].value.at(3) == near(-5.7906e-6, 1e-14));        // "-5,7906"

    const ScratchFolder scratch;
    const std::string reference = "format = 1\nname = \"n\"\nsource = \"s\"\n[[curves]]\nfile = \"log.csv\"\ncolumn = "
                                  "\"bearing_front\"\nmeasures = \"temperature\"\nprobe = \"bearing_front\"\n";
    (void)scratch.file("log.csv", logger("decimal-commas.csv"));
    const auto compared = read_reference(scratch.file("r.toml", reference));
    CHECK(compared.curves.front().value == curves[0].value);

    const auto twice = error_of(head + film + run + sensors, logger("column-twice.csv"));
    CHECK(has(twice, "the heading 'bearing_front' stands twice, in columns 2 and 4"));
    (void)scratch.file("log.csv", logger("column-twice.csv"));
    CHECK_THROWS_WITH_AS((void)read_reference(scratch.file("r.toml", reference)),
                         doctest::Contains("the heading 'bearing_front' stands twice, in columns 2 and 4"), InputError);
    CHECK_NOTHROW(
        (void)read(head + film + run + "ignore = [\"bearing_front\"]\n" + sensors, logger("column-twice.csv")));
}

TEST_CASE("mistakes in parameters, runs and candidates are told with their place")
{
    const auto key = error_of(head + "[[parameters]]\nname = \"p\"\nkeys = [\"wrong\"]\nfactor = 2\n" + run + sensor);
    CHECK(has(key, "c.toml:5:"));
    CHECK(has(key, "did you mean 'right'?"));
    CHECK(has(error_of(head + film + "lower = 1.5\n" + run + sensor),
              "the limits exclude the value that the case states"));
    CHECK(has(error_of(head + film + "kind = \"shift\"\n" + run + sensor), "the uncertainty is missing"));
    const auto set = error_of(head + film + run + "set = [\"operation.0.sped=1 rpm\"]\n" + sensor);
    CHECK(has(set, "c.toml:10:"));
    CHECK(has(set, "the case refuses this setting"));
    CHECK(has(error_of(head + film + "[[runs]]\nname = \"r\"\n" + sensor), "has no measured values"));
    CHECK(has(error_of(head + film + run + "hold_out = true\n" + sensor), "no run is fitted"));
    CHECK(has(error_of(head + film + run + run + sensor), "two runs are called 'r'"));
    CHECK(has(error_of(head + film + "[[runs]]\nname = \"r\"\nmeasure = [\"slid\"]\n" + sensor, logged, true),
              "did you mean 'slide'?"));
    CHECK(
        has(error_of(head + film + run + sensor + "[[candidates]]\nname = \"c\"\nrun = \"s\"\nmeasure = [\"slide\"]\n"),
            "there is no run 's'"));
}

TEST_CASE("an alternative has the case of each run with its own laws, and its mistakes have a place")
{
    const std::string other = "[[alternatives]]\nname = \"warm air\"\n";
    const auto file = read(head + film + run + "set = [\"operation.0.speed=90 rpm\"]\n" + sensor + other +
                           "set = [\"surfaces.air_frame.film.coefficient=8 W/m^2/K\"]\n");
    CHECK(file.alternatives.front().place.find("c.toml:15") != std::string::npos);
    REQUIRE(file.runs.front().alternatives.size() == 1);
    const auto& with = *file.runs.front().alternatives.front();
    CHECK(std::get<casefile::FilmCoefficient>(with.surfaces.at("air_frame").film->law).value == 8);
    CHECK(with.operation.front().speed == near(90 * 2 * M_PI / 60, 1e-5));
    CHECK(has(error_of(head + film + run + sensor + other), "the alternative is the case itself"));
    const std::string oil = "set = [\"oil.pins=1 W/m^2/K\"]\n";
    CHECK(has(error_of(head + film + run + sensor + other + oil + other + oil),
              "two alternatives are called 'warm air'"));
    const auto set = error_of(head + film + run + sensor + other + "set = [\"surfaces.air_frame.film.coeff=8\"]\n");
    CHECK(has(set, "c.toml:15:"));
    CHECK(has(set, "the case refuses this setting"));
    CHECK(has(error_of(head + film + run + sensor + other + "reduced = \"log.csv\"\n" + oil), "give `share`"));
}

TEST_CASE("shifts have the unit of their keys, limits count from the case's value")
{
    const auto file =
        read(head + film + "lower = 0.5\n" +
             "[[parameters]]\nname = \"room\"\nkeys = [\"machine.ambient\"]\nkind = \"shift\"\nsigma = \"2 "
             "K\"\nupper = \"5 K\"\n" +
             run + sensor);
    CHECK(file.parameters[0].least == near(std::log(0.5), 1e-5));
    CHECK(file.parameters[0].most == 1e300);
    CHECK(file.parameters[1].prior == 2);
    CHECK(file.parameters[1].most == 5);
    CHECK(file.parameters[1].place.find("c.toml:9") != std::string::npos);
}

TEST_CASE("planned curves have times and no values")
{
    const auto file = read(
        head + film + "[[runs]]\nname = \"r\"\nmeasure = [\"slide\"]\ninterval = \"30 min\"\n" + sensor, logged, true);
    const auto& curve = file.runs.front().curves.front();
    CHECK(curve.time == std::vector<double>{1800, 3600, 5400, 7200, 9000, 10800});
    CHECK(curve.value.empty());
}

TEST_CASE("a file of a case replaces values that other files state, items of lists included")
{
    const ScratchFolder scratch;
    fs::copy_file(starter, scratch.path / "base.toml");
    (void)scratch.file("found.toml",
                       "replace = [\"surfaces.air_frame.film.coefficient=7 W/m^2/K\", \"operation.0.speed=90 rpm\"]\n");
    const auto whole = scratch.file("case.toml", "include = [\"base.toml\", \"found.toml\"]\n");
    const auto input = read_case(whole).value;
    CHECK(input.operation.front().speed == near(90 * 2 * M_PI / 60, 1e-5));
    CHECK(read_case(whole, {"operation.0.speed=30 rpm"}).value.operation.front().speed ==
          near(30 * 2 * M_PI / 60, 1e-5));
    (void)scratch.file("found.toml", "replace = [\"operation.0.speed=90 kg\"]\n");
    CHECK_THROWS_WITH_AS((void)read_case(whole), doctest::Contains("found.toml:1:12"), InputError);
    (void)scratch.file("found.toml", "replace = \"operation.0.speed=90 rpm\"\n");
    CHECK_THROWS_WITH_AS((void)read_case(whole), doctest::Contains("needs a list of texts"), InputError);
}

TEST_CASE("docs/calibration-file.md is the page of calibration files of this program")
{
    // To renew the page, run this test with DEADPOINT_RENEW_DOCS=1.
    const fs::path page = DEADPOINT_SOURCE_DIR "/docs/calibration-file.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr)
        std::ofstream(page) << calibration_file_page();
    CHECK(content(page) == calibration_file_page());
}
