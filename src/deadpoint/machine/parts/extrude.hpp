#pragma once

namespace deadpoint::machine {

struct LayeredPart;
struct PartMesh;
struct PlaneMesh;

/// Hexahedra over the quadrilaterals of a plane mesh, layer by layer where the part is solid, with the planes and
/// cylinders of its faces.
PartMesh extrude(const LayeredPart& part, const PlaneMesh& plane, double size);

}  // namespace deadpoint::machine
