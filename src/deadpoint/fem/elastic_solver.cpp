#include "deadpoint/fem/elastic_solver.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <set>

namespace deadpoint::fem {
namespace {

constexpr double relative_tolerance = 1e-10;
constexpr PetscInt largest_direct = 1'500'000;  // unknowns, about 8 GB

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
    : space_(space), materials_(materials), ties_(space)
{
    auto held = supported(feet_surface);
    pieces_ = std::make_unique<RigidPieces>(space_, held, ties_);
    held.insert(held.end(), pieces_->holds().begin(), pieces_->holds().end());

    assemble();
    PetscInt first_free = 0;
    DEADPOINT_PETSC(MatGetOwnershipRange(matrix_, &first_free, nullptr));
    const auto free = ties_.free_nodes(space_);
    const std::set<PetscInt> wanted(held.begin(), held.end());
    for (std::size_t i = 0; i < free.size(); ++i)
        for (PetscInt c = 0; c < 3; ++c)
            if (wanted.contains(3 * (space_.first + free[i]) + c))
                fixed_.push_back(first_free + static_cast<PetscInt>(3 * i) + c);
    PetscScalar trace = 0;
    PetscInt size = 0;
    DEADPOINT_PETSC(MatGetTrace(matrix_, &trace));
    DEADPOINT_PETSC(MatGetSize(matrix_, &size, nullptr));
    DEADPOINT_PETSC(MatZeroRowsColumns(matrix_, static_cast<PetscInt>(fixed_.size()), fixed_.data(), trace / size,
                                       nullptr, nullptr));
    choose_solver(size);
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "deformation_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));

    solution_ = create_vector(space_, 3);
    rhs_ = create_vector(space_, 3);
    DEADPOINT_PETSC(MatCreateVecs(matrix_, free_solution_.out(), free_rhs_.out()));
}

// Half the entries suffice, and on one rank the factorisation reads them in place; on several, PETSc converts entry by
// entry, which takes minutes.
void ElasticSolver::keep_upper_half()
{
    int ranks = 1;
    MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
    if (ranks > 1)
        return;
    OwnedMat upper;
    DEADPOINT_PETSC(MatConvert(matrix_, MATSBAIJ, MAT_INITIAL_MATRIX, upper.out()));
    matrix_ = std::move(upper);
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
}

// A sparse factor serves all adjoints and field times, and thin frames of many plates, which multigrid takes hundreds
// of iterations for; beyond its memory, multigrid with the rigid motions.
void ElasticSolver::choose_solver(PetscInt size)
{
    const bool direct = size <= largest_direct;
    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, relative_tolerance, 1e-300, 1e12, 2000));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    if (direct) {
        keep_upper_half();
        DEADPOINT_PETSC(PCSetType(preconditioner, PCCHOLESKY));
        DEADPOINT_PETSC(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
    } else {
        DEADPOINT_PETSC(MatSetBlockSize(matrix_, 3));
        set_near_null_space();
        DEADPOINT_PETSC(PCSetType(preconditioner, PCGAMG));
    }
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
}

// Solves for rhs_; the result stands in solution_. A previous solution in free_solution_ is the first guess.
void ElasticSolver::solve_free(const char* what)
{
    DEADPOINT_PETSC(MatMultTranspose(expansion_, rhs_, free_rhs_));
    clear_fixed(free_rhs_);
    PetscReal size = 0;
    DEADPOINT_PETSC(VecNorm(free_rhs_, NORM_INFINITY, &size));
    if (size > 0)
        iterations_ += solve(solver_, free_rhs_, free_solution_, what);
    else
        DEADPOINT_PETSC(VecSet(free_solution_, 0));
    DEADPOINT_PETSC(MatMult(expansion_, free_solution_, solution_));
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
    PetscInt first_free = 0;
    DEADPOINT_PETSC(VecGetOwnershipRange(vector, &first_free, nullptr));
    for (const PetscInt row : fixed_)
        values[row - first_free] = 0;
    DEADPOINT_PETSC(VecRestoreArray(vector, &values));
}

void ElasticSolver::assemble()
{
    OwnedMat all = create_matrix(space_, space_.cell_pattern(), 3);
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
        DEADPOINT_PETSC(MatSetValuesBlocked(all, count, nodes.data(), count, nodes.data(), block.data(), ADD_VALUES));
    }
    DEADPOINT_PETSC(MatAssemblyBegin(all, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(all, MAT_FINAL_ASSEMBLY));
    expansion_ = ties_.expansion(space_);
    DEADPOINT_PETSC(MatPtAP(all, expansion_, MAT_INITIAL_MATRIX, 2.0, matrix_.out()));
    DEADPOINT_PETSC(MatProductClear(matrix_));  // else it keeps the matrix of all displacements alive
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_USE_INODES, PETSC_FALSE));
}

void ElasticSolver::set_near_null_space()
{
    OwnedVec coordinates;
    DEADPOINT_PETSC(MatCreateVecs(matrix_, coordinates.out(), nullptr));
    DEADPOINT_PETSC(VecSetBlockSize(coordinates, 3));
    const auto points = space_.support_points();
    const auto free = ties_.free_nodes(space_);
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(coordinates, &values));
    for (std::size_t i = 0; i < free.size(); ++i)
        std::copy(points[free[i]].begin(), points[free[i]].end(), values + 3 * i);
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

template <class Visitor>
void ElasticSolver::for_each_cell(const Visitor& visit) const
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
        visit(v, indices, thermal_modulus(static_cast<int>(cell->material_id())));
    }
}

// Into solution_.
void ElasticSolver::solve_dual(const Functional& functional)
{
    load(functional, rhs_);
    pieces_->equilibrate(rhs_);
    DEADPOINT_PETSC(VecSet(free_solution_, 0));
    solve_free("the deformation's adjoint");
}

Displacement ElasticSolver::owned_solution() const
{
    Displacement result;
    const double* owned = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(solution_, &owned));
    result.owned.assign(owned, owned + 3 * (space_.last - space_.first));
    DEADPOINT_PETSC(VecRestoreArrayRead(solution_, &owned));
    return result;
}

Displacement ElasticSolver::dual(const Functional& functional)
{
    solve_dual(functional);
    return owned_solution();
}

std::vector<Adjoint> ElasticSolver::adjoints(const std::vector<Functional>& functionals)
{
    std::vector<Adjoint> result;
    Everywhere gathered(solution_);
    OwnedVec weights = create_vector(space_, 1);
    for (const auto& functional : functionals) {
        solve_dual(functional);
        const double* u = gathered.gather(solution_);

        DEADPOINT_PETSC(VecSet(weights, 0));
        std::vector<double> cell_weights;
        for_each_cell([&](const dealii::FEValues<3>& v, const auto& dofs, double modulus) {
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
    std::vector<double> cell_load;
    for_each_cell([&](const dealii::FEValues<3>& v, const auto& dofs, double modulus) {
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
                DEADPOINT_PETSC(
                    VecSetValue(rhs_, static_cast<PetscInt>(3 * dofs[i] + c), cell_load[3 * i + c], ADD_VALUES));
    });
    DEADPOINT_PETSC(VecAssemblyBegin(rhs_));
    DEADPOINT_PETSC(VecAssemblyEnd(rhs_));
    solve_free("the thermal deformation");
    pieces_->remove_rigid_motion(solution_);
    return owned_solution();
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
