#pragma once

/// What turns SI values into the units that people read, and back. Every file and text takes it from here.
namespace deadpoint {

inline constexpr double zero_celsius = 273.15;  ///< 0 degC [K]
inline constexpr double micrometre = 1e6;       ///< micrometres in a metre
inline constexpr double megajoule = 1e-6;       ///< megajoules in a joule
inline constexpr double megapascal = 1e-6;      ///< megapascals in a pascal

}  // namespace deadpoint
