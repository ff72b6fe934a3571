#pragma once

namespace deadpoint {

/// Change of a heat transfer coefficient h with the speed n of the crank that moves the fluid:
///   h(n) = h (s + (1 - s) (n / n_r)^e).
/// Forced convection has e = 0.5 (laminar) to 0.8 (turbulent), since Nu ~ Re^e.
struct SpeedGrowth {
    double exponent = 0;         ///< e, 0 to 3
    double reference_speed = 1;  ///< n_r, at which h holds [rad/s], > 0
    double at_rest = 0;          ///< s, the share of h that stays while the press stands, 0 to 1

    /// h(n) / h. @param speed  n of either sign [rad/s]
    [[nodiscard]] double factor(double speed) const;
};

}  // namespace deadpoint
