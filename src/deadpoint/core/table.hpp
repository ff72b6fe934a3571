#pragma once

#include <span>

namespace deadpoint {

/// Value of a piecewise curve and its derivative.
struct CurvePoint {
    double value = 0;
    double derivative = 0;  ///< 0 beyond the first and last point, where the value is held
    bool outside = false;   ///< `x` lies beyond the points
};

/// Linear between the points, held constant beyond them. At an inner point the derivative is that of the right side.
///
/// @param x  places, strictly increasing, at least one
/// @param y  values, as many as places
/// @throws DomainError if the sizes differ, x does not increase, or a number is not finite
CurvePoint interpolate_linear(std::span<const double> x, std::span<const double> y, double at);

}  // namespace deadpoint
