#pragma once

#include <numbers>

/// What turns SI values into the units that people read, and back. Every file and text takes it from here.
namespace deadpoint {

inline constexpr double zero_celsius = 273.15;             ///< 0 degC [K]
inline constexpr double micrometre = 1e6;                  ///< micrometres in a metre
inline constexpr double kilonewton = 1e-3;                 ///< kilonewtons in a newton
inline constexpr double megajoule = 1e-6;                  ///< megajoules in a joule
inline constexpr double megapascal = 1e-6;                 ///< megapascals in a pascal
inline constexpr double hour = 3600;                       ///< seconds in an hour
inline constexpr double hours = 1.0 / 3600;                ///< hours in a second
inline constexpr double full_turn = 2 * std::numbers::pi;  ///< radians in a turn
inline constexpr double degrees = 180 / std::numbers::pi;  ///< degrees in a radian
inline constexpr double rpm = 30 / std::numbers::pi;       ///< revolutions per minute in a radian per second

}  // namespace deadpoint
