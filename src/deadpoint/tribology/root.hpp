#pragma once

#include <functional>

namespace deadpoint::tribology {

/// Root of a continuous, increasing function between two places, to rounding of the larger of them
/// (TOMS 748, Alefeld, Potra and Shi 1995). Returns `low` if the function is not below zero there,
/// and `high` if it is not above zero there.
/// @throws ConvergenceError if the function is not a number at one of the places, or after 200 evaluations
double increasing_root(const std::function<double(double)>& function, double low, double high);

}  // namespace deadpoint::tribology
