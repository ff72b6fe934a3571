#include "deadpoint/fem/elastic/ties.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/elastic/tie_conditions.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace deadpoint::fem {
namespace {

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
    : tied_(static_cast<std::size_t>(space.total)), held_(static_cast<std::size_t>(3 * space.total))
{
    const auto& machine = space.machine;
    const auto place = coarseness(space);
    std::vector<BondedFaces> faces(machine.parts.size());
    for (int b = 0; b < static_cast<int>(machine.bonds.size()); ++b)
        for (const auto& point : machine.bonds[b].points) {
            const bool a_is_finer = place[machine.faces[point.face_a].part] < place[machine.faces[point.face_b].part];
            const auto fine = a_is_finer ? point.face_a : point.face_b;
            faces[machine.faces[fine].part][fine].push_back({b, &point, a_is_finer});
        }

    std::vector<std::size_t> parts(machine.parts.size());
    std::iota(parts.begin(), parts.end(), 0);
    std::ranges::sort(parts, [&](std::size_t a, std::size_t b) { return place[a] > place[b]; });
    for (const auto part : parts)
        std::ranges::move(ties_of_part(space, faces[part]), std::back_inserter(ties_));
    for (const auto& tie : ties_)
        tied_[static_cast<std::size_t>(tie.node)] = true;
}

void Ties::hold(const std::vector<PetscInt>& unknowns)
{
    for (const auto unknown : unknowns)
        held_[static_cast<std::size_t>(unknown)] = true;
}

std::map<PetscInt, Masters> Ties::followed_in_the_end(PetscInt component) const
{
    std::map<PetscInt, Masters> result;
    for (const auto& tie : ties_) {
        auto& masters = result[tie.node];
        if (!follows(tie.node, component))
            continue;
        std::map<PetscInt, double> weights;
        for (const auto& [node, weight] : tie.masters)
            if (is_tied(node))
                for (const auto& [master, share] : result.at(node))
                    weights[master] += weight * share;
            else
                weights[node] += weight;
        masters.assign(weights.begin(), weights.end());
    }
    return result;
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
    // Returns the number of a free node among the free nodes of all ranks.
    std::vector<PetscInt> number(static_cast<std::size_t>(space.total), -1);
    PetscInt count = 0;
    for (PetscInt node = 0; node < space.total; ++node)
        if (!is_tied(node))
            number[static_cast<std::size_t>(node)] = count++;
    const auto mine = static_cast<PetscInt>(free_nodes(space).size());
    const PetscInt rows = space.last - space.first;

    std::array<std::map<PetscInt, Masters>, 3> followed;
    std::vector<PetscInt> entries(static_cast<std::size_t>(3 * rows), 1);
    for (PetscInt c = 0; c < 3; ++c) {
        followed[c] = followed_in_the_end(c);
        for (const auto& [node, masters] : followed[c])
            if (space.owns(node))
                entries[3 * (node - space.first) + c] = static_cast<PetscInt>(masters.size());
    }
    OwnedMat matrix;
    DEADPOINT_PETSC(MatCreate(PETSC_COMM_WORLD, matrix.out()));
    DEADPOINT_PETSC(MatSetSizes(matrix, 3 * rows, 3 * mine, 3 * space.total, 3 * count));
    DEADPOINT_PETSC(MatSetType(matrix, MATAIJ));
    DEADPOINT_PETSC(MatSeqAIJSetPreallocation(matrix, 0, entries.data()));
    DEADPOINT_PETSC(MatMPIAIJSetPreallocation(matrix, 0, entries.data(), 0, entries.data()));
    const auto set = [&](PetscInt node, PetscInt master, PetscInt c, double weight) {
        DEADPOINT_PETSC(
            MatSetValue(matrix, 3 * node + c, 3 * number[static_cast<std::size_t>(master)] + c, weight, INSERT_VALUES));
    };
    for (PetscInt node = space.first; node < space.last; ++node)
        for (PetscInt c = 0; c < 3; ++c)
            if (!is_tied(node))
                set(node, node, c, 1);
            else
                for (const auto& [master, weight] : followed[c].at(node))
                    set(node, master, c, weight);
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return matrix;
}

}  // namespace deadpoint::fem
