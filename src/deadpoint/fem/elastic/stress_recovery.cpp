#include "deadpoint/fem/elastic/stress_recovery.hpp"

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/elastic/elastic_law.hpp"
#include "deadpoint/fem/space/cell_values.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <unordered_map>

namespace deadpoint::fem {
namespace {

// Cells in a direction count as distinct if their centres spread by more than this share of the cells' extent. Two
// layers have 3, one layer 0.
constexpr double least_spread = 0.5;
// The same for points within the cells, which add 1 to it.
constexpr double least_spread_within = 2.5;
constexpr std::size_t least_tetrahedra = 12;  // stress in tetrahedra scatters, so a fit needs many

// One rule of sampling points per kind of element.
std::vector<Quadrature> sampling_points(const std::vector<ReferenceElement>& elements, bool within)
{
    std::vector<Quadrature> rules;
    for (const auto& element : elements)
        rules.push_back(gauss_on(element, element.degree() > 1 || within ? 2 : 1));
    return rules;
}

Tensor6 stress_at(const CellValues& v, unsigned q, const std::vector<PetscInt>& dofs, const Material& material,
                  int part, const StrainedState& state)
{
    Tensor6 strain{};
    double rise = 0;
    for (unsigned i = 0; i < dofs.size(); ++i) {
        const auto& g = v.shape_grad(i, q);
        const double* u = state.displacement + 3 * dofs[i];
        for (unsigned c = 0; c < 3; ++c) {
            strain[c] += g[c] * u[c];
            strain[3 + c] += 0.5 * (g[c] * u[(c + 1) % 3] + g[(c + 1) % 3] * u[c]);
        }
        if (state.rise)
            rise += v.shape_value(i, q) * state.rise[dofs[i]];
    }
    for (unsigned c = 0; c < 3; ++c)
        strain[c] -= expansion_scale(material) * rise;
    if (!state.initial.empty())
        for (unsigned c = 0; c < 6; ++c)
            strain[c] -= state.initial[static_cast<std::size_t>(part)][c];
    return hooke(material, strain);
}

Eigen::Vector3d vector(const Vec3& x) { return {x[0], x[1], x[2]}; }

}  // namespace

StressRecovery::StressRecovery(const Discretisation& space, const Material& material, int part,
                               const StrainedState& state)
    : space_(space), part_(part)
{
    number_nodes();
    sample(material, state);
}

void StressRecovery::number_nodes()
{
    const auto& machine = space_.machine;
    const auto& part = machine.parts[static_cast<std::size_t>(part_)];
    std::unordered_map<std::uint32_t, std::uint32_t> place;
    for (std::uint32_t c = 0; c < part.cell_count; ++c) {
        const auto& source = machine.cells[part.first_cell + c];
        CellData cell;
        cell.node_count = source.kind == CellKind::hexahedron ? 8 : 4;
        for (unsigned i = 0; i < cell.node_count; ++i) {
            const auto [at, added] = place.emplace(source.nodes[i], static_cast<std::uint32_t>(nodes_.size()));
            if (added) {
                nodes_.push_back(source.nodes[i]);
                cells_of_node_.emplace_back();
            }
            cell.nodes[i] = at->second;
            cells_of_node_[at->second].push_back(c);
        }
        cells_.push_back(cell);
    }
}

void StressRecovery::sample(const Material& material, const StrainedState& state)
{
    const auto best = sampling_points(space_.elements, false), within = sampling_points(space_.elements, true);
    CellValues at_best(space_, best), at_within(space_, within);
    std::vector<PetscInt> dofs;
    const auto take = [&](const CellValues& v, std::vector<Sample>& target) {
        for (const auto q : v.quadrature_point_indices()) {
            const auto stress = stress_at(v, q, dofs, material, part_, state);
            target.push_back({vector(v.quadrature_point(q)), Eigen::Map<const Six>(stress.data())});
        }
    };
    const auto first = space_.machine.parts[static_cast<std::size_t>(part_)].first_cell;
    std::vector<Sample> inner;
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
        auto& data = cells_[c];
        data.quadratic = space_.element(first + c).degree() > 1;
        space_.unknowns_of(first + c, dofs);
        data.first = samples_.size();
        at_best.reinit(first + c);
        take(at_best, samples_);
        data.count = samples_.size() - data.first;
        inner.clear();
        at_within.reinit(first + c);
        take(at_within, inner);
        find_slope(data, inner);
    }
}

// Least squares over points within the cell; also computes the cell's extent.
void StressRecovery::find_slope(CellData& cell, std::span<const Sample> points) const
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Six mean = Six::Zero();
    const double share = 1.0 / static_cast<double>(points.size());
    for (const auto& point : points) {
        middle += share * point.position;
        mean += share * point.stress;
    }
    Slope product = Slope::Zero();
    for (const auto& point : points) {
        const Eigen::Vector3d arm = point.position - middle;
        cell.spread += share * arm * arm.transpose();
        product += share * (point.stress - mean) * arm.transpose();
    }
    cell.slope = product * cell.spread.inverse();
}

