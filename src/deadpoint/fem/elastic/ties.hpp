#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/elastic/tie.hpp"

#include <map>
#include <vector>

/// Internal to fem/: bonded parts as ties, for the deformation.
namespace deadpoint::fem {

class Discretisation;

/// Nodes of the finer part of a bond follow the coarser part: u(node) = sum of weights times displacements of others.
///
/// First order: the displacements of both sides agree in the mean weighted with each dual function
/// psi of the finer side (dual_functions.hpp), integral of psi_s (u_fine - u_coarse) = 0, which
/// gives u_s explicitly, passes a uniform stress exactly, and keeps linear displacements: the
/// coarser side's cells are extrapolated to the finer side's points, which on faceted cylinders lie
/// slightly outside. Nodes of the finer side without a psi, beside a bond's edge or on an edge
/// between two bonds, enter the conditions of their neighbours.
///
/// With second order, and if the bond covers so little of a face that its psi would oscillate, the
/// node follows the coarser cell at its own position.
///
/// A node is tied if the other side's cell, extrapolated by at most a tenth of its size, reaches
/// it. The same on all ranks.
class Ties {
public:
    explicit Ties(const Discretisation& space);

    /// All ties, sorted so that a node comes after all nodes that it follows.
    [[nodiscard]] const std::vector<Tie>& ties() const { return ties_; }
    [[nodiscard]] bool is_tied(PetscInt node) const { return tied_[static_cast<std::size_t>(node)]; }

    /// Holds unknowns (3 node + component), even if their node is tied.
    void hold(const std::vector<PetscInt>& unknowns);
    /// True if this component of the node's displacement follows others.
    [[nodiscard]] bool follows(PetscInt node, PetscInt component) const
    {
        return is_tied(node) && !held_[3 * static_cast<std::size_t>(node) + component];
    }

    /// From free to all displacements, three per node: this rank's free nodes keep their order.
    [[nodiscard]] OwnedMat expansion(const Discretisation& space) const;
    /// This rank's free nodes, counted from its first node, in order.
    [[nodiscard]] std::vector<PetscInt> free_nodes(const Discretisation& space) const;
    /// The free nodes that each tied node follows in one component. A master that is tied itself is replaced by its own
    /// masters.
    [[nodiscard]] std::map<PetscInt, Masters> followed_in_the_end(PetscInt component) const;

private:
    std::vector<bool> tied_;  ///< per node
    std::vector<bool> held_;  ///< per displacement
    std::vector<Tie> ties_;
};

}  // namespace deadpoint::fem
