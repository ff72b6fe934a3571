#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The decimated surface of the machine, to show results.
namespace deadpoint {

/// A node of the mesh, named as a corner of one of its cells (numbered as in Cell::nodes).
struct CellCorner {
    std::uint32_t cell = 0;
    std::uint32_t corner = 0;
};

/// One part of a DecimatedSurface.
struct LightPart {
    std::size_t first_vertex = 0;
    std::size_t vertex_count = 0;
    std::size_t first_triangle = 0;
    std::size_t triangle_count = 0;
    std::size_t symmetry_triangles = 0;  ///< the last so many lie on the symmetry plane
    double area = 0;                     ///< of the triangles [m2]
    double full_area = 0;                ///< of the faces that they replace [m2]
};

/// Triangles between nodes of the mesh, counter-clockwise seen from outside. No vertex is shared between parts.
struct DecimatedSurface {
    std::vector<CellCorner> vertices;
    std::vector<Vec3> positions;  ///< of the vertices [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> faces;  ///< of the machine, that each triangle is a piece of or stands for
    std::vector<LightPart> parts;      ///< as Machine::parts
    double grid = 0;  ///< edge of the boxes within which nodes of the largest part were merged [m]; 0: none
};

}  // namespace deadpoint
