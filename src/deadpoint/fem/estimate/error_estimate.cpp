#include "deadpoint/fem/estimate/error_estimate.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/elastic/elastic_law.hpp"
#include "deadpoint/fem/space/cell_values.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace deadpoint::fem {
namespace {

using Gradient = Vec3;

// One scalar of a field on all ranks: entry `offset` of `stride` per unknown.
struct Nodal {
    const std::vector<double>* values = nullptr;
    std::size_t stride = 1;
    std::size_t offset = 0;
    [[nodiscard]] double at(PetscInt unknown) const
    {
        return (*values)[stride * static_cast<std::size_t>(unknown) + offset];
    }
};

constexpr std::size_t largest_basis = 10;
using Basis = std::array<double, largest_basis>;

// Monomials up to the order: 1, x, y, z, then xx, yy, zz, xy, yz, zx.
Basis monomials(const Gradient& x)
{
    return {1, x[0], x[1], x[2], x[0] * x[0], x[1] * x[1], x[2] * x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0]};
}

// Slopes that the samples do not determine, as across a single layer of cells, become zero.
constexpr double linear_ridge = 1e-8;
constexpr double quadratic_ridge = 1e-5;

// A quadrature rule for each kind of element, with degree + `more` points per direction.
std::vector<Quadrature> rules_of(const std::vector<ReferenceElement>& elements, unsigned more)
{
    std::vector<Quadrature> rules;
    for (const auto& element : elements)
        rules.push_back(gauss_on(element, static_cast<unsigned>(element.degree()) + more));
    return rules;
}

// The recovered gradients of one part.
class PartRecovery {
public:
    PartRecovery(const Discretisation& space, std::size_t part, const std::vector<char>& exterior,
                 const std::vector<Nodal>& fields)
        : space_(space), part_(space.machine.parts[part]), exterior_(exterior), fields_(fields),
          basis_size_(space.orders[part] == 1 ? 4 : largest_basis)
    {
        sample();
    }

    // Calls visit(cell, weight [m3], recovered minus own gradient per field) at the integration points of this rank's
    // cells.
    template <class Visitor>
    void for_each_defect(const Visitor& visit)
    {
        const auto rules = rules_of(space_.elements, 2);
        CellValues v(space_, rules);
        std::vector<Gradient> defects(fields_.size());
        for (std::uint32_t c = part_.first_cell; c < part_.first_cell + part_.cell_count; ++c) {
            if (!space_.owns_cell(c))
                continue;
            const auto& cell = space_.machine.cells[c];
            v.reinit(c);
            const auto& corners = space_.elements[space_.maps.element_index(c) % 2];  // of first degree
            for (const auto q : v.quadrature_point_indices()) {
                own_gradients(v, c, q, defects);
                for (auto& defect : defects)
                    defect = -1 * defect;
                for (unsigned i = 0; i < corner_count(cell); ++i)
                    add_recovered(node_at(cell, i), v.quadrature_point(q), corners.value(i, v.unit_point(q)), defects);
                visit(v.JxW(q), defects);
            }
        }
    }

    // Sums weight * recovered gradient of the first field * distance over the vertices of a cell; returns half the sum.
    double interpolation_error(const Vec3& position, const PointShape& shape)
    {
        const auto& cell = cell_of(shape);
        double error = 0;
        std::vector<Gradient> gradient(1);
        for (unsigned i = 0; i < corner_count(cell); ++i) {
            const Vec3& corner = space_.machine.nodes[node_at(cell, i)];
            gradient[0] = {};
            add_recovered(node_at(cell, i), corner, 1, gradient);
            error += 0.5 * shape.value[i] * dot(gradient[0], position - corner);
        }
        return error;
    }

private:
    struct Patch {
        Vec3 centre{};
        double size = 0;
        std::vector<std::array<Gradient, largest_basis>> coefficients;  ///< per field
    };

