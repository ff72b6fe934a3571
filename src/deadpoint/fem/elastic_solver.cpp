#include "deadpoint/fem/elastic_solver.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <set>

namespace deadpoint::fem {
namespace {

constexpr double relative_tolerance = 1e-11;
constexpr double bond_penalty = 20;

struct Lame {
    double lambda, mu;
};
Lame lame(const Material& m)
{
    return {m.youngs_modulus * m.poissons_ratio / ((1 + m.poissons_ratio) * (1 - 2 * m.poissons_ratio)),
            m.youngs_modulus / (2 * (1 + m.poissons_ratio))};
}

}  // namespace

ElasticSolver::ElasticSolver(const Discretisation& space, const std::vector<Material>& materials, int feet_surface)
    : space_(space), materials_(materials)
{
    auto pattern = space_.cell_pattern();
    space_.add_bond_pattern(pattern);
    matrix_ = create_matrix(space_, pattern, 3);
    solution_ = create_vector(space_, 3);
    rhs_ = create_vector(space_, 3);
    last_ = create_vector(space_, 3);
    auto held = supported(feet_surface);
    pieces_ = std::make_unique<RigidPieces>(space_, held);
    held.insert(held.end(), pieces_->holds().begin(), pieces_->holds().end());
    for (const PetscInt unknown : held)
        if (space_.owns(unknown / 3))
            fixed_.push_back(unknown);
    assemble();
    assemble_bonds();
    DEADPOINT_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    PetscScalar trace = 0;
    DEADPOINT_PETSC(MatGetTrace(matrix_, &trace));
    DEADPOINT_PETSC(MatZeroRowsColumns(matrix_, static_cast<PetscInt>(fixed_.size()), fixed_.data(),
                                       trace / (3.0 * space_.total), nullptr, nullptr));
    set_near_null_space();

    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, relative_tolerance, 1e-300, 1e12, 1000));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    DEADPOINT_PETSC(PCSetType(preconditioner, PCGAMG));
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "deformation_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
}

std::vector<PetscInt> ElasticSolver::supported(int feet_surface) const
{
    std::set<PetscInt> held;
    PointShape shape;
    const auto hold = [&](std::uint32_t face, int component) {
        for (const auto& point : face_points(space_.machine, space_.machine.faces[face])) {
            space_.evaluate(face, point.position, false, shape);
            for (int i = 0; i < shape.count; ++i)
                if (std::abs(shape.value[i]) > 1e-9)
                    held.insert(3 * shape.dof[i] + component);
        }
    };
    for (std::uint32_t f = 0; f < space_.machine.faces.size(); ++f)
        if (space_.machine.faces[f].symmetry)
            hold(f, 0);
    if (feet_surface >= 0)
        for (const auto& foot : space_.machine.surfaces[feet_surface].faces)
            hold(foot.face, 1);
    return {held.begin(), held.end()};
}

void ElasticSolver::clear_fixed(Vec vector) const
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(vector, &values));
    for (const PetscInt row : fixed_)
        values[row - 3 * space_.first] = 0;
    DEADPOINT_PETSC(VecRestoreArray(vector, &values));
}

void ElasticSolver::assemble()
{
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices;
    std::vector<PetscInt> nodes;
    std::vector<double> block;
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        if (!cell->is_locally_owned())
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        const unsigned n = v.dofs_per_cell;
        indices.resize(n);
        cell->get_dof_indices(indices);
        nodes.assign(indices.begin(), indices.end());
        block.assign(9 * n * n, 0.0);
        const auto& material = materials_[cell->material_id()];
        const auto [lambda, mu] = lame(material);
        for (const auto q : v.quadrature_point_indices())
            for (unsigned i = 0; i < n; ++i) {
                const auto& gi = v.shape_grad(i, q);
                for (unsigned j = 0; j < n; ++j) {
                    const auto& gj = v.shape_grad(j, q);
                    const double w = v.JxW(q);
                    const double diagonal = w * mu * (gi * gj);
                    for (unsigned c = 0; c < 3; ++c) {
                        double* row = &block[(3 * i + c) * 3 * n + 3 * j];
                        row[c] += diagonal;
                        for (unsigned d = 0; d < 3; ++d)
                            row[d] += w * (lambda * gi[c] * gj[d] + mu * gi[d] * gj[c]);
                    }
                }
            }
        const auto count = static_cast<PetscInt>(n);
        DEADPOINT_PETSC(
            MatSetValuesBlocked(matrix_, count, nodes.data(), count, nodes.data(), block.data(), ADD_VALUES));
    }
}

