#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <vector>

namespace deadpoint {

struct FacePoint {
    Vec3 position{};
    double weight = 0;  ///< area [m2]
};

/// Quadrature points of an exterior face: Gauss 3 x 3 on a quadrilateral (as a bilinear patch), six points of degree 4
/// on a triangle. The weights sum to the face's area (to rounding, where the face is flat).
std::vector<FacePoint> face_points(const Machine& machine, const Face& face);

}  // namespace deadpoint
