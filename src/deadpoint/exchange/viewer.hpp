#pragma once

#include "deadpoint/core/vec.hpp"

namespace deadpoint {

/// Directions of a machine as its operator sees them, who stands in front of it and looks at it: unit vectors with
/// left = front x up. (Who looks along -front has -front x up = up x front on the right.)
struct Viewer {
    Vec3 front{0, 0, 1};  ///< from the machine towards the operator
    Vec3 left{-1, 0, 0};
    Vec3 up{0, 1, 0};
};

}  // namespace deadpoint
