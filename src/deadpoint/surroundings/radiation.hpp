#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <vector>

namespace deadpoint::surroundings {

/// Stefan-Boltzmann constant [W/m2/K4] (CODATA 2018).
inline constexpr double stefan_boltzmann = 5.670374419e-8;

/// Radiation of a small grey surface in a large room, as a heat transfer coefficient on the difference T_s - T_a:
///
///   h = eps sigma (T_s^2 + T_a^2)(T_s + T_a)
///
/// exact, not linearised about a temperature: h (T_s - T_a) = eps sigma (T_s^4 - T_a^4) (Incropera et al., Fundamentals
/// of Heat and Mass Transfer, eq. 1.9). Surfaces that see each other: enclosure_exchange().
///
/// @param emissivity           eps, 0..1 [-]
/// @param surface_temperature  T_s > 0 [K]
/// @param ambient_temperature  T_a > 0, of the room's walls [K]
/// @return coefficient [W/m2/K] and its derivative by T_s [W/m2/K2]
/// @throws DomainError if the emissivity leaves 0..1 or a temperature is not positive
LawValue radiation_coefficient(double emissivity, double surface_temperature, double ambient_temperature);

/// Radiation among the grey, diffuse surfaces of a closed room, as exchange areas X_ij. Surface i
/// emits the net power
///
///   Q_i = sum over j of X_ij sigma (T_i^4 - T_j^4)        [W]
///   X = diag(eps A) (1 - F diag(1 - eps))^-1 F diag(eps)                                   (net radiosities)
///   F_ij = S u_i u_j / A_i,    u_i (1 - u_i) S = A_i,    sum of u_i = 1                    (view factors)
///
/// X is symmetric and its row i sums to eps_i A_i (Hottel and Sarofim, Radiative Transfer, ch. 3).
/// The view factors are those of Carroll (ASHRAE Trans. 86, 1980): reciprocal, and those of a
/// surface sum to 1. They treat surfaces as plane and distributed around the room, and need no
/// positions. If one surface is larger than all others together, the others see only it, and it
/// sees itself with the remaining share. Exact for two large parallel plates, two concentric
/// spheres or long cylinders, any surface that does not see itself inside one other, and surfaces
/// of equal size that see each other equally.
///
/// @param areas         A_i > 0 [m2]
/// @param emissivities  eps_i of each, above 0 and at most 1 [-]
/// @return X_ij [m2], row after row; for a surface that is alone X_11 = eps A
/// @throws DomainError if an argument leaves its range
std::vector<double> enclosure_exchange(const std::vector<double>& areas, const std::vector<double>& emissivities);

/// Convection with a constant coefficient and radiation to the room as one curve of the surface temperature.
/// @param coefficient  >= 0 [W/m2/K]
/// @throws DomainError as radiation_coefficient, or if the coefficient is negative
FilmLaw constant_film(double coefficient, double emissivity, double ambient_temperature);

}  // namespace deadpoint::surroundings