    void own_gradients(const CellValues& v, std::uint32_t cell, unsigned q, std::vector<Gradient>& gradients)
    {
        space_.unknowns_of(cell, unknowns_);
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            gradients[f] = {};
            for (const auto i : v.dof_indices())
                gradients[f] = gradients[f] + fields_[f].at(unknowns_[i]) * v.shape_grad(i, q);
        }
    }

    // The cell with these unknowns.
    [[nodiscard]] const Cell& cell_of(const PointShape& shape)
    {
        for (std::uint32_t c = part_.first_cell; c < part_.first_cell + part_.cell_count; ++c) {
            space_.unknowns_of(c, unknowns_);
            if (std::equal(unknowns_.begin(), unknowns_.end(), shape.dof.begin(), shape.dof.begin() + shape.count))
                return space_.machine.cells[c];
        }
        throw std::logic_error("no cell of the part has the unknowns of a probe");
    }

    // Collects the gradients at the superconvergent points of all cells, and the cells around each vertex.
    void sample()
    {
        const auto rules = rules_of(space_.elements, 0);
        CellValues v(space_, rules);
        std::vector<Gradient> gradients(fields_.size());
        first_sample_.push_back(0);
        for (std::uint32_t c = 0; c < part_.cell_count; ++c) {
            const auto& cell = space_.machine.cells[part_.first_cell + c];
            for (unsigned i = 0; i < corner_count(cell); ++i)
                cells_at_[cell.nodes[i]].push_back(c);
            v.reinit(part_.first_cell + c);
            for (const auto q : v.quadrature_point_indices()) {
                own_gradients(v, part_.first_cell + c, q, gradients);
                positions_.push_back(v.quadrature_point(q));
                samples_.insert(samples_.end(), gradients.begin(), gradients.end());
            }
            first_sample_.push_back(positions_.size());
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> cells_around(unsigned vertex) const
    {
        const auto& near = cells_at_.at(vertex);
        if (exterior_[vertex] == 0)
            return near;
        std::set<std::uint32_t> cells;
        for (const auto c : near) {
            const auto& cell = space_.machine.cells[part_.first_cell + c];
            for (unsigned i = 0; i < corner_count(cell); ++i)
                cells.insert(cells_at_.at(cell.nodes[i]).begin(), cells_at_.at(cell.nodes[i]).end());
        }
        return {cells.begin(), cells.end()};
    }

    // Fits the samples of the cells around a vertex by least squares.
    [[nodiscard]] Patch fit(unsigned vertex) const
    {
        Patch patch;
        patch.centre = space_.machine.nodes[vertex];
        const auto cells = cells_around(vertex);
        std::size_t count = 0;
        for (const auto c : cells)
            for (auto s = first_sample_[c]; s < first_sample_[c + 1]; ++s, ++count)
                patch.size = std::max(patch.size, norm(positions_[s] - patch.centre));
        const auto m = static_cast<unsigned>(basis_size_);
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(m, m);
        patch.coefficients.assign(fields_.size(), {});
        std::vector<std::array<Gradient, largest_basis>> right(fields_.size());
        for (const auto c : cells)
            for (auto s = first_sample_[c]; s < first_sample_[c + 1]; ++s) {
                const Basis basis = monomials((1 / patch.size) * (positions_[s] - patch.centre));
                for (unsigned i = 0; i < m; ++i) {
                    for (unsigned j = 0; j < m; ++j)
                        normal(i, j) += basis[i] * basis[j];
                    for (std::size_t f = 0; f < fields_.size(); ++f)
                        right[f][i] = right[f][i] + basis[i] * samples_[s * fields_.size() + f];
                }
            }
        for (unsigned i = 1; i < m; ++i)
            normal(i, i) += (i < 4 ? linear_ridge : quadratic_ridge) * static_cast<double>(count);
        const Eigen::MatrixXd inverse = normal.inverse();
        for (std::size_t f = 0; f < fields_.size(); ++f)
            for (unsigned i = 0; i < m; ++i)
                for (unsigned j = 0; j < m; ++j)
                    patch.coefficients[f][i] = patch.coefficients[f][i] + inverse(i, j) * right[f][j];
        return patch;
    }

    void add_recovered(unsigned vertex, const Vec3& position, double weight, std::vector<Gradient>& sums)
    {
        auto found = patches_.find(vertex);
        if (found == patches_.end())
            found = patches_.emplace(vertex, fit(vertex)).first;
        const auto& patch = found->second;
        const Basis basis = monomials((1 / patch.size) * (position - patch.centre));
        for (std::size_t f = 0; f < sums.size(); ++f)
            for (std::size_t i = 0; i < basis_size_; ++i)
                sums[f] = sums[f] + weight * basis[i] * patch.coefficients[f][i];
    }

    const Discretisation& space_;
    const MeshPart& part_;
    const std::vector<char>& exterior_;  ///< per vertex of the machine
    const std::vector<Nodal>& fields_;
    std::size_t basis_size_;
    std::map<unsigned, std::vector<std::uint32_t>> cells_at_;
    std::map<unsigned, Patch> patches_;
    std::vector<std::size_t> first_sample_;  ///< per cell
    std::vector<Vec3> positions_;
    std::vector<Gradient> samples_;  ///< per sample, then per field
    std::vector<PetscInt> unknowns_;
};

std::vector<char> exterior_nodes(const Machine& machine)
{
    std::vector<char> exterior(machine.nodes.size(), 0);
    for (const auto& face : machine.faces)
        for (int i = 0; i < face.node_count; ++i)
            exterior[face.nodes[i]] = 1;
    return exterior;
}

// Sums term(part, defects, dual) times volume over all cells, per dual and part, over the ranks.
template <class Term>
std::vector<std::vector<double>> summed(const Discretisation& space, const std::vector<Nodal>& fields,
                                        std::size_t duals, const Term& term)
{
    const auto exterior = exterior_nodes(space.machine);
    const std::size_t parts = space.machine.parts.size();
    std::vector<double> sums(duals * parts, 0.0);
    for (std::size_t p = 0; p < parts; ++p)
        PartRecovery(space, p, exterior, fields)
            .for_each_defect([&](double volume, const std::vector<Gradient>& defects) {
                for (std::size_t k = 0; k < duals; ++k)
                    sums[k * parts + p] += volume * term(p, defects, k);
            });
    sum_over_ranks(sums);
    std::vector<std::vector<double>> result(duals);
    for (std::size_t k = 0; k < duals; ++k)
        result[k].assign(sums.begin() + static_cast<std::ptrdiff_t>(k * parts),
                         sums.begin() + static_cast<std::ptrdiff_t>((k + 1) * parts));
    return result;
}

// xx, yy, zz, then xy, yz, zx.
Tensor6 strain(const std::vector<Gradient>& gradients, std::size_t first)
{
    Tensor6 result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        result[i] = gradients[first + i][i];
        result[3 + i] = 0.5 * (gradients[first + i][j] + gradients[first + j][i]);
    }
    return result;
}

