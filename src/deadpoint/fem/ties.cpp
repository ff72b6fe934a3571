#include "deadpoint/fem/ties.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deadpoint::fem {
namespace {

constexpr double largest_continuation = 0.1;

// Parts from fine to coarse, by the distance of their nodes: a part's place in this order.
std::vector<std::size_t> coarseness(const Discretisation& space)
{
    const auto& machine = space.machine;
    std::vector<std::size_t> order(machine.parts.size());
    std::iota(order.begin(), order.end(), 0);
    const auto volume_per_node = [&](std::size_t p) {
        return machine.parts[p].volume / machine.parts[p].cell_count / std::pow(space.orders[p], 3);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return volume_per_node(a) < volume_per_node(b); });
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        place[order[i]] = i;
    return place;
}

}  // namespace

Ties::Ties(const Discretisation& space)
{
    const auto& machine = space.machine;
    const auto place = coarseness(space);

    // Per part: nodes that may be tied, and the cells they may be tied to.
    struct Candidate {
        std::map<std::uint32_t, int> cells;  // with the bond
        std::map<int, Vec3> normals;         // by bond, not of unit length
    };
    std::vector<std::map<PetscInt, Candidate>> candidates(machine.parts.size());
    PointShape shape;
    std::vector<std::size_t> unknowns;
    std::vector<Vec3> all_positions(static_cast<std::size_t>(space.total));
    for (int b = 0; b < static_cast<int>(machine.bonds.size()); ++b) {
        const auto& bond = machine.bonds[b];
        std::pair<std::uint32_t, std::uint32_t> previous{~0U, ~0U};
        for (const auto& point : bond.points) {
            if (std::pair(point.face_a, point.face_b) == previous)
                continue;
            previous = {point.face_a, point.face_b};
            const bool a_is_finer = place[machine.faces[point.face_a].part] < place[machine.faces[point.face_b].part];
            const auto fine = a_is_finer ? point.face_a : point.face_b;
            const auto coarse = a_is_finer ? point.face_b : point.face_a;
            space.evaluate(fine, a_is_finer ? point.position_a : point.position_b, false, shape);
            space.cell_nodes(machine.faces[fine].cell, unknowns, all_positions);
            for (int i = 0; i < shape.count; ++i)
                if (std::abs(shape.value[i]) > 1e-9) {
                    auto& candidate = candidates[machine.faces[fine].part][shape.dof[i]];
                    candidate.cells.emplace(machine.faces[coarse].cell, b);
                    auto& normal = candidate.normals[b];
                    normal = normal + (a_is_finer ? 1.0 : -1.0) * point.normal;
                }
        }
    }

    std::vector<std::size_t> parts(machine.parts.size());
    std::iota(parts.begin(), parts.end(), 0);
    std::sort(parts.begin(), parts.end(), [&](std::size_t a, std::size_t b) { return place[a] > place[b]; });
    for (const auto part : parts)
        for (const auto& [node, candidate] : candidates[part]) {
            double least = largest_continuation;
            PointShape best;
            int followed = -1;
            for (const auto& [cell, bond] : candidate.cells) {
                const double outside = space.continue_cell(cell, all_positions[static_cast<std::size_t>(node)], shape);
                if (outside < least) {
                    least = outside;
                    best = shape;
                    followed = bond;
                }
            }
            if (best.count == 0)
                continue;
            Direct direct{node, followed, normalised(candidate.normals.at(followed)), {}};
            std::map<PetscInt, double> weights;
            for (int i = 0; i < best.count; ++i) {
                if (std::abs(best.value[i]) < 1e-12)
                    continue;
                direct.masters.emplace_back(best.dof[i], best.value[i]);
                if (const auto chained = tied_.find(best.dof[i]); chained != tied_.end())
                    for (const auto& [master, weight] : chained->second)
                        weights[master] += best.value[i] * weight;
                else
                    weights[best.dof[i]] += best.value[i];
            }
            tied_[node].assign(weights.begin(), weights.end());
            direct_.push_back(std::move(direct));
        }
}

std::vector<PetscInt> Ties::free_nodes(const Discretisation& space) const
{
    std::vector<PetscInt> nodes;
    for (PetscInt node = space.first; node < space.last; ++node)
        if (!is_tied(node))
            nodes.push_back(node - space.first);
    return nodes;
}

OwnedMat Ties::expansion(const Discretisation& space) const
{
    // Number of a free node among the free nodes of all ranks.
    std::vector<PetscInt> number(static_cast<std::size_t>(space.total), -1);
    PetscInt count = 0;
    for (PetscInt node = 0; node < space.total; ++node)
        if (!is_tied(node))
            number[static_cast<std::size_t>(node)] = count++;
    const auto mine = static_cast<PetscInt>(free_nodes(space).size());
    const PetscInt rows = space.last - space.first;

    std::size_t longest = 1;
    for (const auto& [node, masters] : tied_)
        longest = std::max(longest, masters.size());
    OwnedMat matrix;
    DEADPOINT_PETSC(MatCreate(PETSC_COMM_WORLD, matrix.out()));
    DEADPOINT_PETSC(MatSetSizes(matrix, 3 * rows, 3 * mine, 3 * space.total, 3 * count));
    DEADPOINT_PETSC(MatSetType(matrix, MATAIJ));
    std::vector<PetscInt> entries(static_cast<std::size_t>(3 * rows), 1);
    for (const auto& [node, masters] : tied_)
        if (space.owns(node))
            std::fill_n(entries.begin() + 3 * (node - space.first), 3, static_cast<PetscInt>(masters.size()));
    DEADPOINT_PETSC(MatSeqAIJSetPreallocation(matrix, 0, entries.data()));
    DEADPOINT_PETSC(MatMPIAIJSetPreallocation(matrix, 0, entries.data(), 0, entries.data()));
    for (PetscInt node = space.first; node < space.last; ++node)
        for (PetscInt c = 0; c < 3; ++c)
            if (const auto tie = tied_.find(node); tie != tied_.end())
                for (const auto& [master, weight] : tie->second)
                    DEADPOINT_PETSC(MatSetValue(matrix, 3 * node + c, 3 * number[static_cast<std::size_t>(master)] + c,
                                                weight, INSERT_VALUES));
            else
                DEADPOINT_PETSC(MatSetValue(matrix, 3 * node + c, 3 * number[static_cast<std::size_t>(node)] + c, 1,
                                            INSERT_VALUES));
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return matrix;
}

}  // namespace deadpoint::fem
