#include "deadpoint/press/machine/model_part.hpp"

#include "deadpoint/casefile/files/read.hpp"

#include <doctest/doctest.h>
#include <string>
#include <vector>

using namespace deadpoint;

namespace {

std::string key(const std::string& name, const std::vector<std::string>& overrides = {})
{
    return press::model_key(
        casefile::read_case(std::string(DEADPOINT_SOURCE_DIR) + "/cases/" + name + ".toml", overrides).value);
}

}  // namespace

TEST_CASE("cases that differ in what no mesh and no model is made of can share them")
{
    const auto starter = key("starter/case");
    for (const auto* change :
         {"surfaces.air_frame.film.coefficient=9 W/m^2/K", "surfaces.air_frame.film.emissivity=0.2",
          "joints.crank_pin.interfaces.0.conductance.resistance=1e-4 m^2 K/W", "lubricants.oil.density=900 kg/m^3",
          "operation.0.speed=20 rpm", "operation.0.force=10 kN", "machine.initial_temperature=25 degC",
          "machine.ambient=25 degC", "chain.press_stiffness=1 kN/um", "numerics.time_tolerance=0.1 K",
          "probes.slide.position=[\"0 mm\", \"-580 mm\", \"-100 mm\"]"}) {
        CAPTURE(change);
        CHECK(key("starter/case", {change}) == starter);
    }
}

TEST_CASE("cases that differ in what a mesh or a model is made of cannot share them")
{
    const auto starter = key("starter/case");
    for (const auto* change :
         {"numerics.size=80 mm", "numerics.order=2", "numerics.deformation_size=2",
          "materials.steel.youngs_modulus=190 GPa", "materials.steel.expansion=1.3e-5 1/K",
          "joints.crank_pin.centre=[\"0 mm\", \"-41 mm\"]", "joints.crank_bearing.interfaces.0.seat=false",
          "chain.corners=false", "parts.bed.size=30 mm", "machine.unbonded=[\"bed|upright_*\"]",
          "foundation.kind=clamped"}) {
        CAPTURE(change);
        CHECK(key("starter/case", {change}) != starter);
    }
}

TEST_CASE("materials over temperature count from the initial temperature, which then cannot be shared")
{
    const std::string table = "materials.steel.conductivity={temperature = [\"0 degC\", \"100 degC\"], "
                              "value = [\"40 W/m/K\", \"44 W/m/K\"]}";
    CHECK(key("starter/case", {table, "machine.initial_temperature=30 degC"}) != key("starter/case", {table}));
}
