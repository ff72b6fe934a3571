#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <string>
#include <utility>
#include <vector>

/// The mesh of one part, with its own numbering of nodes, cells and geometries.
namespace deadpoint::machine {

/// Named faces: indices into PartMesh::faces.
struct FaceGroup {
    std::string name;
    std::vector<std::uint32_t> faces;
};

/// `cells[i].part` and `faces[i].part` stay 0 here. Empty when the part lies wholly beyond the symmetry plane.
struct PartMesh {
    CellKind kind = CellKind::hexahedron;
    std::vector<Vec3> nodes;
    std::vector<Cell> cells;
    std::vector<Face> faces;
    std::vector<FaceGeometry> geometries;
    std::vector<FaceGroup> groups;
    std::vector<std::string> notes;  ///< of what was changed to make it
};

/// Number of nodes of a cell.
constexpr int node_count(CellKind kind) { return kind == CellKind::hexahedron ? 8 : 4; }

/// Number of faces of a cell.
constexpr int face_count(CellKind kind) { return kind == CellKind::hexahedron ? 6 : 4; }

/// A face of a cell by its number, counter-clockwise seen from outside; `cell` and `geometry` stay 0.
Face face_of(const Cell& cell, int number);

/// The nodes of a face in ascending order: equal for the two sides of a face.
using FaceKey = std::array<std::uint32_t, 4>;
FaceKey face_key(const Face& face);

/// The exterior faces of cells, counter-clockwise seen from outside, all with geometry 0.
std::vector<Face> exterior_faces(const std::vector<Cell>& cells);

/// Volume of a cell [m3]: exact for the trilinear map of a hexahedron.
double volume(const Cell& cell, const std::vector<Vec3>& nodes);
/// Area vector of a face [m2]: its length is the area of a plane face, it points outwards.
Vec3 area_vector(const Face& face, const std::vector<Vec3>& nodes);
/// Area of a face [m2] (bilinear facets by 2 x 2 Gauss points).
double area(const Face& face, const std::vector<Vec3>& nodes);
Vec3 centre(const Face& face, const std::vector<Vec3>& nodes);
Vec3 centre(const Cell& cell, const std::vector<Vec3>& nodes);

/// Whether a point lies behind every face of a cell, of which warped faces count as the plane through their middle.
bool inside(const Cell& cell, const std::vector<Vec3>& nodes, const Vec3& point);

/// How far a cell is from one that spoils gradients: the smallest scaled Jacobian det(a, b, c) / (|a| |b| |c|) over the
/// corners of a hexahedron, with a, b, c its edges there; sqrt(2) times the largest one of a tetrahedron, at most 1, so
/// that a regular one has 1. Thin cells are as good as thick ones, as they are for the error of interpolation, which
/// grows with the largest angle only (Krizek, SIAM J. Numer. Anal. 29, 1992). 0 or less is degenerate.
double quality(const Cell& cell, const std::vector<Vec3>& nodes);
/// The cell of least quality of a mesh.
struct Worst {
    double quality = 1;
    Vec3 where{};  ///< its centre [m]
};
Worst worst_cell(const PartMesh& mesh);

/// Position on the bilinear (4 nodes) or linear (3 nodes) facet at the local coordinates; a triangle uses (r, s) as its
/// second and third barycentric coordinate, a quadrilateral r and s in 0..1.
Vec3 position_on(const Face& face, const std::vector<Vec3>& nodes, const Vec2& local);

}  // namespace deadpoint::machine
