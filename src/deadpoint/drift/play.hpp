#pragma once

#include <vector>

namespace deadpoint::drift {

/// How far the crank follows the growth of its bearings' radial clearance.
struct BearingPlay {
    enum class Kind {
        none,     ///< not at all: the bearings run without play
        limited,  ///< as far as the play at the start goes: what closes further only strains the bearing
        whole     ///< all the way, however much the bearing closes
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

/// Mean of taken() over bearings [m]; 0 without bearings.
double mean_taken(const BearingPlay& play, const std::vector<double>& growths);

}  // namespace deadpoint::drift
