#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"

#include <array>
#include <vector>

/// Internal to fem/: the connected pieces of the machine and the rigid motions that their supports leave free.
namespace deadpoint::fem {

class Discretisation;

class Ties;

/// Cells that share nodes or bonds make a piece; a body may consist of several (two plates of one link).
///
/// If its supports (symmetry plane, feet) leave a piece free to move, as many of its unknowns are
/// held as it has free rigid motions. They are chosen far apart, one after the other, each where
/// the remaining motions are largest. Thermal loads are in equilibrium, so these constraints carry
/// no force. equilibrate() removes rigid motion from functionals, so that no result depends on the
/// choice.
class RigidPieces {
public:
    /// @param supported  unknowns (3 node + component) that are held anyway, the same on all ranks
    RigidPieces(const Discretisation& space, const std::vector<PetscInt>& supported, const Ties& ties);

    /// Unknowns to hold besides the supported ones, on all ranks.
    [[nodiscard]] const std::vector<PetscInt>& holds() const { return holds_; }
    /// Number of the piece that a node belongs to.
    [[nodiscard]] int piece(PetscInt node) const { return piece_of_node_[static_cast<std::size_t>(node)]; }
    /// Removes the mean rigid motion from a displacement (this rank's share).
    void remove_rigid_motion(Vec displacement) const;
    /// The transpose of that: makes a load do no work in a free rigid motion.
    void equilibrate(Vec load) const;

private:
    using Mode = std::array<double, 6>;  ///< translation, then rotation about the piece's centre times its size
    struct Piece {
        Vec3 centre{};
        double size = 0;
        double weight = 0;
        std::vector<Mode> free;  ///< orthonormal in the mean over the piece's volume
    };
    [[nodiscard]] std::array<double, 3> motion(const Piece& piece, const Mode& mode, std::size_t node) const;
    template <class Visitor>
    void for_each_mode(double* values, const Visitor& visit) const;
    void find_pieces();
    void find_free_motions(const std::vector<PetscInt>& supported);
    void choose_holds(const Ties& ties);
    [[nodiscard]] Mode row(const Piece& piece, const Vec3& position, int component) const;

    const Discretisation& space_;
    std::vector<int> piece_of_node_;
    std::vector<Vec3> position_;
    std::vector<double> weight_;  ///< volume of a node [m3]
    std::vector<Piece> pieces_;
    std::vector<PetscInt> holds_;
};

}  // namespace deadpoint::fem