// Nitsche for the traction, weighted as for heat, with the stiffness lambda + 2 mu over the cell's depth.
void ElasticSolver::assemble_bonds()
{
    std::array<PetscInt, 2 * max_cell_dofs> node{};
    std::array<double, 2 * max_cell_dofs> jump{};
    std::vector<double> traction, block;
    for_each_bond_pair(space_, [&](const BondPair& pair) {
        const auto a = lame(materials_[pair.part_a]), b = lame(materials_[pair.part_b]);
        const double stiff_a = (a.lambda + 2 * a.mu) / pair.depth_a, stiff_b = (b.lambda + 2 * b.mu) / pair.depth_b;
        const double weight_a = stiff_b / (stiff_a + stiff_b), weight_b = stiff_a / (stiff_a + stiff_b);
        const double penalty = bond_penalty * space_.order * space_.order * stiff_a * stiff_b / (stiff_a + stiff_b);
        const int n = pair.points.front().a.count + pair.points.front().b.count;
        traction.resize(static_cast<std::size_t>(9 * n));
        block.assign(static_cast<std::size_t>(9 * n * n), 0.0);
        for (const auto& p : pair.points) {
            for (int i = 0; i < n; ++i) {
                const bool on_a = i < p.a.count;
                const auto& shape = on_a ? p.a : p.b;
                const int k = on_a ? i : i - p.a.count;
                node[i] = shape.dof[k];
                jump[i] = on_a ? shape.value[k] : -shape.value[k];
                const auto& g = shape.gradient[k];
                const auto& m = on_a ? a : b;
                const double weight = on_a ? weight_a : weight_b;
                const double slope = dot(g, p.normal);
                // traction[3 i + c][d]: component d of sigma n for a unit displacement c of node i
                for (int c = 0; c < 3; ++c)
                    for (int d = 0; d < 3; ++d)
                        traction[static_cast<std::size_t>((3 * i + c) * 3 + d)] =
                            weight *
                            (m.lambda * g[c] * p.normal[d] + m.mu * g[d] * p.normal[c] + (c == d ? m.mu * slope : 0.0));
            }
            for (int i = 0; i < n; ++i)
                for (int c = 0; c < 3; ++c)
                    for (int j = 0; j < n; ++j) {
                        double* entry = &block[static_cast<std::size_t>((3 * i + c) * 3 * n + 3 * j)];
                        for (int d = 0; d < 3; ++d)
                            entry[d] -= p.weight * (jump[i] * traction[static_cast<std::size_t>((3 * j + d) * 3 + c)] +
                                                    jump[j] * traction[static_cast<std::size_t>((3 * i + c) * 3 + d)]);
                        entry[c] += p.weight * penalty * jump[i] * jump[j];
                    }
        }
        DEADPOINT_PETSC(MatSetValuesBlocked(matrix_, n, node.data(), n, node.data(), block.data(), ADD_VALUES));
    });
}

void ElasticSolver::set_near_null_space()
{
    OwnedVec coordinates = create_vector(space_, 3);
    const auto points = space_.support_points();
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(coordinates, &values));
    for (std::size_t i = 0; i < points.size(); ++i)
        std::copy(points[i].begin(), points[i].end(), values + 3 * i);
    DEADPOINT_PETSC(VecRestoreArray(coordinates, &values));
    OwnedNullSpace rigid;
    DEADPOINT_PETSC(MatNullSpaceCreateRigidBody(coordinates, rigid.out()));
    DEADPOINT_PETSC(MatSetNearNullSpace(matrix_, rigid));
}

double ElasticSolver::thermal_modulus(int part) const
{
    const auto& m = materials_[part];
    return m.youngs_modulus * m.expansion / (1 - 2 * m.poissons_ratio);
}

void ElasticSolver::load(const Functional& functional, Vec target) const
{
    std::vector<std::pair<PetscInt, double>> entries;
    PointShape shape;
    DEADPOINT_PETSC(VecSet(target, 0));
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(target, &values));
    for (const auto& point : functional.points) {
        space_.evaluate(point.face, point.position, false, shape);
        for (int i = 0; i < shape.count; ++i)
            if (space_.owns(shape.dof[i]))
                for (int c = 0; c < 3; ++c)
                    values[3 * (shape.dof[i] - space_.first) + c] += shape.value[i] * point.weight[c];
    }
    DEADPOINT_PETSC(VecRestoreArray(target, &values));
}

