#pragma once

#include "deadpoint/fem/discretisation.hpp"

#include <map>
#include <utility>
#include <vector>

/// Internal to fem/: bonded parts as ties, for the deformation.
namespace deadpoint::fem {

/// Every node of the finer part that lies on a bond moves with the cell of the coarser part there:
/// u(node) = sum of that cell's shape functions at the node's place times its nodes' displacements.
///
/// The weights reproduce linear displacements exactly, also where the node of a faceted cylinder lies a little off the
/// other side's facets (the shape functions are continued out of the cell by at most a tenth of its size). A node on
/// several bonds follows the first. Masters that are tied themselves are replaced by theirs. The same on all ranks.
class Ties {
public:
    explicit Ties(const Discretisation& space);

    /// A node and the cell that it follows, as the bonds say it.
    struct Direct {
        PetscInt node = 0;
        int bond = 0;                                      ///< index into Machine::bonds
        Vec3 normal{};                                     ///< of the bond there, unit, out of the node's part
        std::vector<std::pair<PetscInt, double>> masters;  ///< these may be tied themselves
    };
    /// All of them; a node stands behind all nodes that it follows.
    [[nodiscard]] const std::vector<Direct>& direct() const { return direct_; }

    /// Per tied node its masters, all of them free, and their weights.
    [[nodiscard]] const std::map<PetscInt, std::vector<std::pair<PetscInt, double>>>& tied() const { return tied_; }
    [[nodiscard]] bool is_tied(PetscInt node) const { return tied_.contains(node); }

    /// From free to all displacements, three per node: this rank's free nodes keep their order.
    [[nodiscard]] OwnedMat expansion(const Discretisation& space) const;
    /// This rank's free nodes, counted from its first node, in order.
    [[nodiscard]] std::vector<PetscInt> free_nodes(const Discretisation& space) const;

private:
    std::map<PetscInt, std::vector<std::pair<PetscInt, double>>> tied_;
    std::vector<Direct> direct_;
};

}  // namespace deadpoint::fem
