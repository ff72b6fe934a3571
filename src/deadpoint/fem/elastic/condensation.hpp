#pragma once

#include "deadpoint/fem/elastic/tie.hpp"

#include <array>
#include <map>
#include <petscsystypes.h>
#include <span>
#include <vector>

/// Internal to fem/: matrices of the free displacements.
namespace deadpoint::fem {

class Discretisation;
class Ties;

/// Matrices of all displacements of a few nodes, as matrices of the free displacements that they follow: E^T A E, with
/// E from free to all displacements (Ties). Free nodes are numbered in the order of all nodes, on all ranks.
class Condensation {
public:
    Condensation(const Discretisation& space, const Ties& ties);

    /// Free nodes of this rank: first() <= number < last().
    [[nodiscard]] PetscInt first() const { return first_; }
    [[nodiscard]] PetscInt last() const { return last_; }
    /// The free nodes that move these nodes, each once.
    [[nodiscard]] std::vector<PetscInt> free_nodes(std::span<const PetscInt> nodes) const;
    /// @param matrix  three rows and columns per node, row by row; becomes the condensed one
    /// @return its free displacements: 3 times the number of a free node, plus the component
    std::vector<PetscInt> condense(std::span<const PetscInt> nodes, std::vector<double>& matrix) const;

private:
    [[nodiscard]] bool is_free(PetscInt node) const { return number_[static_cast<std::size_t>(node)] >= 0; }

    PetscInt first_ = 0, last_ = 0;
    std::vector<PetscInt> number_;  ///< per node: among the free nodes; negative where it is tied
    std::array<std::map<PetscInt, Masters>, 3> followed_;  ///< per component: free nodes that a tied node follows
};

}  // namespace deadpoint::fem