// The work of the thermal stress  m dT I  in a virtual displacement u:
//   integral m dT div u  -  over bonds: integral (weighted m dT) n . (u_a - u_b).
// Both visitors get (node, its shape value, its gradient or n times jump) and the factor.
template <class CellVisitor, class BondVisitor>
void ElasticSolver::for_each_thermal_term(const CellVisitor& cell_visitor, const BondVisitor& bond_visitor) const
{
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices;
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        if (!cell->is_locally_owned())
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        indices.resize(v.dofs_per_cell);
        cell->get_dof_indices(indices);
        cell_visitor(v, indices, thermal_modulus(static_cast<int>(cell->material_id())));
    }
    for_each_bond_pair(space_, [&](const BondPair& pair) {
        const auto a = lame(materials_[pair.part_a]), b = lame(materials_[pair.part_b]);
        const double stiff_a = (a.lambda + 2 * a.mu) / pair.depth_a, stiff_b = (b.lambda + 2 * b.mu) / pair.depth_b;
        const double modulus_a = stiff_b / (stiff_a + stiff_b) * thermal_modulus(pair.part_a);
        const double modulus_b = stiff_a / (stiff_a + stiff_b) * thermal_modulus(pair.part_b);
        for (const auto& p : pair.points)
            bond_visitor(p, modulus_a, modulus_b);
    });
}

std::vector<Adjoint> ElasticSolver::adjoints(const std::vector<Functional>& functionals)
{
    std::vector<Adjoint> result;
    Everywhere gathered(solution_);
    OwnedVec weights = create_vector(space_, 1);
    for (const auto& functional : functionals) {
        load(functional, rhs_);
        pieces_->equilibrate(rhs_);
        clear_fixed(rhs_);
        DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
        DEADPOINT_PETSC(VecSet(solution_, 0));
        PetscReal size = 0;
        DEADPOINT_PETSC(VecNorm(rhs_, NORM_INFINITY, &size));
        if (size > 0)
            iterations_ += solve(solver_, rhs_, solution_, "the deformation's adjoint");
        const double* u = gathered.gather(solution_);

        DEADPOINT_PETSC(VecSet(weights, 0));
        std::vector<double> cell_weights;
        for_each_thermal_term(
            [&](const dealii::FEValues<3>& v, const auto& dofs, double modulus) {
                cell_weights.assign(dofs.size(), 0.0);
                for (const auto q : v.quadrature_point_indices()) {
                    double divergence = 0;
                    for (unsigned i = 0; i < dofs.size(); ++i)
                        for (unsigned c = 0; c < 3; ++c)
                            divergence += v.shape_grad(i, q)[c] * u[3 * dofs[i] + c];
                    for (unsigned i = 0; i < dofs.size(); ++i)
                        cell_weights[i] += modulus * v.JxW(q) * divergence * v.shape_value(i, q);
                }
                for (unsigned i = 0; i < dofs.size(); ++i)
                    DEADPOINT_PETSC(VecSetValue(weights, static_cast<PetscInt>(dofs[i]), cell_weights[i], ADD_VALUES));
            },
            [&](const BondPoint& p, double modulus_a, double modulus_b) {
                double opening = 0;
                for (const auto* side : {&p.a, &p.b})
                    for (int i = 0; i < side->count; ++i)
                        for (int c = 0; c < 3; ++c)
                            opening += (side == &p.a ? 1 : -1) * side->value[i] * p.normal[c] * u[3 * side->dof[i] + c];
                for (const auto* side : {&p.a, &p.b})
                    for (int i = 0; i < side->count; ++i)
                        DEADPOINT_PETSC(VecSetValue(
                            weights, side->dof[i],
                            -p.weight * (side == &p.a ? modulus_a : modulus_b) * opening * side->value[i], ADD_VALUES));
            });
        DEADPOINT_PETSC(VecAssemblyBegin(weights));
        DEADPOINT_PETSC(VecAssemblyEnd(weights));
        const double* owned = nullptr;
        DEADPOINT_PETSC(VecGetArrayRead(weights, &owned));
        result.push_back({functional.name, {owned, owned + (space_.last - space_.first)}});
        DEADPOINT_PETSC(VecRestoreArrayRead(weights, &owned));
    }
    return result;
}

