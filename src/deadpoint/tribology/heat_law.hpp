#pragma once

#include "deadpoint/exchange/laws.hpp"

#include <vector>

/// Friction heat put together from parts.
namespace deadpoint::tribology {

/// Heat that does not change with temperature [W].
/// @throws InputError if it is negative or not finite
HeatLaw constant_heat(double power);

/// The sum of several laws at one temperature, such as bearings that share a seat; in range where all of them are.
/// Without laws it is zero.
/// @throws InputError if a law is empty
HeatLaw summed_heat(std::vector<HeatLaw> laws);

}  // namespace deadpoint::tribology
