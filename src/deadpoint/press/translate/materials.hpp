#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/laws/material.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
struct ThermalHistory;
}  // namespace deadpoint

/// Materials of a case in the terms of the heat and deformation stages.
namespace deadpoint::press {

/// A material whose constants are its values at a temperature [K], also where it has tables.
casefile::Material at_temperature(casefile::Material material, double temperature);

/// Material of every part of the machine; beside tables the constants are those at the initial temperature.
std::vector<Material> describe_materials(const casefile::Case& input, const Machine& machine);

/// What to say about tables that the run left: material, key, range and the temperatures reached.
std::vector<std::string> material_warnings(const casefile::Case& input, const Machine& machine,
                                           const ThermalHistory& history);

}  // namespace deadpoint::press