Displacement ElasticSolver::displacement(const Field& temperature, double reference_temperature)
{
    OwnedVec field = create_vector(space_, 1);
    double* target = nullptr;
    DEADPOINT_PETSC(VecGetArray(field, &target));
    for (std::size_t i = 0; i < temperature.owned.size(); ++i)
        target[i] = temperature.owned[i] - reference_temperature;
    DEADPOINT_PETSC(VecRestoreArray(field, &target));
    Everywhere gathered(field);
    const double* rise = gathered.gather(field);

    DEADPOINT_PETSC(VecSet(rhs_, 0));
    const auto add = [&](auto node, unsigned c, double value) {
        DEADPOINT_PETSC(VecSetValue(rhs_, static_cast<PetscInt>(3 * node + c), value, ADD_VALUES));
    };
    std::vector<double> cell_load;
    for_each_thermal_term(
        [&](const dealii::FEValues<3>& v, const auto& dofs, double modulus) {
            cell_load.assign(3 * dofs.size(), 0.0);
            for (const auto q : v.quadrature_point_indices()) {
                double at = 0;
                for (unsigned i = 0; i < dofs.size(); ++i)
                    at += v.shape_value(i, q) * rise[dofs[i]];
                for (unsigned i = 0; i < dofs.size(); ++i)
                    for (unsigned c = 0; c < 3; ++c)
                        cell_load[3 * i + c] += modulus * at * v.JxW(q) * v.shape_grad(i, q)[c];
            }
            for (unsigned i = 0; i < dofs.size(); ++i)
                for (unsigned c = 0; c < 3; ++c)
                    add(dofs[i], c, cell_load[3 * i + c]);
        },
        [&](const BondPoint& p, double modulus_a, double modulus_b) {
            double stress = 0;
            for (int i = 0; i < p.a.count; ++i)
                stress += modulus_a * p.a.value[i] * rise[p.a.dof[i]];
            for (int i = 0; i < p.b.count; ++i)
                stress += modulus_b * p.b.value[i] * rise[p.b.dof[i]];
            for (const auto* side : {&p.a, &p.b})
                for (int i = 0; i < side->count; ++i)
                    for (unsigned c = 0; c < 3; ++c)
                        add(side->dof[i], c,
                            (side == &p.a ? -1 : 1) * p.weight * stress * side->value[i] * p.normal[c]);
        });
    DEADPOINT_PETSC(VecAssemblyBegin(rhs_));
    DEADPOINT_PETSC(VecAssemblyEnd(rhs_));
    clear_fixed(rhs_);

    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
    DEADPOINT_PETSC(VecCopy(last_, solution_));
    PetscReal size = 0;
    DEADPOINT_PETSC(VecNorm(rhs_, NORM_INFINITY, &size));
    if (size > 0)
        iterations_ += solve(solver_, rhs_, solution_, "the thermal deformation");
    else
        DEADPOINT_PETSC(VecSet(solution_, 0));
    DEADPOINT_PETSC(VecCopy(solution_, last_));
    pieces_->remove_rigid_motion(solution_);
    Displacement result;
    const double* owned = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(solution_, &owned));
    result.owned.assign(owned, owned + 3 * (space_.last - space_.first));
    DEADPOINT_PETSC(VecRestoreArrayRead(solution_, &owned));
    return result;
}

std::vector<double> ElasticSolver::evaluate(const std::vector<Functional>& functionals,
                                            const Displacement& displacement)
{
    std::vector<double> sums(functionals.size(), 0.0);
    PointShape shape;
    for (std::size_t k = 0; k < functionals.size(); ++k)
        for (const auto& point : functionals[k].points) {
            space_.evaluate(point.face, point.position, false, shape);
            for (int i = 0; i < shape.count; ++i)
                if (space_.owns(shape.dof[i]))
                    for (int c = 0; c < 3; ++c)
                        sums[k] += shape.value[i] * point.weight[c] *
                                   displacement.owned[static_cast<std::size_t>(3 * (shape.dof[i] - space_.first) + c)];
        }
    sum_over_ranks(sums);
    return sums;
}

}  // namespace deadpoint::fem
