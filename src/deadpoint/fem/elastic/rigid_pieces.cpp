#include "deadpoint/fem/elastic/rigid_pieces.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/elastic/ties.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <set>

namespace deadpoint::fem {
namespace {

using Gram = Eigen::Matrix<double, 6, 6>;
using Column = Eigen::Matrix<double, 6, 1>;

Eigen::Map<const Column> column(const std::array<double, 6>& mode) { return Eigen::Map<const Column>(mode.data()); }

/// Rigid motions that no support constrains, orthonormal by inertia.
std::vector<Column> free_modes(const Gram& held, const Gram& inertia)
{
    const Eigen::SelfAdjointEigenSolver<Gram> solver(held);
    const double least = 1e-9 * std::max(1.0, solver.eigenvalues()[5]);
    std::vector<Column> free;
    for (int k = 0; k < 6; ++k) {
        if (solver.eigenvalues()[k] > least)
            continue;
        Column mode = solver.eigenvectors().col(k);
        for (const auto& other : free)
            mode -= (other.dot(inertia * mode)) * other;
        mode /= std::sqrt(mode.dot(inertia * mode));
        free.push_back(mode);
    }
    return free;
}

}  // namespace

RigidPieces::RigidPieces(const Discretisation& space, const std::vector<PetscInt>& supported, const Ties& ties)
    : space_(space)
{
    find_pieces();
    find_free_motions(supported);
    choose_holds(ties);
}

void RigidPieces::find_pieces()
{
    const auto nodes = static_cast<std::size_t>(space_.total);
    position_.resize(nodes);
    weight_.assign(nodes, 0.0);
    std::vector<int> rank(nodes), parent(nodes);
    boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
    for (std::size_t i = 0; i < nodes; ++i)
        sets.make_set(static_cast<int>(i));
    std::vector<std::size_t> dofs;
    for (std::uint32_t c = 0; c < space_.machine.cells.size(); ++c) {
        space_.cell_nodes(c, dofs, position_);
        const double share = space_.maps.volume(c) / static_cast<double>(dofs.size());
        for (const auto dof : dofs) {
            sets.union_set(static_cast<int>(dofs.front()), static_cast<int>(dof));
            weight_[dof] += share;
        }
    }
    for (const auto& bond : space_.machine.bonds)
        for (const auto& point : bond.points)
            sets.union_set(static_cast<int>(space_.vertex_unknown(space_.machine.faces[point.face_a].cell, 0)),
                           static_cast<int>(space_.vertex_unknown(space_.machine.faces[point.face_b].cell, 0)));

    std::map<int, int> number;
    piece_of_node_.resize(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto [at, added] = number.emplace(sets.find_set(static_cast<int>(i)), static_cast<int>(number.size()));
        piece_of_node_[i] = at->second;
    }
    pieces_.resize(number.size());
    for (std::size_t i = 0; i < nodes; ++i) {
        auto& piece = pieces_[piece_of_node_[i]];
        piece.centre = piece.centre + weight_[i] * position_[i];
        piece.weight += weight_[i];
    }
    for (auto& piece : pieces_)
        piece.centre = (1 / piece.weight) * piece.centre;
    for (std::size_t i = 0; i < nodes; ++i) {
        auto& piece = pieces_[piece_of_node_[i]];
        piece.size = std::max(piece.size, norm(position_[i] - piece.centre));
    }
}

// How much each of the six motions moves one component of a node: u = t + r x (position - centre) / size.
RigidPieces::Mode RigidPieces::row(const Piece& piece, const Vec3& position, int component) const
{
    const Vec3 arm = (1 / piece.size) * (position - piece.centre);
    Mode result{};
    result[component] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 rotation{};
        rotation[axis] = 1;
        result[3 + axis] = cross(rotation, arm)[component];
    }
    return result;
}

void RigidPieces::find_free_motions(const std::vector<PetscInt>& supported)
{
    std::vector<Gram> held(pieces_.size(), Gram::Zero()), inertia(pieces_.size(), Gram::Zero());
    for (const PetscInt unknown : supported) {
        const auto node = static_cast<std::size_t>(unknown / 3);
        const int piece = piece_of_node_[node];
        const auto r = row(pieces_[piece], position_[node], unknown % 3);
        held[piece] += column(r) * column(r).transpose();
    }
    for (std::size_t i = 0; i < position_.size(); ++i) {
        const int piece = piece_of_node_[i];
        for (int c = 0; c < 3; ++c) {
            const auto r = row(pieces_[piece], position_[i], c);
            inertia[piece] += weight_[i] / pieces_[piece].weight * column(r) * column(r).transpose();
        }
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p)
        for (const auto& mode : free_modes(held[p], inertia[p])) {
            pieces_[p].free.emplace_back();
            std::copy(mode.data(), mode.data() + 6, pieces_[p].free.back().begin());
        }
}

