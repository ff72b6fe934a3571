#pragma once

#include "deadpoint/core/vec.hpp"

#include <optional>
#include <stdexcept>
#include <string>

namespace deadpoint {
class Observer;
}

namespace deadpoint::machine {

struct PartMesh;

struct TetrahedronSize {
    double size = 0;        ///< of cells [m]
    double smallest = 0;    ///< on curved faces [m]
    int circle_cells = 24;  ///< around a full circle, where `smallest` allows
    /// Small cells stay at curved faces; else those of edges continue into faces and solids, with up to ten times as
    /// many.
    bool fine_at_curves_only = false;
};

/// No attempt gave a mesh.
struct MeshFailure : std::runtime_error {
    MeshFailure(const std::string& reason, std::optional<Vec3> place) : runtime_error(reason), where(place) {}
    std::optional<Vec3> where;  ///< [m], in the model
};

/// Tetrahedra in the solids of Gmsh's model, whose lengths are millimetres; named surfaces become groups. Where cells
/// are bad or Gmsh gives up, other algorithms and slightly smaller cells are tried; the best mesh counts. Where cells
/// as small as `smallest` make the surface cross itself, as on narrow roundings that meet in a point, smaller ones are
/// tried on curved faces, and a note of the mesh says so. Empty where the model holds no solid.
/// @throws InputError if there would be too many cells, MeshFailure if no attempt gives a mesh
PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes, Observer& observer);
PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes);

}  // namespace deadpoint::machine
