#include "deadpoint/fem/elastic/condensation.hpp"

#include "deadpoint/fem/elastic/ties.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace deadpoint::fem {

Condensation::Condensation(const Discretisation& space, const Ties& ties)
    : number_(static_cast<std::size_t>(space.total), -1)
{
    PetscInt count = 0;
    for (PetscInt node = 0; node < space.total; ++node) {
        if (node == space.first)
            first_ = count;
        if (!ties.is_tied(node))
            number_[static_cast<std::size_t>(node)] = count++;
        if (node + 1 == space.last)
            last_ = count;
    }
    for (PetscInt c = 0; c < 3; ++c)
        followed_[static_cast<std::size_t>(c)] = ties.followed_in_the_end(c);
}

std::vector<PetscInt> Condensation::free_nodes(std::span<const PetscInt> nodes) const
{
    std::vector<PetscInt> result;
    for (const PetscInt node : nodes)
        if (is_free(node))
            result.push_back(number_[static_cast<std::size_t>(node)]);
        else
            for (const auto& followed : followed_)
                for (const auto& [master, weight] : followed.at(node))
                    result.push_back(number_[static_cast<std::size_t>(master)]);
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<PetscInt> Condensation::condense(std::span<const PetscInt> nodes, std::vector<double>& matrix) const
{
    std::vector<PetscInt> displacements;
    if (std::ranges::all_of(nodes, [&](PetscInt node) { return is_free(node); })) {
        for (const PetscInt node : nodes)
            for (PetscInt c = 0; c < 3; ++c)
                displacements.push_back(3 * number_[static_cast<std::size_t>(node)] + c);
        return displacements;
    }
    const auto free = free_nodes(nodes);
    const auto place = [&](PetscInt node) {
        return 3 * (std::ranges::lower_bound(free, number_[static_cast<std::size_t>(node)]) - free.begin());
    };
    const auto all = static_cast<Eigen::Index>(3 * nodes.size()), kept = static_cast<Eigen::Index>(3 * free.size());
    Eigen::MatrixXd expansion = Eigen::MatrixXd::Zero(all, kept);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto row = static_cast<Eigen::Index>(3 * i + c);
            const auto component = static_cast<Eigen::Index>(c);
            if (is_free(nodes[i]))
                expansion(row, place(nodes[i]) + component) = 1;
            else
                for (const auto& [master, weight] : followed_[c].at(nodes[i]))
                    expansion(row, place(master) + component) += weight;
        }
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const RowMajor condensed = expansion.transpose() * Eigen::Map<const RowMajor>(matrix.data(), all, all) * expansion;
    matrix.assign(condensed.data(), condensed.data() + condensed.size());
    for (const PetscInt number : free)
        for (PetscInt c = 0; c < 3; ++c)
            displacements.push_back(3 * number + c);
    return displacements;
}

}  // namespace deadpoint::fem
