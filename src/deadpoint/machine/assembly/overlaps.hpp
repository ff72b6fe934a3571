#pragma once

#include "deadpoint/machine/geometry/shapes.hpp"

#include <vector>

namespace deadpoint::machine {

struct Assembly;

/// Pairs of parts that interpenetrate, with the deepest point found.
///
/// Nodes, centres of faces and centres of cells of each part are tested against the exact shapes of
/// the other, or against its cells where it was imported. A part thinner than the cells of another
/// one may be missed.
/// @param shapes  per part of the machine; empty for imported parts
std::vector<Overlap> find_overlaps(const Assembly& assembly, const std::vector<std::vector<Prism>>& shapes);

/// Interpenetration below this is not reported: tolerances, and the chords of faceted bores [m].
inline constexpr double least_overlap = 1e-4;

}  // namespace deadpoint::machine
