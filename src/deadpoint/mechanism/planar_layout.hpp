#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <vector>

/// Indices of the coordinates and constraints of a planar linkage in its system of equations.
namespace deadpoint::mechanism {

struct PlanarLayout {
    Linkage linkage;
    std::vector<int> first_unknown;   ///< per body, -1 for the ground
    std::vector<int> first_equation;  ///< per joint
    int unknowns = 0;
    int equations = 0;
    int driven_body = 0;
    double length = 1;  ///< size of the linkage [m]

    /// Poses of all bodies at the assembled position of the case file.
    [[nodiscard]] std::vector<PlanarPose> assembled() const { return std::vector<PlanarPose>(linkage.bodies.size()); }
};

}  // namespace deadpoint::mechanism
