#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <functional>
#include <string>

/// The mesh in Gmsh's current model. Needs a GmshSession.
namespace deadpoint::machine {

struct PartMesh;

/// Types of elements in Gmsh's numbering.
inline constexpr int triangle_type = 2;
inline constexpr int quad_type = 3;
inline constexpr int tetrahedron_type = 4;
inline constexpr int hexahedron_type = 5;

/// Source of the names of groups of faces: physical surfaces always, and the surfaces of a solid
/// model.
enum class SurfaceNames { from_groups, from_model };

/// Cells of one kind, their exterior faces with recognised planes and cylinders, and groups of faces.
/// @param unit    length of one unit of the model [m]
/// @param adjust  called after reading the cells: may move nodes and drop cells; may be empty
PartMesh collect_mesh(CellKind kind, double unit, SurfaceNames names, const std::function<void(PartMesh&)>& adjust);

/// @throws IoError naming the part if the file is not there or cannot be read
void require_readable(const std::string& part, const std::string& path);

}  // namespace deadpoint::machine
