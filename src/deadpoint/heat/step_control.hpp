#pragma once

namespace deadpoint::heat {

/// Ratio of two neighbouring step sizes: the same few stage matrices serve a whole run.
inline constexpr double step_ratio = 2;

/// Length of the next step [s]: the wanted one, adjusted so that no tiny last step remains.
/// @param remaining  to the end of the segment [s], > 0
double fit_step(double wanted, double remaining);

/// Factor by which a step may grow or must shrink, a whole power of step_ratio: the largest one with
/// factor <= 0.9 (tolerance / error)^(1/3), since the error is of third order, between the powers `least` and `most`.
double step_size_factor(double error, double tolerance, int least, int most);

}  // namespace deadpoint::heat
