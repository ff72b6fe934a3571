#pragma once

#include "deadpoint/exchange/light_surface.hpp"
#include "deadpoint/exchange/machine.hpp"

namespace deadpoint::machine {

/// The exterior faces of all parts with at most so many triangles.
///
/// Nodes in one box of a regular grid become one of them (vertex clustering; Rossignac and Borrel 1993), but only where
/// they lie on the same faces of the solid: what is on one plane, on the edge between two, or at a corner, stays there.
/// Cylinders count as eight faces around, freeform faces as six by their direction, so that thin walls and small
/// shafts keep two sides. The grid is widened until the triangles suffice. Should the faces of the solids alone be too
/// many, they are merged as well.
///
/// @param most_triangles  at least 4 per part are used in the worst case
LightSurface light_surface(const Machine& machine, std::size_t most_triangles);

}  // namespace deadpoint::machine
