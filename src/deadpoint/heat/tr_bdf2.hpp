#pragma once

#include <array>
#include <cmath>

/// Constants and formulas of the time stepping.
namespace deadpoint::heat {

// TR-BDF2 with gamma = 2 - sqrt(2): both stages solve with the same matrix M + diagonal dt J. The companion of
// third order gives the error estimate (Hosea and Shampine, Applied Numerical Mathematics 20, 1996).
inline const double gamma_stage = 2 - std::sqrt(2.0);
inline const double diagonal = 1 - 1 / std::sqrt(2.0);
inline const double outer_weight = std::sqrt(2.0) / 4;
inline const double bdf_middle = 1 / (gamma_stage * (2 - gamma_stage));
inline const double bdf_now = (1 - gamma_stage) * (1 - gamma_stage) / (gamma_stage * (2 - gamma_stage));
inline const std::array<double, 3> error_weights{(1 - outer_weight) / 3 - outer_weight,
                                                 (3 * outer_weight + 1) / 3 - outer_weight, diagonal / 3 - diagonal};

/// Slope of a scalar at the end of a step, from its values at the three times of the step: the
/// formula of the second stage, which is also that of the parabola through them.
inline double end_slope(double start, double middle, double end, double dt)
{
    return (end - bdf_middle * middle + bdf_now * start) / (diagonal * dt);
}

/// Error of a step from the slopes at its three times: the difference to the companion method.
inline double step_error(double dt, double start_slope, double middle_slope, double end_slope)
{
    return dt * (error_weights[0] * start_slope + error_weights[1] * middle_slope + error_weights[2] * end_slope);
}

}  // namespace deadpoint::heat
