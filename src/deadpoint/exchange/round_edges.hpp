#pragma once

#include "deadpoint/core/vec.hpp"

#include <cstdint>

/// The shape of faces and cells whose edges are round: bilinear or linear between the nodes, with
/// the bulge of each edge added by the shape function of its middle node in an element of eight or
/// twenty (six or ten) nodes.
namespace deadpoint {

struct Cell;
struct Face;
struct Machine;

/// From the middle of the chord between two nodes to the middle of their edge; zero where it is straight [m].
Vec3 bulge(const Machine& machine, std::uint32_t a, std::uint32_t b);

bool is_round(const Machine& machine, const Face& face);
bool is_round(const Machine& machine, const Cell& cell);

/// A point of a face and its derivatives by the local coordinates.
struct FacePlace {
    Vec3 position{};
    Vec3 along_r{};
    Vec3 along_s{};
};
/// @param local  r and s in 0..1 from the first node towards the second and the last (of 4), or towards the second and
///               the third (of 3)
FacePlace place_on(const Machine& machine, const Face& face, const Vec2& local);

/// Position in a cell. @param local  0..1 each; a hexahedron's from node 0 towards nodes 1, 3 and 4, a tetrahedron's
///                                   towards nodes 1, 2 and 3
Vec3 place_in(const Machine& machine, const Cell& cell, const Vec3& local);

}  // namespace deadpoint
