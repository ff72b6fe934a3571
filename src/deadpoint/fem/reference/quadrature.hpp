#pragma once

#include "deadpoint/core/vec.hpp"

#include <vector>

namespace deadpoint::fem {

class ReferenceElement;

/// Points and weights of an integration rule on a reference cell; the weights sum to its volume.
struct Quadrature {
    std::vector<Vec3> points;
    std::vector<double> weights;

    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(weights.size()); }
};

/// Gauss' product rule on the unit cube, exact for degree 2 n - 1 in each coordinate.
/// @param n  points per direction, 1 to 4
Quadrature gauss_on_cube(unsigned n);

/// A rule of 1, 6, 14 or 35 points on the unit tetrahedron, exact for polynomials of degree 2 n - 1. One point: the
/// centroid; 6 and 35: Xiao and Gimbutas, Comput. Math. Appl. 59 (2010) 663; 14: Walkington, Quadrature on simplices of
/// arbitrary dimension (2000).
/// @param n  1 to 4
Quadrature gauss_on_tetrahedron(unsigned n);

/// That of the two which fits an element.
Quadrature gauss_on(const ReferenceElement& element, unsigned n);

}  // namespace deadpoint::fem
