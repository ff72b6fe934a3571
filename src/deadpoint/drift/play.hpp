#pragma once

#include <vector>

namespace deadpoint::drift {

/// Motion of the crank due to the growth of its bearings' radial clearance.
struct BearingPlay {
    enum class Kind {
        none,     ///< no motion: the bearings run without play
        limited,  ///< limited by the play at the start: further closing only strains the bearing
        whole     ///< full motion for any closing
    };
    Kind kind = Kind::whole;
    double initial = 0;  ///< radial play at the start, of `limited`, >= 0 [m]

    /// Change of the crank's play [m] for a growth of the clearance [m]: 0, max(growth, -initial) or the growth.
    [[nodiscard]] double taken(double growth) const;
    /// taken() over the growth, 0..1.
    [[nodiscard]] double share(double growth) const;
    /// Slope of taken(): 0 or 1.
    [[nodiscard]] double slope(double growth) const;
};

}  // namespace deadpoint::drift
