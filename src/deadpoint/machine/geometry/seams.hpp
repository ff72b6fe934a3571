#pragma once

#include "deadpoint/machine/geometry/shapes.hpp"

#include <string>
#include <vector>

/// Joins shapes of one part where they nearly touch.
namespace deadpoint::machine {

struct Healed {
    std::vector<Prism> prisms;
    double moved = 0;  ///< the largest distance by which a surface was moved [m]
    Vec3 where{};      ///< a place on that surface; coordinates that do not matter are those of the shape's beginning
};

/// Joins surfaces of different shapes that lie within `tolerance` of each other, so that no gap,
/// overlap or sliver remains between them. Surfaces farther apart do not change.
///
/// - Planes across a coordinate axis (sides of boxes, ends of prisms, edges of outlines along an
/// axis): the plane of the shape listed first replaces the others. In a half model the plane of
/// symmetry comes first.
/// - Circles about one axis: centre and radius of the shape listed first.
/// - Corners of outlines: moved to a corner of an earlier outline, else onto an edge of it. A point
/// that still lies beside an edge becomes a corner of that edge.
///
/// Boxes stay boxes and circles stay circles. A circle beside a polygon's edge does not change.
/// @param half  the plane x = 0 is one of symmetry
/// @throws InputError naming part and shape if a shape is no thicker than the tolerance
Healed healed(const std::string& part, std::vector<Prism> prisms, double tolerance, bool half);

}  // namespace deadpoint::machine
