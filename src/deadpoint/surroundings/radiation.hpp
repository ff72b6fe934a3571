#pragma once

#include "deadpoint/exchange/laws.hpp"

namespace deadpoint::surroundings {

/// Stefan-Boltzmann constant [W/m2/K4] (CODATA 2018).
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// Radiation of a small grey surface in a large room, as a heat transfer coefficient on the difference T_s - T_a:
///
///   h = eps sigma (T_s^2 + T_a^2)(T_s + T_a)
///
/// exact, not linearised about a temperature: h (T_s - T_a) = eps sigma (T_s^4 - T_a^4) (Incropera et al., Fundamentals
/// of Heat and Mass Transfer, eq. 1.9). Left out: surfaces that see each other.
///
/// @param emissivity           eps, 0..1 [-]
/// @param surface_temperature  T_s > 0 [K]
/// @param ambient_temperature  T_a > 0, of the room's walls [K]
/// @return coefficient [W/m2/K] and its derivative by T_s [W/m2/K2]
/// @throws DomainError if the emissivity leaves 0..1 or a temperature is not positive
LawValue radiation_coefficient(double emissivity, double surface_temperature, double ambient_temperature);

/// Convection with a constant coefficient and radiation to the room as one curve of the surface temperature.
/// @param coefficient  >= 0 [W/m2/K]
/// @throws DomainError as radiation_coefficient, or if the coefficient is negative
FilmLaw constant_film(double coefficient, double emissivity, double ambient_temperature);

}  // namespace deadpoint::surroundings
