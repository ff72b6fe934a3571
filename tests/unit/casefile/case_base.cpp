/// Requirement: many cases from one file, and texts of many like cases, are those of each case by itself.
#include "deadpoint/casefile/files/case_base.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <string>
#include <tuple>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::casefile;

namespace {

const std::string shipped = DEADPOINT_SOURCE_DIR "/cases/jl75g-60/oil.toml";
using Texts = std::vector<std::string>;

const CaseBase& base()
{
    static const CaseBase result(shipped, FileAccess::below);
    return result;
}

std::string error_of(auto&& read)
{
    try {
        std::ignore = read();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// Changes of every kind of section: tables by name, a list, a table, quantities by name; present keys and new ones.
const std::vector<Texts> changes{
    {},
    {"oil.crank_bearings=300 W/m^2/K"},
    {"friction.crank_pin.scale=1.25", "friction.guide_4.load_part=100 W"},
    {"friction.guide_4={law=\"calibrated\", kind=\"guide\", load_part=\"10 W\", reference_speed=\"200 rpm\"}"},
    {"operation.0.speed=300 rpm", "operation.0.force=200 kN"},
    {"operation.0={duration=\"1 h\", speed=\"100 rpm\", force=\"0 N\"}",
     "operation.1={duration=\"2 h\", speed=\"200 rpm\", force=\"1 kN\"}"},
    {"surfaces.crank_system.film.coefficient=12 W/m^2/K", "surfaces.crank_system.film.emissivity=0.8"},
    {"surfaces.crank_system.film={law=\"vertical\", length=\"1 m\"}"},
    {"joints.pivot_h.interfaces.0.conductance={value=\"1e4 W/m^2/K\"}"},
    {"joints.pivot_h.oil_temperature=30 degC"},
    {"machine.ambient=25 degC", "numerics.time_tolerance=0.1 K", "output.causes=false"},
    {"oil_with_speed.crank_pin={exponent=0.5, reference_speed=\"200 rpm\"}"},
    {"heat_sources.motor={parts=[\"base\"], power=\"200 W\"}"},
    {"machine={name=\"other\", half_model=true}"},
    {"reference.rises.A=10 K"}};

const std::vector<Texts> mistakes{{"oil.crank_bearing=300 W/m^2/K"},
                                  {"friction.crank_pin.scal=1.25"},
                                  {"friction.new.scale=1"},
                                  {"operation.7.speed=1 rpm"},
                                  {"operation.0.speed=300 kN"},
                                  {"surfaces.crank_system.film.coefficient=-1 W/m^2/K"},
                                  {"frictoin.crank_pin.scale=1"},
                                  {"speed=300 rpm"},
                                  {"operation.0.speed"},
                                  {"probes.A.part=nothing"}};

}  // namespace

TEST_CASE("a case made of a file that was read once is the case that the file gives with the same settings")
{
    for (const auto& change : changes) {
        CAPTURE(change);
        const auto whole = read_case(shipped, change).value;
        const auto quick = base().with(change);
        CHECK(write_case(quick) == write_case(whole));
        CHECK(case_bytes(quick) == case_bytes(whole));
        CHECK(quick.source->hash == whole.source->hash);
        CHECK(quick.source->overrides == change);
    }
}

TEST_CASE("a wrong setting is told as for a file that is read anew")
{
    for (const auto& mistake : mistakes) {
        CAPTURE(mistake);
        const auto expected = error_of([&] { return read_case(shipped, mistake); });
        CHECK(expected != "");
        CHECK(error_of([&] { return base().with(mistake); }) == expected);
    }
}

TEST_CASE("a setting may mend a mistake of the file")
{
    const ScratchFolder scratch;
    const auto file =
        scratch.file("case.toml", "include = [\"" + shipped + "\"]\nreplace = [\"oil.crank_pin=5 kN\"]\n");
    const CaseBase wrong(file, FileAccess::anywhere);
    CHECK_THROWS_AS(std::ignore = wrong.with({}), CaseError);
    CHECK(wrong.with({"oil.crank_pin=7 W/m^2/K"}).oil.at("crank_pin") == 7);
    CHECK_THROWS_AS(CaseBase(scratch.path / "none.toml", FileAccess::below), IoError);
}

TEST_CASE("every number of a case is in its bytes and its text")
{
    const auto whole = read_case(shipped).value;
    const auto bytes = case_bytes(whole);
    CaseTexts texts;
    CHECK(texts.text(whole) == write_case(whole));
    for (const auto& number : numbers_of(whole)) {
        CAPTURE(number.path);
        auto changed = whole;
        change_numbers(changed, {{number.path, {0.999 * number.value < number.least ? 1.001 : 0.999, 0}}});
        CHECK((case_bytes(changed) == bytes) == (write_case(changed) == write_case(whole)));
        CHECK(texts.text(changed) == write_case(changed));
    }
    CHECK(texts.hash(whole) == case_hash(whole));
}

TEST_CASE("texts of cases that differ in their tables are those of each by itself")
{
    CaseTexts texts;
    for (int round = 0; round < 2; ++round)
        for (const auto& change : changes) {
            CAPTURE(change);
            const auto one = read_case(shipped, change).value;
            CHECK(texts.text(one) == write_case(one));
        }
}