// Greedy choice: fix the unknown that the remaining free motions move most, then eliminate that motion.
void RigidPieces::choose_holds(const Ties& ties)
{
    struct Best {
        double size = 0;
        PetscInt unknown = -1;
        Column direction;
    };
    auto left = std::vector<Gram>(pieces_.size(), Gram::Zero());
    for (std::size_t p = 0; p < pieces_.size(); ++p)
        for (const auto& mode : pieces_[p].free)
            left[p] += column(mode) * column(mode).transpose();
    for (int round = 0; round < 6; ++round) {
        std::vector<Best> best(pieces_.size());
        for (std::size_t i = 0; i < position_.size(); ++i) {
            const int p = piece_of_node_[i];
            if (static_cast<int>(pieces_[p].free.size()) <= round || ties.is_tied(static_cast<PetscInt>(i)))
                continue;
            for (int c = 0; c < 3; ++c) {
                const auto r = row(pieces_[p], position_[i], c);
                const Column moved = left[p] * column(r);
                const double size = column(r).dot(moved);
                if (size > best[p].size * (1 + 1e-9))
                    best[p] = {size, static_cast<PetscInt>(3 * i + c), moved};
            }
        }
        for (std::size_t p = 0; p < pieces_.size(); ++p)
            if (best[p].unknown >= 0) {
                holds_.push_back(best[p].unknown);
                left[p] -= best[p].direction * best[p].direction.transpose() / best[p].size;
            }
    }
}

std::array<double, 3> RigidPieces::motion(const Piece& piece, const Mode& mode, std::size_t node) const
{
    const Vec3 arm = (1 / piece.size) * (position_[node] - piece.centre);
    return Vec3{mode[0], mode[1], mode[2]} + cross(Vec3{mode[3], mode[4], mode[5]}, arm);
}

// Visits (number of the motion, share of the node's volume in its piece, the motion there, the node's values).
template <class Visitor>
void RigidPieces::for_each_mode(double* values, const Visitor& visit) const
{
    for (PetscInt i = space_.first; i < space_.last; ++i) {
        const int p = piece_of_node_[i];
        for (std::size_t k = 0; k < pieces_[p].free.size(); ++k)
            visit(static_cast<std::size_t>(6 * p) + k, weight_[i] / pieces_[p].weight,
                  motion(pieces_[p], pieces_[p].free[k], static_cast<std::size_t>(i)), values + 3 * (i - space_.first));
    }
}

void RigidPieces::remove_rigid_motion(Vec displacement) const
{
    double* u = nullptr;
    DEADPOINT_PETSC(VecGetArray(displacement, &u));
    std::vector<double> amount(6 * pieces_.size(), 0.0);
    for_each_mode(u, [&](std::size_t k, double weight, const std::array<double, 3>& m, const double* at) {
        amount[k] += weight * (m[0] * at[0] + m[1] * at[1] + m[2] * at[2]);
    });
    sum_over_ranks(amount);
    for_each_mode(u, [&](std::size_t k, double, const std::array<double, 3>& m, double* at) {
        for (int c = 0; c < 3; ++c)
            at[c] -= amount[k] * m[c];
    });
    DEADPOINT_PETSC(VecRestoreArray(displacement, &u));
}

void RigidPieces::equilibrate(Vec load) const
{
    double* f = nullptr;
    DEADPOINT_PETSC(VecGetArray(load, &f));
    std::vector<double> work(6 * pieces_.size(), 0.0);
    for_each_mode(f, [&](std::size_t k, double, const std::array<double, 3>& m, const double* at) {
        work[k] += m[0] * at[0] + m[1] * at[1] + m[2] * at[2];
    });
    sum_over_ranks(work);
    for_each_mode(f, [&](std::size_t k, double weight, const std::array<double, 3>& m, double* at) {
        for (int c = 0; c < 3; ++c)
            at[c] -= work[k] * weight * m[c];
    });
    DEADPOINT_PETSC(VecRestoreArray(load, &f));
}

}  // namespace deadpoint::fem
