#include "deadpoint/casefile/reference/reference.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::casefile;
namespace fs = std::filesystem;

namespace {

using Scratch = ScratchFolder;

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

const std::string head = "format = 1\nname = \"n\"\nsource = \"s\"\n";

/// A result of three hours with one probe, a chain and one figure of loads.
ResultContents three_hours() { return {{"top", "side"}, {"E_SW", "E_BG"}, {"seat.peak_N"}, true, 10800, false}; }

/// What is said about a reference file with this body, beside which the CSV file lies.
std::string error_of(const std::string& body, const std::string& csv = "", const std::string& point = "")
{
    const Scratch scratch;
    (void)scratch.file("m.csv", csv);
    const auto contents = three_hours();
    try {
        (void)read_reference(scratch.file("r.toml", head + body), point, &contents);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::string rise_curve = "[[curves]]\nfile = \"m.csv\"\ncolumn = \"top\"\nmeasures = \"rise\"\nprobe = \"top\"\n";
const fs::path press = DEADPOINT_SOURCE_DIR "/cases/jl75g-60";

}  // namespace

TEST_CASE("values of a reference file arrive in SI, those of the wanted point only")
{
    const Scratch scratch;
    (void)scratch.file("m.csv", "t [min],top [degF],gap\n0,32,0\n30,50,-1\n60,68,5\n");
    const auto file = scratch.file("r.toml", head + R"(
[points.fast]
set = ["operation.0.speed=300 rpm"]
[[rises]]
time = "3 h"
values = { top = "2 K" }
[[rises]]
point = "fast"
time = "90 min"
values = { top = "3 K" }
[[chain]]
dimension = "E_SW"
at = "largest"
value = "-4 um"
[[loads]]
quantity = "seat.peak_N"
force = "21.4 kN"
[[curves]]
file = "m.csv"
column = "top"
time_column = "t"
measures = "temperature"
probe = "top"
[[curves]]
file = "m.csv"
column = "gap"
time_column = "t"
unit = "um"
measures = "E_SW"
until = "30 min"
opposite_sign = true
)");
    const auto contents = three_hours();
    const auto base = read_reference(file, "", &contents);
    REQUIRE(base.rises.size() == 1);
    CHECK(base.rises[0].time == 10800);
    CHECK(base.rises[0].values.at("top") == 2);
    CHECK(base.chain.at(0).value == near(-4e-6, 1e-15));
    CHECK(*base.loads.at(0).force == 21400);
    REQUIRE(base.curves.size() == 2);
    CHECK(base.curves[0].name == "top of m.csv");
    CHECK(base.curves[0].time == std::vector<double>{0, 1800, 3600});
    // 32, 50 and 68 degF are 0, 10 and 20 degC; the offset costs the last digits.
    CHECK(base.curves[0].value[1] == near(283.15, 1e-12));
    CHECK(base.curves[0].value[2] == near(293.15, 1e-12));
    CHECK(base.curves[1].time == std::vector<double>{0, 1800});
    CHECK(base.curves[1].value[1] == near(1e-6, 1e-12));
    const auto fast = read_reference(file, "fast");
    CHECK(fast.rises.at(0).time == 5400);
    CHECK(fast.chain.empty());
    CHECK(fast.points.at("fast").set.size() == 1);
}

TEST_CASE("what a result does not have is said with its place")
{
    const auto probe = error_of("[[rises]]\ntime = \"1 h\"\nvalues = { tpo = \"1 K\" }\n");
    CHECK(has(probe, "r.toml:6:18: error[unknown-name]: rises.0.values.tpo"));
    CHECK(has(probe, "did you mean 'top'?"));
    CHECK(has(probe, "1 error in the reference file; nothing was compared"));
    const auto late = error_of("[[rises]]\ntime = \"4 h\"\nvalues = { top = \"1 K\" }\n");
    CHECK(has(late, "error[beyond-the-run]: rises.0.time"));
    CHECK(has(late, "ends after"));
    CHECK(error_of("[[rises]]\ntime = \"3 h\"\nvalues = { top = \"1 K\" }\n") == "");
    CHECK(has(error_of("[[loads]]\nquantity = \"seat.paek_N\"\nforce = \"1 N\"\n"), "did you mean 'seat.peak_N'?"));
    const auto elsewhere = error_of("[[loads]]\nquantity = \"seat.B.rms_N\"\nforce = \"1 N\"\n");
    CHECK(has(elsewhere, "help: after 'seat.' it has: peak_N;"));
    CHECK(has(error_of("[[loads]]\nquantity = \"shaft.B\"\nnumber = 1\n"), "help: after '' it has: seat;"));
    CHECK(has(error_of("[[loads]]\nquantity = \"seat.peak_N\"\nlength = \"1 mm\"\n"),
              "by its name the figure is a force"));
    CHECK(has(error_of("[[claims]]\ntext = \"x\"\nkind = \"hottest\"\nprobes = [\"top\", \"sied\"]\n"),
              "claims.0.probes.1"));
    ResultContents no_chain = three_hours();
    no_chain.dimensions.clear();
    const Scratch scratch;
    const auto file =
        scratch.file("r.toml", head + "[[chain]]\ndimension = \"E_SW\"\nat = \"end\"\nvalue = \"1 um\"\n");
    CHECK_THROWS_WITH_AS((void)read_reference(file, "", &no_chain),
                         doctest::Contains("the result has no dimension chain"), InputError);
    CHECK_NOTHROW((void)read_reference(file));
    CHECK_THROWS_AS((void)read_reference("no/such/file.toml"), IoError);
}

TEST_CASE("keys that do not go together, points that do not exist")
{
    CHECK(has(error_of(""), "there is nothing to compare"));
    CHECK(has(error_of("[[rises]]\ntime = 3\nvalues = { top = \"1 K\" }\n"), "error[missing-unit]: rises.0.time"));
    CHECK(has(error_of("[[chain]]\ndimension = \"E_SW\"\nat = \"time\"\nvalue = \"1 um\"\n"),
              "'time' is missing for at = \"time\""));
    CHECK(has(error_of("[[chain]]\ndimension = \"E_SW\"\nat = \"end\"\ntime = \"1 h\"\nvalue = \"1 um\"\n"),
              "at = \"end\" does not use 'time'"));
    CHECK(has(error_of(rise_curve + "opposite_sign = true\n", "time [s],top [K]\n0,1\n"),
              "measures = \"rise\" does not use 'opposite_sign'"));
    CHECK(has(error_of("[[loads]]\nquantity = \"seat.peak_N\"\n"), "the figure needs one value"));
    const std::string claim = "[[claims]]\ntext = \"x\"\nkind = ";
    CHECK(has(error_of(claim + "\"warmer\"\nprobes = [\"top\"]\n"), "'than' is missing for kind = \"warmer\""));
    CHECK(has(error_of(claim + "\"opens\"\nshare = 0.5\n"), "kind = \"opens\" does not use 'share'"));
    CHECK(has(error_of(claim + "\"steady\"\n"), "the claim names no time to check"));
    CHECK(has(error_of(claim + "\"steady\"\nat_least = \"2 h\"\nat_most = \"1 h\"\n"), "lies before the earliest"));
    CHECK(has(error_of(claim + "\"unchecked\"\n"), "'reason' is missing"));
    CHECK(has(error_of(claim + "\"hotest\"\n"), "did you mean \"hottest\"?"));
    const std::string rise = "[[rises]]\npoint = \"fsat\"\ntime = \"1 h\"\nvalues = { top = \"1 K\" }\n";
    const std::string points = "[points.fast]\nset = [\"operation.0.speed=300 rpm\"]\n";
    CHECK(has(error_of(points + rise), "error[unknown-name]: rises.0.point"));
    CHECK(
        has(error_of("[points.fast]\nset = [\"speed\"]\n" + claim + "\"opens\"\n"), "a setting is written path=value"));
    CHECK(has(error_of(points + claim + "\"opens\"\n", "", "fsat"), "did you mean 'fast'?"));
    CHECK(has(error_of(points + claim + "\"opens\"\n", "", "fast"), "no value belongs to the operating point 'fast'"));
    CHECK(has(error_of(points + claim + "\"opens\"\npoint = \"fast\"\n"), "all values belong to operating points"));
}

TEST_CASE("what is wrong with the CSV file of a curve is said with both places")
{
    const auto nan = error_of(rise_curve, "time [s],top [K]\n0,1\n1,nan\n");
    CHECK(has(nan, "r.toml:5:8: error[curve]: curves.0.file"));
    CHECK(has(nan, "m.csv:3: 'nan' in column 'top' is not a finite number"));
    CHECK(has(nan, "help: correct the cell"));
    CHECK(has(error_of(rise_curve, "time [s],top [K]\n0,1\n5,1\n5,2\n"), "m.csv:4: the times do not increase"));
    CHECK(has(error_of(rise_curve, "time [s],tpo [K]\n0,1\n"), "there is no column 'top'"));
    CHECK(has(error_of(rise_curve, "time,top [K]\n0,1\n"), "the column 'time'"));
    CHECK(has(error_of(rise_curve, "time [s],top [degC]\n0,1\n"), "error[unit-mismatch]: curves.0.file"));
    CHECK(has(error_of(rise_curve + "unit = \"kg\"\n", "time [s],top\n0,1\n"), "curves.0.unit"));
    CHECK(has(error_of(rise_curve, "time [s],top [K]\n"), "no rows below the headings"));
    CHECK(has(error_of(rise_curve, "time [s],top [K]\n-1,0\n"), "the times begin before the run"));
    CHECK(has(error_of(rise_curve, "time [h],top [K]\n0,0\n4,1\n"), "error[beyond-the-run]: curves.0.file"));
    CHECK(error_of(rise_curve + "until = \"3 h\"\n", "time [h],top [K]\n0,0\n4,1\n") == "");
    CHECK(has(error_of(rise_curve + "until = \"1 min\"\n", "time [h],top [K]\n1,0\n"), "no row is left"));
    CHECK(has(error_of("[[curves]]\nfile = \"none.csv\"\ncolumn = \"a\"\nmeasures = \"E_SW\"\n"),
              "error[missing-file]: curves.0.file"));
}

TEST_CASE("the paper's reference files hold every printed figure of a run, at its operating point")
{
    const auto printed = nlohmann::json::parse(content(fs::path(DEADPOINT_TEST_DATA) / "paper_figures.json"));
    const auto rises = printed.at("temperature_rise_K");
    const auto errors = printed.at("thermal_error_um");
    const auto has_rise = [](const ReferenceFile& file, const std::string& probe, double value) {
        for (const auto& entry : file.rises) {
            const auto found = entry.values.find(probe);
            if (found != entry.values.end() && std::abs(found->second - value) < 1e-9) {
                return entry.time == 3 * 3600;
            }
        }
        return false;
    };
    const auto has_chain = [](const ReferenceFile& file, ReferenceChain::At at, double um) {
        for (const auto& entry : file.chain) {
            if (entry.dimension == "E_SW" && entry.at == at && entry.opposite_sign &&
                std::abs(entry.value - um * 1e-6) < 1e-15) {
                return true;
            }
        }
        return false;
    };
    const auto has_peak = [](const ReferenceFile& file, double seconds) {
        for (const auto& entry : file.times) {
            if (entry.of == ReferenceTime::Of::largest_E_SW && entry.value == seconds) {
                return true;
            }
        }
        return false;
    };
    const auto base = read_reference(press / "paper.toml");
    for (const auto& [probe, value] : rises.at("base_piling").items()) {
        CHECK(has_rise(base, probe, value));
    }
    for (const char* which : {"improved", "measured"}) {
        CHECK(has_chain(base, ReferenceChain::At::largest, errors.at("base").at(which).at("max")));
        CHECK(has_chain(base, ReferenceChain::At::end, errors.at("base").at(which).at("equilibrium")));
    }
    const auto traditional = read_reference(press / "paper.toml", "traditional");
    CHECK(has_chain(traditional, ReferenceChain::At::largest, errors.at("base").at("traditional").at("max")));
    CHECK(has_chain(traditional, ReferenceChain::At::end, errors.at("base").at("traditional").at("equilibrium")));
    std::size_t loads = 0;
    for (const auto& [model, name] : {std::pair{"traditional", "rigid"}, {"improved", "flexible"}}) {
        for (const char* seat : {"B", "E"}) {
            for (const char* axis : {"x", "y"}) {
                const std::string wanted =
                    std::string("crankshaft.") + name + ".seats." + seat + ".peak_" + axis + "_N";
                for (const auto& load : (std::string(name) == "rigid" ? traditional : base).loads) {
                    loads += load.quantity == wanted &&
                             *load.force == printed.at("load_spectrum_peak_N").at(model).at(seat).at(axis);
                }
            }
        }
    }
    CHECK(loads == 8);

    struct Sweep {
        const char* key;
        std::vector<std::string> points;  // "": the base case
    };
    const std::vector<Sweep> sweeps{
        {"speed_rpm", {"", "speed_300", "speed_400", "speed_500"}},
        {"piling_force_kN", {"force_100", "force_200", "", "force_400"}},
        {"bearing_stiffness_N_per_m", {"stiffness_5e7", "stiffness_1e8", "", "stiffness_1e9"}}};
    for (const auto& [key, points] : sweeps) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            CAPTURE(key);
            CAPTURE(i);
            const auto file = points[i].empty() ? base : read_reference(press / "paper-sweeps.toml", points[i]);
            for (const char* probe : {"A", "B", "C", "D", "E", "F"}) {
                CHECK(has_rise(file, probe, rises.at(key).at(probe).at(i)));
            }
            CHECK(has_chain(file, ReferenceChain::At::largest, errors.at(key).at("max").at(i)));
            CHECK(has_chain(file, ReferenceChain::At::end, errors.at(key).at("equilibrium").at(i)));
            CHECK(has_peak(file, errors.at(key).at("time_of_max_s").at(i)));
        }
    }
    const auto no_load = read_reference(press / "paper-sweeps.toml", "no_load");
    for (const auto& [probe, value] : rises.at("no_load").items()) {
        CHECK(has_rise(no_load, probe, value));
    }
}

