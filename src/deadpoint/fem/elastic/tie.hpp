#pragma once

#include "deadpoint/core/vec.hpp"

#include <petscsystypes.h>
#include <utility>
#include <vector>

/// Internal to fem/: one node that follows others.
namespace deadpoint::fem {

/// Displacement of a node if a bond opens by 1 along its normal and all others stay closed.
struct BondOpening {
    int bond = 0;  ///< index into Machine::bonds
    Vec3 normal{};
};
/// Nodes that are followed, with their weights; they may be tied themselves.
using Masters = std::vector<std::pair<PetscInt, double>>;
struct Tie {
    PetscInt node = 0;
    Masters masters;
    std::vector<BondOpening> openings;
};

}  // namespace deadpoint::fem
