#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/deformation.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}

namespace deadpoint::drift {

/// Growth of a bearing's clearance on the diameter: twice the growth of bores less that of the shafts in them, summed
/// over its contacts from seat to shaft. Rings between them count with their own growth.
/// @throws InputError as fit_circle
Functional bearing_clearance(const Machine& machine, const std::vector<int>& contacts, const Vec2& centre);

/// The clearance across one pair of opposite sides of a guide.
struct GuideClearance {
    Vec3 across{};  ///< unit, its largest component positive
    Functional growth;
};

/// Growth of a guide's clearance, both sides together: the mean opening (u_b - u_a) . n of the
/// faces that look one way plus that of the faces that look the other way; the position of the body
/// between them does not matter. Faces without opposite ones have no clearance. In a half model the
/// mirror image counts of a face between two bodies that the symmetry plane cuts.
std::vector<GuideClearance> guide_clearances(const Machine& machine, const std::vector<int>& contacts);

}  // namespace deadpoint::drift