std::vector<std::uint32_t> StressRecovery::with_neighbours(const std::vector<std::uint32_t>& patch) const
{
    std::vector<std::uint32_t> wider;
    for (const auto c : patch)
        for (unsigned i = 0; i < cells_[c].node_count; ++i) {
            const auto& around = cells_of_node_[cells_[c].nodes[i]];
            wider.insert(wider.end(), around.begin(), around.end());
        }
    std::ranges::sort(wider);
    wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
    return wider;
}

StressRecovery::Spread StressRecovery::spread_of(const std::vector<std::uint32_t>& patch) const
{
    Spread result;
    std::size_t count = 0;
    for (const auto c : patch)
        for (std::size_t k = 0; k < cells_[c].count; ++k, ++count) {
            result.centre += samples_[cells_[c].first + k].position;
            result.mean += samples_[cells_[c].first + k].stress;
        }
    result.centre /= static_cast<double>(count);
    result.mean /= static_cast<double>(count);
    Moment between = Moment::Zero();
    for (const auto c : patch) {
        result.within += cells_[c].spread;
        for (std::size_t k = 0; k < cells_[c].count; ++k) {
            const Eigen::Vector3d arm = samples_[cells_[c].first + k].position - result.centre;
            between += arm * arm.transpose() / static_cast<double>(cells_[c].count);
        }
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Moment> solver(between, result.within);
    result.ratio = solver.eigenvalues();
    result.direction = solver.eigenvectors();
    const double least = cells_[patch[0]].quadratic ? least_spread_within : least_spread;
    for (int k = 0; k < 3; ++k)
        result.told_apart[k] = result.ratio[k] > least;
    return result;
}

StressRecovery::Six StressRecovery::fit_linear(const std::vector<std::uint32_t>& patch, const Spread& spread,
                                               const Eigen::Vector3d& where) const
{
    Slope inner = Slope::Zero(), product = Slope::Zero();
    for (const auto c : patch) {
        inner += cells_[c].slope / static_cast<double>(patch.size());
        for (std::size_t k = 0; k < cells_[c].count; ++k) {
            const auto& point = samples_[cells_[c].first + k];
            product += (point.stress - spread.mean) * (point.position - spread.centre).transpose() /
                       static_cast<double>(cells_[c].count);
        }
    }
    Slope slope = Slope::Zero();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = spread.direction.col(k);
        const bool from_cells = cells_[patch[0]].quadratic || spread.told_apart[k];
        const Six along = from_cells ? Six(product * e / spread.ratio[k]) : Six(inner * spread.within * e);
        slope += along * e.transpose();
    }
    return spread.mean + slope * (where - spread.centre);
}

// Uses squares only in directions in which several cells determine them.
bool StressRecovery::fit_quadratic(const std::vector<std::uint32_t>& patch, const Spread& spread,
                                   const Eigen::Vector3d& where, Six& value) const
{
    std::vector<int> squares;
    for (int k = 0; k < 3; ++k)
        if (spread.told_apart[k])
            squares.push_back(k);
    const auto terms = static_cast<Eigen::Index>(7 + squares.size());
    Eigen::Index count = 0;
    for (const auto c : patch)
        count += static_cast<Eigen::Index>(cells_[c].count);
    if (count < 2 * terms)
        return false;
    Eigen::MatrixXd basis(count, terms);
    Eigen::Matrix<double, Eigen::Dynamic, 6> data(count, 6);
    Eigen::Index row = 0;
    for (const auto c : patch)
        for (std::size_t k = 0; k < cells_[c].count; ++k, ++row) {
            const auto& point = samples_[cells_[c].first + k];
            const Eigen::Vector3d s = spread.direction.transpose() * (point.position - where);
            basis.row(row).head<7>() << 1, s[0], s[1], s[2], s[0] * s[1], s[1] * s[2], s[2] * s[0];
            for (std::size_t i = 0; i < squares.size(); ++i)
                basis(row, static_cast<Eigen::Index>(7 + i)) = s[squares[i]] * s[squares[i]];
            data.row(row) = point.stress.transpose();
        }
    const Eigen::VectorXd scale = basis.colwise().norm();
    basis = basis * scale.cwiseInverse().asDiagonal();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-4);
    solver.compute(basis);
    if (solver.rank() < terms)
        return false;
    value = solver.solve(data).row(0).transpose() / scale[0];
    return true;
}

Tensor6 StressRecovery::recover(std::size_t node, const Vec3& where) const
{
    auto patch = cells_of_node_[node];
    auto spread = spread_of(patch);
    const bool enough = cells_[patch[0]].node_count == 8 || patch.size() >= least_tetrahedra;
    if (!enough || !spread.told_apart.all()) {
        patch = with_neighbours(patch);
        spread = spread_of(patch);
    }
    Six value;
    if (!cells_[patch[0]].quadratic || !fit_quadratic(patch, spread, vector(where), value))
        value = fit_linear(patch, spread, vector(where));
    Tensor6 result{};
    std::copy(value.data(), value.data() + 6, result.begin());
    return result;
}

Tensor6 StressRecovery::at_node(std::size_t node) const { return recover(node, space_.machine.nodes[nodes_[node]]); }

Tensor6 StressRecovery::at(const Vec3& position) const
{
    double least = std::numeric_limits<double>::max();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (const double distance = norm(space_.machine.nodes[nodes_[i]] - position); distance < least) {
            least = distance;
            nearest = i;
        }
    return recover(nearest, position);
}

}  // namespace deadpoint::fem
