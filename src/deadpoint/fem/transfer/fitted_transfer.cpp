#include "deadpoint/fem/transfer/fitted_transfer.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/transfer/transfer.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

constexpr double regularisation = 1e-3;
constexpr double fit_tolerance = 1e-13;

// This rank's unknowns' shares of their cells' volumes [m3].
std::vector<double> volumes(const Discretisation& space)
{
    std::vector<double> result(static_cast<std::size_t>(space.last - space.first), 0.0);
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = space.first_cell; cell < space.machine.cells.size(); ++cell) {
        space.unknowns_of(cell, unknowns);
        if (std::ranges::none_of(unknowns, [&](PetscInt unknown) { return space.owns(unknown); }))
            continue;
        const double share = space.maps.volume(cell) / static_cast<double>(unknowns.size());
        for (const auto unknown : unknowns)
            if (space.owns(unknown))
                result[static_cast<std::size_t>(unknown - space.first)] += share;
    }
    return result;
}

}  // namespace

FittedTransfer::FittedTransfer(const Discretisation& fine, const Discretisation& coarse, const Transfer& values,
                               const Transfer& back)
    : values_(values), back_(back), weight_(volumes(fine)), matrix_(create_matrix(coarse.cell_couplings().rows())),
      rhs_(create_vector(coarse, 1)), solution_(create_vector(coarse, 1))
{
    assemble(coarse);
    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    DEADPOINT_PETSC(PCSetType(preconditioner, PCJACOBI));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, fit_tolerance, 1e-300, 1e12, 5000));
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
}

void FittedTransfer::assemble(const Discretisation& coarse)
{
    PointShape shape;
    std::array<double, max_cell_dofs * max_cell_dofs> block{};
    for (std::size_t i = 0; i < weight_.size(); ++i) {
        back_.shape(i, shape);
        for (int k = 0; k < shape.count; ++k)
            for (int l = 0; l < shape.count; ++l)
                block[static_cast<std::size_t>(k) * shape.count + l] = weight_[i] * shape.value[k] * shape.value[l];
        DEADPOINT_PETSC(MatSetValues(matrix_, shape.count, shape.dof.data(), shape.count, shape.dof.data(),
                                     block.data(), ADD_VALUES));
    }
    const auto volume = volumes(coarse);
    for (std::size_t i = 0; i < volume.size(); ++i) {
        const auto row = coarse.first + static_cast<PetscInt>(i);
        DEADPOINT_PETSC(MatSetValue(matrix_, row, row, regularisation * volume[i], ADD_VALUES));
    }
    DEADPOINT_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

std::vector<double> FittedTransfer::solve_normal(const std::vector<double>& rhs) const
{
    double* target = nullptr;
    DEADPOINT_PETSC(VecGetArray(rhs_, &target));
    std::ranges::copy(rhs, target);
    DEADPOINT_PETSC(VecRestoreArray(rhs_, &target));
    DEADPOINT_PETSC(VecSet(solution_, 0));
    solve(solver_, rhs_, solution_, "the temperatures on the mesh of the deformation");
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(solution_, &values));
    std::vector<double> result(values, values + rhs.size());
    DEADPOINT_PETSC(VecRestoreArrayRead(solution_, &values));
    return result;
}

std::vector<double> FittedTransfer::apply(const std::vector<double>& owned) const
{
    auto result = values_.apply(owned, 1);
    auto rest = back_.apply(result, 1);
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = weight_[i] * (owned[i] - rest[i]);
    const auto correction = solve_normal(back_.apply_transposed(rest));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += correction[i];
    return result;
}

std::vector<double> FittedTransfer::apply_transposed(const std::vector<double>& owned) const
{
    auto result = back_.apply(solve_normal(owned), 1);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] *= weight_[i];
    auto at_nodes = back_.apply_transposed(result);
    for (std::size_t i = 0; i < at_nodes.size(); ++i)
        at_nodes[i] = owned[i] - at_nodes[i];
    const auto direct = values_.apply_transposed(at_nodes);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += direct[i];
    return result;
}

}  // namespace deadpoint::fem
