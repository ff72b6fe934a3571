#pragma once

#include <array>
#include <cmath>

/// Internal to fem/: the constants of the time stepping.
namespace deadpoint::fem {

// TR-BDF2 with gamma = 2 - sqrt(2): both stages solve with the same matrix M + diagonal dt J. The companion of
// third order gives the error estimate (Hosea and Shampine, Applied Numerical Mathematics 20, 1996).
inline const double gamma_stage = 2 - std::sqrt(2.0);
inline const double diagonal = 1 - 1 / std::sqrt(2.0);
inline const double outer_weight = std::sqrt(2.0) / 4;
inline const double bdf_middle = 1 / (gamma_stage * (2 - gamma_stage));
inline const double bdf_now = (1 - gamma_stage) * (1 - gamma_stage) / (gamma_stage * (2 - gamma_stage));
inline const std::array<double, 3> error_weights{(1 - outer_weight) / 3 - outer_weight,
                                                 (3 * outer_weight + 1) / 3 - outer_weight, diagonal / 3 - diagonal};

}  // namespace deadpoint::fem
