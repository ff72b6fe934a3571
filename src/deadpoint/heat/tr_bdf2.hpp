#pragma once

#include <array>
#include <cmath>

/// The time stepping: formulas of TR-BDF2, the error of a step, and how long the next one is.
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

/// Ratio of two neighbouring step sizes: the same few stage matrices serve a whole run.
inline constexpr double step_ratio = 2;

/// Length of the next step [s]: the wanted one, adjusted so that no tiny last step remains.
/// @param remaining  to the end of the segment [s], > 0
double fit_step(double wanted, double remaining);

/// Factor by which a step may grow or must shrink, a whole power of step_ratio: the largest one with
/// factor <= 0.9 (tolerance / error)^(1/3), since the error is of third order, between the powers `least` and `most`.
double step_size_factor(double error, double tolerance, int least, int most);

/// Allowed error of a single time step, so that the accumulated error of a run stays near
/// `time_tolerance` [K]:
///
///   tolerance min(1, sqrt(tolerance / 0.02 K))
///
/// An error of third order per step adds up to one of second order. If each step used the tolerance
/// itself, the error of a run would fall only with its power 2/3, and would be five times the
/// tolerance at 1e-4 K. With the power 3/2 the error of a run is proportional to the tolerance. At
/// 0.02 K, the default of `numerics.time_tolerance`, the two are the same.
double step_tolerance(double time_tolerance);
/// The time tolerance that allows this error of a step [K]; the inverse of step_tolerance().
double time_tolerance_of(double step_tolerance);

}  // namespace deadpoint::heat
