#pragma once

#include <cstddef>

namespace deadpoint {
struct DecimatedSurface;
struct Machine;
}  // namespace deadpoint

namespace deadpoint::machine {

/// The decimated surface: exterior faces of all parts with a limited number of triangles.
///
/// Nodes in one box of a regular grid become one of them (vertex clustering; Rossignac and Borrel
/// 1993), but only where they lie on the same faces of the solid: a node on a plane, on the edge
/// between two, or at a corner stays there. Cylinders count as eight faces around, freeform faces
/// as six by their direction, so that thin walls and small shafts keep two sides. The grid is
/// widened until the limit is met. If the faces of the solids alone are too many, they are merged
/// as well.
///
/// @param most_triangles  at least 4 per part are used in the worst case
DecimatedSurface decimated_surface(const Machine& machine, std::size_t most_triangles);

}  // namespace deadpoint::machine
