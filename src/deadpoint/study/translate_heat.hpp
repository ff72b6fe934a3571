#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <vector>

namespace deadpoint::study {

/// Material of every part of the machine.
std::vector<Material> describe_materials(const casefile::Case& input, const Machine& machine);

/// The heat problem of a case: interfaces in the order of the machine's, sources in the order of `Case::friction`.
///
/// A probe beyond the symmetry plane of a half model stands for its mirror image. Warns about friction that no joint
/// uses and about process forces, which calibrated heat does not follow.
HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer);

/// Index of a part by name, or -1.
int part_index(const Machine& machine, const std::string& name);
/// Index of a surface by name, or -1.
int surface_index(const Machine& machine, const std::string& name);

}  // namespace deadpoint::study
