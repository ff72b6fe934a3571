#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/reference/reference.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::casefile;
namespace fs = std::filesystem;

namespace {

struct Scratch : ScratchFolder {
    Scratch() { fs::copy_file(fs::path(DEADPOINT_SOURCE_DIR) / "cases/slider-crank/case.toml", path / "case.toml"); }
};

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

const std::string head = "format = 1\nname = \"n\"\nbase = \"case.toml\"\n";
const std::string set = "[[sets]]\nname = \"s\"\n";
const std::string speed = set + "[[sets.axes]]\nkey = \"operation.0.speed\"\n";

StudyFile read(const std::string& body)
{
    const Scratch scratch;
    return read_study(scratch.file("s.toml", head + body));
}

/// What is said about a study file with this body.
std::string error_of(const std::string& body)
{
    try {
        (void)read(body);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a study file is read: steps, ranges, several keys, labels, limits")
{
    const auto study = read(R"(set = ["numerics.size=40 mm"]
[limits]
largest = "10 um"
[[sets]]
name = "speed and force"
[[sets.axes]]
key = "operation.0.speed"
values = [" 60 rpm", "90 rpm"]
labels = ["slow", "fast"]
[[sets.axes]]
key = "operation.0.force"
from = "0 kN"
to = "0.3 kN"
count = 4
[[sets]]
name = "both"
[[sets.axes]]
name = "pair"
keys = ["operation.0.speed", "operation.0.force"]
values = [["60 rpm", "1 kN"], ["70 rpm", "2 kN"]]
[[sets]]
name = "numbers"
[[sets.axes]]
keys = ["machine.half_model"]
values = [true, false]
[[sets]]
name = "base"
)");
    CHECK(fs::path(study.base).filename() == "case.toml");
    CHECK(fs::path(study.base).is_absolute());
    CHECK(study.set == std::vector<std::string>{"numerics.size=40 mm"});
    CHECK(*study.limits->largest == near(1e-5, 1e-15));
    CHECK_FALSE(study.limits->final);
    REQUIRE(study.sets.size() == 4);
    const auto& first = study.sets[0].axes;
    REQUIRE(first.size() == 2);
    CHECK(first[0].name == "speed");
    CHECK(first[0].keys == std::vector<std::string>{"operation.0.speed"});
    CHECK(first[0].values == std::vector<std::vector<std::string>>{{"60 rpm"}, {"90 rpm"}});
    CHECK(first[0].labels == std::vector<std::string>{"slow", "fast"});
    // Not 0.30000000000000004 kN or 0.19999999999999998 kN.
    CHECK(first[1].values == std::vector<std::vector<std::string>>{{"0 kN"}, {"0.1 kN"}, {"0.2 kN"}, {"0.3 kN"}});
    CHECK(first[1].labels[3] == "0.3 kN");
    const auto& pair = study.sets[1].axes.at(0);
    CHECK(pair.name == "pair");
    CHECK(pair.values[1] == std::vector<std::string>{"70 rpm", "2 kN"});
    CHECK(pair.labels[1] == "70 rpm / 2 kN");
    CHECK(study.sets[2].axes.at(0).values[1] == std::vector<std::string>{"false"});
    CHECK(study.sets[3].axes.empty());
}

TEST_CASE("a single value holds for all keys of a step")
{
    const auto study = read(set + "[[sets.axes]]\nkeys = [\"machine.ambient\", \"machine.initial_temperature\"]\n"
                                  "values = [\"20 degC\", \"25 degC\"]\n");
    const auto& axis = study.sets[0].axes[0];
    CHECK(axis.values[1] == std::vector<std::string>{"25 degC", "25 degC"});
    CHECK(axis.labels[1] == "25 degC");
    CHECK(axis.name == "ambient");
}

TEST_CASE("a key that the case does not know, and a value that it refuses, are said at their place")
{
    const auto key = error_of(set + "[[sets.axes]]\nkey = \"operation.0.sped\"\nvalues = [\"60 rpm\", \"70 rpm\"]\n");
    CHECK(has(key, "s.toml:7:7: error[unknown-key]: sets.0.axes.0.key"));
    CHECK(has(key, "the base case refuses 'operation.0.sped=60 rpm': there is no key 'sped' here"));
    CHECK(has(key, "did you mean 'speed'?"));
    CHECK(has(key, "1 error in the study file; nothing was computed"));  // not once more for 70 rpm
    const auto unit = error_of(speed + "values = [\"60 rpm\", \"70 mm\", 80]\n");
    CHECK(has(unit, "s.toml:8:21: error[unit-mismatch]: sets.0.axes.0.values.1"));
    CHECK(has(unit, "s.toml:8:30: error[missing-unit]: sets.0.axes.0.values.2"));
    CHECK(has(unit, "2 errors in the study file"));
    const auto zipped = error_of(set + "[[sets.axes]]\nkeys = [\"operation.0.speed\", \"operation.0.force\"]\n"
                                       "values = [[\"60 rpm\", \"1 kN\"], [\"60 rpm\", \"-1 kN\"]]\n");
    CHECK(has(zipped, "s.toml:8:42: error[out-of-range]: sets.0.axes.0.values.1.1"));
    CHECK(has(error_of(speed + "from = \"60 mm\"\nto = \"80 mm\"\ncount = 2\n"),
              "error[unit-mismatch]: sets.0.axes.0.from"));
    CHECK(has(error_of(set + "[[sets.axes]]\nkey = \"operation.7.speed\"\nvalues = [\"60 rpm\"]\n"),
              "error[override]: sets.0.axes.0.key"));
    CHECK(has(error_of("set = [\"operation.0.speed=fast\"]\n" + set), "error[not-a-quantity]: set.0"));
    // What a value breaks elsewhere in the case belongs to the step.
    const auto elsewhere =
        error_of(set + "[[sets.axes]]\nkey = \"mechanism.slide_body\"\nvalues = [\"slide\", \"nobody\"]\n");
    CHECK(has(elsewhere, "error[unknown-name]: sets.0.axes.0.values.1"));
}

TEST_CASE("axes and sets that do not make sense")
{
    CHECK(has(error_of(""), "the study has nothing to compute"));
    CHECK(has(error_of(speed), "the axis has no steps"));
    CHECK(has(error_of(speed + "values = []\n"), "the axis has no steps"));
    CHECK(has(error_of(set + "[[sets.axes]]\nvalues = [\"1\"]\n"), "the axis varies nothing"));
    CHECK(has(error_of(speed + "keys = [\"operation.0.force\"]\nvalues = [\"1\"]\n"), "both `key` and `keys`"));
    CHECK(has(error_of(speed + "from = \"60 rpm\"\nto = \"70 rpm\"\ncount = 1\n"), "it must lie between 2 and 10000"));
    CHECK(has(error_of(speed + "from = \"60 rpm\"\nto = \"70 rpm\"\n"), "the range is not complete"));
    CHECK(has(error_of(speed + "from = \"60 rpm\"\nto = \"7 rad/s\"\ncount = 2\n"), "different units"));
    CHECK(has(error_of(speed + "from = \"60 rpm\"\nto = \"60 rpm\"\ncount = 2\n"), "the range has no extent"));
    CHECK(has(error_of(speed + "from = \"slow\"\nto = \"60 rpm\"\ncount = 2\n"), "does not begin with a number"));
    CHECK(has(error_of(speed + "from = \"60 rpm\"\nto = \"70 rpm\"\ncount = 2\nvalues = [\"60 rpm\"]\n"),
              "both `values` and a range"));
    CHECK(has(error_of(speed + "values = [\"60 rpm\", \"70 rpm\"]\nlabels = [\"slow\"]\n"), "1 labels for 2 steps"));
    CHECK(has(error_of(speed + "values = [\"60 rpm\", \"70 rpm\"]\nlabels = [\"a\", \"a\"]\n"),
              "two steps are called 'a'"));
    CHECK(has(error_of(speed + "values = [\"60 rpm\", \"60.0  rpm\"]\n"),
              "error[duplicate-step]: sets.0.axes.0.values.1"));
    CHECK(has(error_of(speed + "values = [[\"60 rpm\", \"1 kN\"]]\n"), "2 values for 1 keys"));
    CHECK(has(error_of(speed + "values = [{ a = 1 }]\n"), "error[wrong-type]: sets.0.axes.0.values.0"));
    const std::string force = "[[sets.axes]]\nkey = \"operation.0.force\"\nvalues = [\"1 kN\"]\n";
    const auto twice = error_of(set + force + "name = \"a\"\n" + force + "name = \"b\"\n");
    CHECK(has(twice, "the set varies 'operation.0.force' twice"));
    CHECK(has(
        error_of(set + force + "name = \"a\"\n[[sets.axes]]\nname = \"b\"\nkey = \"operation.0\"\nvalues = [\"1\"]\n"),
        "the set varies 'operation.0' and, within it, 'operation.0.force'"));
    CHECK(has(
        error_of(set + force + "[[sets.axes]]\nname = \"force\"\nkey = \"operation.0.speed\"\nvalues = [\"60 rpm\"]\n"),
        "two axes of the set are called 'force'"));
    CHECK(has(error_of(set + set), "two sets are called 's'"));
    CHECK(has(error_of("[limits]\n" + set), "no limit is given"));
    CHECK(has(error_of("[limits]\nlargest = \"0 um\"\n" + set), "error[out-of-range]: limits.largest"));
    const std::string many = "from = \"1 rpm\"\nto = \"2 rpm\"\ncount = 101\n";
    CHECK(has(error_of(speed + many +
                       "[[sets.axes]]\nkey = \"operation.0.force\"\nfrom = \"1 kN\"\nto = \"2 kN\"\n"
                       "count = 100\n"),
              "10100 points, more than 10000 in all"));
}

TEST_CASE("all mistakes of a file are listed; a broken base case lists its own")
{
    const auto text = error_of(speed + "values = [\"60 mm\"]\n[[sets]]\nname = \"t\"\n[[sets.axes]]\n"
                                       "key = \"operation.0.force\"\nvalues = [\"1 kN\"]\nlabels = [\"a\", \"b\"]\n");
    CHECK(has(text, "error[unit-mismatch]: sets.0.axes.0.values.0"));
    CHECK(has(text, "error[wrong-length]: sets.1.axes.0.labels"));
    const Scratch scratch;
    (void)scratch.file("case.toml", "format = 1\n[machine]\nnam = \"x\"\n");
    const auto file = scratch.file("s.toml", head + set);
    CHECK_THROWS_WITH_AS((void)read_study(file), doctest::Contains("case.toml:3:1: error[unknown-key]: machine.nam"),
                         InputError);
    CHECK_THROWS_WITH_AS((void)read_study(file), doctest::Contains("in the base case of the study"), InputError);
    fs::remove(scratch.path / "case.toml");
    CHECK_THROWS_WITH_AS((void)read_study(file), doctest::Contains("error[missing-file]: base"), InputError);
    CHECK_THROWS_AS((void)read_study("no/such/file.toml"), IoError);
}

TEST_CASE("numbers with units are split, and values that mean the same are written the same")
{
    CHECK(number_and_unit(" 5e8 N/m")->number == 5e8);
    CHECK(number_and_unit(" 5e8 N/m")->unit == "N/m");
    CHECK(number_and_unit("+.5")->number == 0.5);
    CHECK(number_and_unit("-3K")->unit == "K");
    for (const char* text : {"rigid", "nan", "inf", "", "-", "[1, 2]", "1e999 m"}) {
        CHECK_FALSE(number_and_unit(text));
    }
    CHECK(plain_setting("300.0   rpm") == plain_setting("3e2 rpm"));
    CHECK(plain_setting(" rigid ") == "rigid");
    CHECK(plain_setting("300 rpm") != plain_setting("300 rad/s"));
}

TEST_CASE("the shipped study varies what the paper varies")
{
    const auto study = read_study(fs::path(DEADPOINT_SOURCE_DIR) / "cases/jl75g-60/paper-study.toml");
    REQUIRE(study.sets.size() == 4);
    CHECK(study.sets[0].axes.at(0).labels == std::vector<std::string>{"200 rpm", "300 rpm", "400 rpm", "500 rpm"});
    CHECK(study.sets[1].axes.at(0).labels == std::vector<std::string>{"0 kN", "100 kN", "200 kN", "300 kN", "400 kN"});
    CHECK(study.sets[2].axes.at(0).keys.size() == 4);
    CHECK(study.sets[2].axes.at(0).labels == std::vector<std::string>{"5e7 N/m", "1e8 N/m", "5e8 N/m", "1e9 N/m"});
    CHECK(study.sets[3].axes.at(0).labels == std::vector<std::string>{"traditional", "improved"});
    // The set of the traditional model is the shipped case of that name, but for what that case is called and its oil.
    const fs::path press = fs::path(DEADPOINT_SOURCE_DIR) / "cases/jl75g-60";
    const auto& models = study.sets[3].axes.at(0);
    REQUIRE(models.keys.size() == 1);
    const auto changed = read_case(study.base, {models.keys[0] + "=" + models.values[0][0]}).value;
    CHECK(changed.crankshaft->model == read_case(press / "traditional.toml").value.crankshaft->model);
}

TEST_CASE("the shipped working day lasts a day")
{
    const auto day = read_case(fs::path(DEADPOINT_SOURCE_DIR) / "cases/jl75g-60/working-day.toml").value;
    double duration = 0;
    for (const auto& segment : day.operation) {
        duration += segment.duration;
        CHECK(segment.ambient.has_value());
    }
    CHECK(day.operation.size() == 5);
    CHECK(duration == near(86400, 1e-12));
}

TEST_CASE("docs/study-file.md is the page of study files of this program")
{
    // To renew the page, run this test with DEADPOINT_RENEW_DOCS=1.
    const fs::path page = DEADPOINT_SOURCE_DIR "/docs/study-file.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(page) << study_file_page();
    }
    CHECK(content(page) == study_file_page());
}
