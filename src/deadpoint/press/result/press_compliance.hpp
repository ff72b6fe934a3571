#pragma once

#include <string>
#include <vector>

/// What the process force opens, apart from heat.
namespace deadpoint::press {

/// Opening of the gap at a corner of the slide.
struct CornerOpening {
    std::string name;    ///< as in CornerSeries
    double opening = 0;  ///< per force on the middle of the slide [m/N]
};

/// Static deformation of the parts under the process force at bottom dead point: slide and table are pushed apart, and
/// the joints pass the force on. Linear in the force.
struct PressCompliance {
    double opening = 0;                  ///< of the gap, per force [m/N]
    std::vector<CornerOpening> corners;  ///< front left, front right, back left, back right; none without corners
    double left_right = 0;               ///< tilt: opening on the right less that on the left, over x [1/N]
    double front_back = 0;               ///< opening at the back less that in front, over z [1/N]

    [[nodiscard]] double stiffness() const { return 1 / opening; }  ///< [N/m]
};

}  // namespace deadpoint::press
