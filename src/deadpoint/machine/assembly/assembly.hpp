#pragma once

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <string>
#include <vector>

/// The machine during assembly.
namespace deadpoint::machine {

struct PartGroup {
    std::uint32_t part = 0;
    FaceGroup group;  ///< indices into Machine::faces
};

struct Assembly {
    Machine machine;
    std::vector<PartGroup> groups;
    std::vector<std::uint32_t> part_of_geometry;
    std::vector<std::vector<std::uint32_t>> faces_of_geometry;  ///< without those on the symmetry plane
    std::vector<BoxShape> bounds;                               ///< of each part
    bool second_order = false;                                  ///< some part is
};

/// Appends the mesh of a part: renumbers, measures, flags the symmetry plane.
void append(Assembly& assembly, const PartDescription& part, PartMesh mesh);

/// A length in millimetres to a tenth of a micrometre, as messages state it; never -0.
double millimetres(double length);

/// "plane x = -480 mm", "bore of diameter 91 mm along z about (0, -25) mm", "freeform surface".
std::string describe(const FaceGeometry& geometry);

}  // namespace deadpoint::machine
