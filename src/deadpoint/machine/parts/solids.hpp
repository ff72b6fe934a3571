#pragma once

#include "deadpoint/machine/geometry/foreign_mesh.hpp"

#include <string>

namespace deadpoint {
class Observer;
}

/// Sources that become tetrahedra, or come meshed. All need a GmshSession.
namespace deadpoint::machine {

struct PartMesh;
struct Prism;

/// Tetrahedra of about `size` in the shapes of a part. @param half keep x <= 0 only
PartMesh mesh_tetrahedra(const std::string& name, const std::vector<Prism>& prisms, double size, bool half,
                         Observer& observer);

/// Tetrahedra in a solid of a STEP file; faces named in the file become groups. Small holes and roundings are left out
/// first (StepRules). The file is read in a process that can do nothing else (foreign_mesh.hpp).
/// @throws IoError if the file cannot be read, InputError if it holds no such solid, or several and none is chosen
PartMesh mesh_step(const PartDescription& part, const StepSource& source, double size, bool half,
                   const Waiting& waiting);

/// Cells of a Gmsh mesh file (MSH 2 or 4, text or binary); physical surfaces become groups. Planes and cylinders are
/// recognised. Cells of higher order are taken by their corners. The file is read in a process that can do nothing else
/// (foreign_mesh.hpp).
/// @throws IoError if the file cannot be read, InputError for another format and for cells other than hexahedra or
/// tetrahedra
PartMesh read_mesh(const PartDescription& part, const MeshSource& source, bool half, const Waiting& waiting);

}  // namespace deadpoint::machine
