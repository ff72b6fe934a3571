#pragma once

#include <numbers>

/// The units of formulas in the literature on bearings, in SI.
namespace deadpoint::tribology {

inline constexpr double square_millimetre = 1e-6;                     ///< [m2]
inline constexpr double turn_per_minute = 2 * std::numbers::pi / 60;  ///< [rad/s]

}  // namespace deadpoint::tribology
