#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <vector>

/// Planes and cylinders recognised in facets.
namespace deadpoint::machine {

struct PartMesh;

/// The plane or cylinder on which all nodes of these faces lie within 0.1 um (or 1e-6 of the radius); else freeform.
FaceGeometry fit_geometry(const std::vector<Face>& faces, const std::vector<std::uint32_t>& members,
                          const std::vector<Vec3>& nodes);

/// Gives every face of a mesh its geometry: faces with one label belong together (a surface of the model, or a group);
/// faces labelled -1 and those whose common surface is neither plane nor cylinder are divided into smooth patches.
void recognise_geometries(PartMesh& mesh, const std::vector<int>& labels);

}  // namespace deadpoint::machine
