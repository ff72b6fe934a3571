#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace deadpoint {
struct ContactPoint;
}

/// Internal to fem/: the conditions that tie the nodes of one part to coarser ones.
namespace deadpoint::fem {

class Discretisation;
struct Tie;

/// One integration point of a bond, as the finer part sees it.
struct BondedPoint {
    int bond = 0;
    const ContactPoint* point = nullptr;
    bool a_is_finer = true;

    [[nodiscard]] const Vec3& position() const { return a_is_finer ? point->position_a : point->position_b; }
    [[nodiscard]] const Vec3& other_position() const { return a_is_finer ? point->position_b : point->position_a; }
    [[nodiscard]] std::uint32_t other_face() const { return a_is_finer ? point->face_b : point->face_a; }
    /// Out of the finer part, of unit length.
    [[nodiscard]] Vec3 normal() const { return (a_is_finer ? 1.0 : -1.0) * point->normal; }
};
/// By face of the finer part.
using BondedFaces = std::map<std::uint32_t, std::vector<BondedPoint>>;

/// Ties of one part, those of nodes that follow only other parts first.
std::vector<Tie> ties_of_part(const Discretisation& space, const BondedFaces& faces);

}  // namespace deadpoint::fem
