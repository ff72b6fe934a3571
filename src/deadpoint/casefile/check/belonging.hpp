#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;
struct Finding;

/// Checks that what belongs together is said so everywhere: surfaces of the dimension chain and of joints lie on
/// their bodies, joints hold the bodies, planes and cylinders that touch fit the motion of their joint, and friction
/// laws fit its kind. Surfaces are judged by the parts that they name; those that name none are left to the mesh.
std::vector<Finding> check_belonging(const Case& c);

}  // namespace deadpoint::casefile
