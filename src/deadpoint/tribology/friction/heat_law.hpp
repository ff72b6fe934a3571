#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <vector>

/// Friction heat as a sum of parts.
namespace deadpoint::tribology {

struct Lubricant;

/// Heat that does not change with temperature [W].
/// @throws InputError if it is negative or not finite
HeatLaw constant_heat(double power);

/// Heat of an oil film and a constant part, load + per_viscosity eta(T), with the dynamic viscosity
/// eta = rho nu [W].
///
/// @param load           [W]
/// @param per_viscosity  heat of the film per unit of viscosity [W/(Pa s)]
/// @throws InputError if a law of the lubricant is missing
HeatLaw film_heat(double load, double per_viscosity, const Lubricant& lubricant);

/// The sum of several laws at one temperature, such as bearings that share a seat; in range where all of them are.
/// Without laws it is zero.
/// @throws InputError if a law is empty
HeatLaw summed_heat(std::vector<HeatLaw> laws);

}  // namespace deadpoint::tribology
