#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/elastic/elastic_cells.hpp"
#include "deadpoint/fem/elastic/elastic_law.hpp"
#include "deadpoint/fem/elastic/elastic_solver.hpp"
#include "deadpoint/fem/elastic/rigid_pieces.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace deadpoint::fem {

void cell_stiffness(const CellValues& v, const Material& material, std::vector<double>& block)
{
    const auto [lambda, mu] = lame(material);
    const unsigned n = v.dofs_per_cell();
    block.assign(9 * n * n, 0.0);
    for (const auto q : v.quadrature_point_indices())
        for (unsigned i = 0; i < n; ++i) {
            const auto& gi = v.shape_grad(i, q);
            for (unsigned j = 0; j < n; ++j) {
                const auto& gj = v.shape_grad(j, q);
                const double w = v.JxW(q);
                const double diagonal = w * mu * dot(gi, gj);
                for (unsigned c = 0; c < 3; ++c) {
                    double* row = &block[(3 * i + c) * 3 * n + 3 * j];
                    row[c] += diagonal;
                    for (unsigned d = 0; d < 3; ++d)
                        row[d] += w * (lambda * gi[c] * gj[d] + mu * gi[d] * gj[c]);
                }
            }
        }
}

void add_to_cell(Vec target, const std::vector<PetscInt>& unknowns, const std::vector<double>& values)
{
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            DEADPOINT_PETSC(
                VecSetValue(target, 3 * unknowns[i] + static_cast<PetscInt>(c), values[3 * i + c], ADD_VALUES));
}

void finish(Vec target)
{
    DEADPOINT_PETSC(VecAssemblyBegin(target));
    DEADPOINT_PETSC(VecAssemblyEnd(target));
}

double ElasticSolver::thermal_modulus(int part) const
{
    const auto& m = materials_[part];
    return m.youngs_modulus * expansion_scale(m) / (1 - 2 * m.poissons_ratio);
}

// Pads: integral of k N_i N_j over the feet, separately for each direction (Winkler).
void ElasticSolver::for_each_pad(
    const std::function<void(const PointShape& shape, const std::vector<double>& stiffness)>& visit) const
{
    if (foundation_.surface < 0 || foundation_.kind != Foundation::Kind::elastic)
        return;
    PointShape shape;
    std::vector<double> block;
    std::array<double, 3> stiffness{};
    for (std::size_t c = 0; c < 3; ++c)
        stiffness[c] = foot_normal_[c] != 0 ? foundation_.vertical : foundation_.horizontal;
    for (const auto& foot : space_.machine.surfaces[foundation_.surface].faces) {
        const auto& face = space_.machine.faces[foot.face];
        if (!space_.owns_cell(face.cell))
            continue;
        for (const auto& point : face_points(space_.machine, face)) {
            space_.evaluate(foot.face, point.position, false, shape);
            const auto n = static_cast<std::size_t>(shape.count);
            block.assign(9 * n * n, 0.0);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    for (std::size_t c = 0; c < 3; ++c)
                        block[(3 * i + c) * 3 * n + 3 * j + c] =
                            stiffness[c] * foot.fraction * point.weight * shape.value[i] * shape.value[j];
            visit(shape, block);
        }
    }
}

void ElasticSolver::load_thermal(const Field& given, Vec target) const
{
    OwnedVec field = create_vector(space_, 1);
    double* entries = nullptr;
    DEADPOINT_PETSC(VecGetArray(field, &entries));
    std::ranges::copy(given.owned, entries);
    DEADPOINT_PETSC(VecRestoreArray(field, &entries));
    Gathered gathered(field);
    const double* rise = gathered.gather(field);
    std::vector<double> cell_load;
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        const double modulus = thermal_modulus(part);
        cell_load.assign(3 * dofs.size(), 0.0);
        for (const auto q : v.quadrature_point_indices()) {
            double at = 0;
            for (unsigned i = 0; i < dofs.size(); ++i)
                at += v.shape_value(i, q) * rise[dofs[i]];
            for (unsigned i = 0; i < dofs.size(); ++i)
                for (unsigned c = 0; c < 3; ++c)
                    cell_load[3 * i + c] += modulus * at * v.JxW(q) * v.shape_grad(i, q)[c];
        }
        add_to_cell(target, dofs, cell_load);
    });
    finish(target);
}

