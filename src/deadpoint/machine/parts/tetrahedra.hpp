#pragma once

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

/// Tetrahedra in the solids of Gmsh's model, whose lengths are millimetres; named surfaces become groups. Where cells
/// are bad or Gmsh gives up, other algorithms and slightly smaller cells are tried; the best mesh counts. Empty where
/// the model holds no solid.
/// @throws InputError if there would be too many cells, and Gmsh's own error if no attempt gives a mesh
PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes, Observer& observer);
PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes);

}  // namespace deadpoint::machine
