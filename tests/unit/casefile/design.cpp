/// Requirement: a section for sensitivity names keys and ranges in the words of the case; every mistake has place and
/// remedy.
#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <filesystem>

using namespace deadpoint;
using namespace deadpoint::casefile;
namespace fs = std::filesystem;

namespace {

struct Scratch : ScratchFolder {
    Scratch() { fs::copy_file(fs::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml", path / "case.toml"); }
};

const std::string head = "format = 1\nname = \"n\"\nbase = \"case.toml\"\nset = [\"oil.pins=300 W/m^2/K\", "
                         "\"friction.gibs.viscous_part=0 W\"]\n";
const std::string parameter = "[[sensitivity.parameters]]\n";  // line 5, or 6 after [sensitivity]

StudyFile read(const std::string& body)
{
    const Scratch scratch;
    return read_study(scratch.file("s.toml", head + body));
}

std::string error_of(const std::string& body)
{
    try {
        (void)read(body);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

void check_error(const std::string& body, const std::vector<std::string>& pieces)
{
    const auto found = error_of(body);
    for (const auto& piece : pieces)
        CHECK_MESSAGE(found.find(piece) != std::string::npos, found << "\nlacks: " << piece);
}

}  // namespace

TEST_CASE("ranges are factors, shifts or values in SI units, of one key or several")
{
    const auto section = *read(R"(
[sensitivity]
points = 64
outputs = ["E_SW", "s*"]
times = ["10 min", "1 h"]
[[sensitivity.parameters]]
name = "friction"
keys = ["friction.*.load_part", "friction.journals.viscous_part"]
factor = 2
[[sensitivity.parameters]]
keys = ["machine.ambient"]
shift = "3 K"
[[sensitivity.parameters]]
keys = ["operation.*.speed"]
from = "50 rpm"
to = "80 rpm"
)")
                              .sensitivity;
    REQUIRE(section.parameters.size() == 3);
    const auto& friction = section.parameters[0];
    CHECK(friction.keys == std::vector<std::string>{"friction.gibs.load_part", "friction.journals.load_part",
                                                    "friction.pins.load_part", "friction.journals.viscous_part"});
    CHECK(friction.low == 0.5);
    CHECK(friction.high == 2);
    CHECK(friction.dimension == Dimension::power);
    CHECK(section.parameters[1].name == "ambient");
    CHECK(section.parameters[1].low == -3);
    CHECK(section.parameters[1].high == 3);
    CHECK(section.parameters[2].keys == std::vector<std::string>{"operation.0.speed"});
    CHECK(section.parameters[2].low == near(50 * 2 * 3.14159265358979 / 60, 1e-12));
    CHECK(section.times == std::vector<double>{600, 3600});
    CHECK(section.method() == SensitivityMethod::sobol);
}

TEST_CASE("a mistake in a section for sensitivity is told with its place and its remedy")
{
    check_error(parameter + "keys = [\"oil.pin\"]\nfactor = 2\n",
                {"s.toml:6:9: error[unknown-key]: sensitivity.parameters.0.keys.0", "no number 'oil.pin'",
                 "did you mean 'oil.pins'?"});
    check_error(parameter + "keys = [\"oil.pins\"]\n", {"the range is missing", "give `factor`, or `shift`"});
    check_error(parameter + "keys = [\"oil.pins\"]\nfactor = 2\nshift = \"1 W/m^2/K\"\n", {"the range is given twice"});
    check_error(parameter + "keys = [\"oil.pins\"]\nfrom = \"1 W/m^2/K\"\n", {"the range has one end only"});
    check_error(parameter + "keys = [\"operation.0.speed\"]\nfrom = \"50 mm\"\nto = \"80 rpm\"\n",
                {"s.toml:7:8: error[unit-mismatch]: sensitivity.parameters.0.from"});
    check_error(parameter + "keys = [\"operation.0.speed\"]\nfrom = \"90 rpm\"\nto = \"80 rpm\"\n",
                {"s.toml:8:6: error[inconsistent]", "the range has no extent"});
    check_error(parameter + "keys = [\"operation.0.force\"]\nshift = \"200 kN\"\n",
                {"s.toml:7:9: error[out-of-range]", "'operation.warm-up.force' would become -100 kN"});
    check_error(parameter + "keys = [\"oil.pins\", \"operation.0.speed\"]\nfactor = 2\n",
                {"error[unit-mismatch]", "let keys of one kind change together"});
    check_error(parameter + "name = \"a\"\nkeys = [\"oil.pins\"]\nfactor = 2\n" + parameter +
                    "name = \"a\"\nkeys = [\"oil.*\"]\nfactor = 3\n",
                {"two entries are called 'a'", "'oil.pins' is varied twice"});
    check_error(parameter + "keys = [\"friction.gibs.viscous_part\"]\nfactor = 2\n",
                {"s.toml:6:8: error[inconsistent]", "is zero, which no factor changes"});
    check_error(parameter + "keys = [\"friction.gibs.load_part\"]\nfactor = 1\n", {"factor"});
    check_error("[sensitivity]\noutputs = [\"slid\"]\n" + parameter + "keys = [\"oil.pins\"]\nfactor = 2\n",
                {"s.toml:6:12: error[unknown-name]: sensitivity.outputs.0", "did you mean 'slide'?"});
    check_error("[sensitivity]\ntimes = [\"4 h\"]\n" + parameter + "keys = [\"oil.pins\"]\nfactor = 2\n",
                {"s.toml:6:10: error[out-of-range]", "the run ends at 10800 s"});
    check_error("[sensitivity]\nmethod = \"fast\"\n", {"method", "sobol", "parameters"});
    check_error("", {"the study has nothing to compute"});
}

TEST_CASE("a section for an optimum reads its limits in the unit of their outputs and takes the rate of the case")
{
    const auto section = *read(R"(
[optimise]
objective = "warm-up"
rate = "2 um/h"
[optimise.speed_profile]
ends = ["20 min", "1 h"]
from = "40 rpm"
to = "90 rpm"
least_mean = "50 rpm"
[[optimise.variables]]
keys = ["oil.pins"]
factor = 2
[[optimise.limits]]
output = "slide"
most = "30 degC"
[[optimise.limits]]
output = "E_SW"
least = "-80 um"
from = "10 min"
)")
                              .optimise;
    CHECK(section.objective() == Objective::warm_up);
    CHECK(section.rate == near(2e-6 / 3600, 1e-12));
    CHECK(section.speed_profile->ends == std::vector<double>{1200, 3600});
    CHECK(section.variables[0].name == "pins");
    CHECK(*section.limits[0].most_value == near(303.15, 1e-12));
    CHECK_FALSE(section.limits[0].least_value);
    CHECK(*section.limits[1].least_value == near(-8e-5, 1e-12));
    CHECK(section.limits[1].from == 600);
}

TEST_CASE("a mistake in a section for an optimum is told with its place and its remedy")
{
    const std::string variable = "[[optimise.variables]]\nkeys = [\"oil.pins\"]\nfactor = 2\n";
    check_error("[optimise]\n", {"nothing may change", "give [[optimise.variables]] or [optimise.speed_profile]"});
    check_error("[optimise]\nobjective = \"fast\"\n" + variable, {"s.toml:6:", "warm-up"});
    check_error("[optimise]\nfrom = \"3 h\"\n" + variable,
                {"s.toml:6:8: error[out-of-range]: optimise.from", "the run ends at"});
    check_error(variable + "[[optimise.limits]]\noutput = \"slid\"\nmost = \"30 degC\"\n",
                {"error[unknown-name]: optimise.limits.0.output", "outputs are"});
    check_error(variable + "[[optimise.limits]]\noutput = \"slide\"\nmost = \"30 um\"\n",
                {"error[unit-mismatch]: optimise.limits.0.most"});
    check_error(variable + "[[optimise.limits]]\noutput = \"slide\"\n", {"no limit is given"});
    check_error("[optimise.speed_profile]\nends = [\"3 h\"]\nfrom = \"40 rpm\"\nto = \"90 rpm\"\n",
                {"s.toml:6:8: error[out-of-range]: optimise.speed_profile.ends", "let the last interval end"});
    check_error("[optimise.speed_profile]\nends = [\"2 h\", \"1 h\"]\nfrom = \"40 rpm\"\nto = \"90 rpm\"\n",
                {"s.toml:6:8: error", "the ends do not ascend"});
    check_error("[optimise.speed_profile]\nends = [\"1 h\"]\nfrom = \"90 rpm\"\nto = \"40 rpm\"\n",
                {"s.toml:8:6: error", "the range has no extent"});
}