void ElasticSolver::load_initial_strain(const std::vector<Tensor6>& strain, Vec target) const
{
    if (strain.empty())
        return;
    std::vector<double> cell_load;
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        if (strain[part] == Tensor6{})
            return;
        const auto s = hooke(materials_[part], strain[part]);
        cell_load.assign(3 * dofs.size(), 0.0);
        for (const auto q : v.quadrature_point_indices())
            for (unsigned i = 0; i < dofs.size(); ++i) {
                const Vec3 g = v.JxW(q) * v.shape_grad(i, q);
                cell_load[3 * i] += s[0] * g[0] + s[3] * g[1] + s[5] * g[2];
                cell_load[3 * i + 1] += s[3] * g[0] + s[1] * g[1] + s[4] * g[2];
                cell_load[3 * i + 2] += s[5] * g[0] + s[4] * g[1] + s[2] * g[2];
            }
        add_to_cell(target, dofs, cell_load);
    });
    finish(target);
}

// Weight of the pieces that stand on the feet. The others hang in joints, whose forces are not part of this problem.
void ElasticSolver::load_weight(const Vec3& gravity, Vec target) const
{
    std::set<int> standing;
    for (const PetscInt unknown : feet_)
        standing.insert(pieces_->piece(unknown / 3));
    std::vector<double> cell_load;
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        if (!standing.contains(pieces_->piece(dofs[0])))
            return;
        cell_load.assign(3 * dofs.size(), 0.0);
        for (const auto q : v.quadrature_point_indices())
            for (unsigned i = 0; i < dofs.size(); ++i)
                for (unsigned c = 0; c < 3; ++c)
                    cell_load[3 * i + c] += materials_[part].density * gravity[c] * v.JxW(q) * v.shape_value(i, q);
        add_to_cell(target, dofs, cell_load);
    });
    finish(target);
}

void ElasticSolver::add_adjoint(Pending& pending, const std::string& name, std::vector<double> displacement,
                                std::vector<Adjoint>& result) const
{
    constexpr std::size_t at_once = 8;
    pending.names.push_back(name);
    pending.displacements.push_back(std::move(displacement));
    if (pending.names.size() == at_once)
        finish_adjoints(pending, result);
}

void ElasticSolver::finish_adjoints(Pending& pending, std::vector<Adjoint>& result) const
{
    std::ranges::move(temperature_weights(pending), std::back_inserter(result));
    pending = {};
}

// a_i = integral of E alpha / (1 - 2 nu) div(displacement) N_i
std::vector<Adjoint> ElasticSolver::temperature_weights(const Pending& pending) const
{
    const auto& names = pending.names;
    std::vector<OwnedVec> weights;
    for (std::size_t k = 0; k < names.size(); ++k)
        weights.push_back(create_vector(space_, 1));
    std::vector<PetscInt> unknowns;
    std::vector<double> cell_weights;
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        const double modulus = thermal_modulus(part);
        unknowns.assign(dofs.begin(), dofs.end());
        for (std::size_t k = 0; k < names.size(); ++k) {
            const auto& displacement = pending.displacements[k];
            cell_weights.assign(dofs.size(), 0.0);
            for (const auto q : v.quadrature_point_indices()) {
                double divergence = 0;
                for (unsigned i = 0; i < dofs.size(); ++i)
                    for (unsigned c = 0; c < 3; ++c)
                        divergence += v.shape_grad(i, q)[c] * displacement[3 * dofs[i] + c];
                for (unsigned i = 0; i < dofs.size(); ++i)
                    cell_weights[i] += modulus * v.JxW(q) * divergence * v.shape_value(i, q);
            }
            DEADPOINT_PETSC(VecSetValues(weights[k], static_cast<PetscInt>(unknowns.size()), unknowns.data(),
                                         cell_weights.data(), ADD_VALUES));
        }
    });
    std::vector<Adjoint> result;
    for (std::size_t k = 0; k < names.size(); ++k) {
        finish(weights[k]);
        const ConstEntries owned(weights[k]);
        result.push_back({names[k], {owned.data(), owned.data() + (space_.last - space_.first)}});
    }
    return result;
}

}  // namespace deadpoint::fem
