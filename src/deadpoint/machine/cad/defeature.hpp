#pragma once

#include "deadpoint/machine/cad/step_solids.hpp"

#include <string>
#include <vector>

namespace deadpoint::machine {

/// Leaves out the holes and roundings of a solid whose diameter is at most `diameter` [mm]: faces on cylinders, cones,
/// tori and spheres, with the bottoms of holes. What Open CASCADE cannot close stays.
/// @return what was left out, in words; nothing where nothing was
std::vector<std::string> defeature(StepSolid& solid, double diameter);

}  // namespace deadpoint::machine
