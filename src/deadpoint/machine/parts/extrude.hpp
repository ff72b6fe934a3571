#pragma once

#include "deadpoint/machine/parts/layers.hpp"
#include "deadpoint/machine/parts/part_mesh.hpp"

namespace deadpoint::machine {

/// Hexahedra over the quadrilaterals of a plane mesh, layer by layer where the part is solid, with the planes and
/// cylinders of its faces.
PartMesh extrude(const LayeredPart& part, const PlaneMesh& plane, double size);

}  // namespace deadpoint::machine
