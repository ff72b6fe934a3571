#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/table.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <string>

using namespace deadpoint;
using namespace deadpoint::casefile;

namespace {

const std::string machine = R"(
format = 1
[machine]
name = "one body"
[bodies.frame]
ground = true
[[operation]]
duration = "1 h"
speed = "0 rpm"
)";

double at(const Table& table, double celsius) { return interpolate_linear(table.x, table.y, celsius + 273.15).value; }

}  // namespace

TEST_CASE("the shipped steel over temperature follows the formulas of EN 1993-1-2")
{
    const ScratchFolder scratch;
    const auto c =
        read_case(scratch.file("case.toml", machine + "[materials.steel]\nlibrary = \"S235-EN1993\"\n")).value;
    const auto& steel = c.materials.at("steel");
    for (const double t : {20.0, 35.0, 75.0, 130.0, 260.0, 400.0}) {
        CAPTURE(t);
        CHECK(at(steel.conductivity_table, t) == near(54 - 3.33e-2 * t, 1e-5));
        // linear between the points of a cubic
        CHECK(at(steel.specific_heat_table, t) == near(425 + 0.773 * t - 1.69e-3 * t * t + 2.22e-6 * t * t * t, 2e-3));
        const double elongation = 1.2e-5 * t + 0.4e-8 * t * t - 2.416e-4;
        CHECK(at(steel.expansion_table, t) * (t - 20) == near(elongation, 1e-6, 1e-18));  // at 20 degC rounding of 2e-4
    }
    CHECK(steel.expansion_kind == Material::Expansion::mean);
    CHECK(*steel.expansion_reference == near(293.15, 1e-5));
}

TEST_CASE("tables of a material and enclosures are written as they were read")
{
    const ScratchFolder scratch;
    const auto file = scratch.file("case.toml", machine + R"(
[materials.steel]
library = "S235-EN1993"
conductivity = "50 W/m/K"
expansion = { temperature = ["20 degC", "100 degC"], value = ["1.1e-5 1/K", "1.2e-5 1/K"] }
[surfaces.inside]
select = "exposed"
film = { coefficient = "5 W/m^2/K" }
[enclosures.case]
surfaces = ["inside"]
volume = "800 L"
air_changes = 20
temperature = "30 degC"
power = "120 W"
)");
    const auto c = read_case(file).value;
    const auto& steel = c.materials.at("steel");
    CHECK(steel.conductivity_table.x.empty());  // the constant stands in place of the library's table
    CHECK(steel.conductivity == 50);
    CHECK(steel.specific_heat_table.x.size() == 7);
    CHECK(steel.expansion_table.y == std::vector<double>{1.1e-5, 1.2e-5});
    const auto& air = c.enclosures.at("case");
    CHECK(*air.volume == near(0.8, 1e-5));
    CHECK(air.air_changes == 20);
    CHECK_FALSE(air.exchange);
    CHECK(air.power->constant == 120);
    const auto text = write_case(c);
    CHECK(write_case(read_case(scratch.file("again.toml", text)).value) == text);
}