TEST_CASE("the points of the paper's sweeps are settings that the case takes")
{
    const auto base = read_reference(press / "paper.toml");
    CHECK(base.claims.size() >= 14);
    const auto points = reference_points(press / "paper-sweeps.toml");
    CHECK(points.size() == 10);  // three speeds, no load, three forces, three stiffnesses
    const auto at = [&](const std::string& point) {
        return read_case(press / "case.toml", points.at(point).set).value;
    };
    CHECK(at("speed_400").operation.at(0).speed == near(400 * 3.14159265358979 / 30, 1e-13));
    CHECK(at("force_100").operation.at(0).force == 100e3);
    CHECK(at("no_load").operation.at(0).force == 0);
    const auto stiff = at("stiffness_1e9");
    for (const auto& bearing : stiff.crankshaft->bearings) {
        CHECK(bearing.stiffness[1][1] == 1e9);
    }
    const auto traditional = read_reference(press / "paper.toml", "traditional");
    CHECK(read_case(press / "case.toml", traditional.points.at("traditional").set).value.crankshaft->model ==
          Crankshaft::Model::rigid);
}

TEST_CASE("the rises that the shipped press shows beside its result are those of the paper's reference file")
{
    const auto shown = read_case(press / "case.toml").value.reference;
    const auto file = read_reference(press / "paper.toml");
    std::map<std::string, double> first;
    for (const auto& entry : file.rises) {
        CHECK(entry.time == shown->time);
        first.insert(entry.values.begin(), entry.values.end());  // keeps the first of two printed values
    }
    CHECK(first == shown->rises);
}

TEST_CASE("docs/reference-file.md is the page of reference files of this program")
{
    // To renew the page, run this test with DEADPOINT_RENEW_DOCS=1.
    const fs::path page = DEADPOINT_SOURCE_DIR "/docs/reference-file.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(page) << reference_file_page();
    }
    CHECK(content(page) == reference_file_page());
}
