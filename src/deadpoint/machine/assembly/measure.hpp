#pragma once

namespace deadpoint {
struct Machine;
struct MeshSurface;
struct SurfaceFigures;
}  // namespace deadpoint

/// Figures of parts and surfaces, from their mesh.
namespace deadpoint::machine {

/// Figures of a surface by its faces and their shares; its area is not read.
SurfaceFigures figures_of(const Machine& machine, const MeshSurface& surface);

/// Fills MeshPart::moments and MeshSurface::figures of all parts and surfaces.
///
/// The moments are integrals over the faces of a part, by the divergence theorem. They are exact: the faces of
/// hexahedra are bilinear, and Gauss's rule with three points each way has degree 5.
void measure(Machine& machine);

}  // namespace deadpoint::machine