double contraction(const Tensor6& a, const Tensor6& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += a[i] * b[i] + 2 * a[3 + i] * b[3 + i];
    return sum;
}

}  // namespace

std::vector<std::vector<double>> conduction_errors(const Discretisation& space, const std::vector<Material>& materials,
                                                   const Field& temperature, const std::vector<Field>& duals)
{
    std::vector<std::vector<double>> values{gather_all(space, temperature.owned, 1)};
    for (const auto& dual : duals)
        values.push_back(gather_all(space, dual.owned, 1));
    std::vector<Nodal> fields;
    for (const auto& field : values)
        fields.push_back({&field});
    return summed(space, fields, duals.size(),
                  [&](std::size_t part, const std::vector<Gradient>& defects, std::size_t dual) {
                      return materials[part].conductivity * dot(defects[0], defects[1 + dual]);
                  });
}

std::vector<std::vector<double>> deformation_errors(const Discretisation& space, const std::vector<Material>& materials,
                                                    const Displacement& displacement,
                                                    const std::vector<Displacement>& duals)
{
    std::vector<std::vector<double>> values{gather_all(space, displacement.owned, 3)};
    for (const auto& dual : duals)
        values.push_back(gather_all(space, dual.owned, 3));
    std::vector<Nodal> fields;
    for (const auto& field : values)
        for (std::size_t c = 0; c < 3; ++c)
            fields.push_back({&field, 3, c});
    return summed(space, fields, duals.size(),
                  [&](std::size_t part, const std::vector<Gradient>& defects, std::size_t dual) {
                      return contraction(hooke(materials[part], strain(defects, 0)), strain(defects, 3 + 3 * dual));
                  });
}

std::vector<double> interpolation_errors(const Discretisation& space, const Field& temperature,
                                         const std::vector<HeatProbe>& probes)
{
    std::vector<double> errors(probes.size(), 0.0);
    const auto exterior = exterior_nodes(space.machine);
    const auto values = gather_all(space, temperature.owned, 1);
    const std::vector<Nodal> fields{{&values}};
    std::map<int, PartRecovery> recoveries;
    PointShape shape;
    for (std::size_t k = 0; k < probes.size(); ++k) {
        if (space.orders[static_cast<std::size_t>(probes[k].part)] > 1)
            continue;
        space.evaluate_in_part(probes[k].part, probes[k].position, shape);
        auto found = recoveries.find(probes[k].part);
        if (found == recoveries.end())
            found = recoveries
                        .try_emplace(probes[k].part, space, static_cast<std::size_t>(probes[k].part), exterior, fields)
                        .first;
        errors[k] = found->second.interpolation_error(probes[k].position, shape);
    }
    return errors;
}

}  // namespace deadpoint::fem
