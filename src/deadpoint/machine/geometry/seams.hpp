#pragma once

#include "deadpoint/machine/geometry/shapes.hpp"

#include <string>
#include <vector>

/// Shapes of one part are joined where they nearly touch.
namespace deadpoint::machine {

struct Healed {
    std::vector<Prism> prisms;
    double moved = 0;  ///< the longest way that a surface was moved [m]
    Vec3 where{};      ///< a place on that surface; coordinates that do not matter are those of the shape's beginning
};

/// Makes surfaces of different shapes that lie within `tolerance` of each other one surface, so that neither a gap nor
/// an overlap nor a sliver is left between them. What is farther apart stays as it is.
///
/// - Planes across a coordinate axis (sides of boxes, ends of prisms, edges of outlines along an axis): the one of the
///   shape listed first stands for all. In a half model the plane of symmetry stands before all.
/// - Circles about one axis: centre and radius of the shape listed first.
/// - Corners of outlines: moved to a corner of an earlier outline, else onto an edge of it. What then still lies beside
///   an edge becomes a corner of that edge.
///
/// Boxes stay boxes and circles stay circles. A circle beside a polygon's edge is not touched.
/// @param half  the plane x = 0 is one of symmetry
/// @throws InputError naming part and shape if a shape is no thicker than the tolerance
Healed healed(const std::string& part, std::vector<Prism> prisms, double tolerance, bool half);

}  // namespace deadpoint::machine
