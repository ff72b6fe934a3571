#include "deadpoint/fem/elastic/factor_solver.hpp"

#include <cstddef>
#include <vector>

namespace deadpoint::fem {
namespace {

constexpr int rounds = 3;
// Factor on the expected change: other loads may have less favourable residuals than those that gave the gain.
constexpr double residual_caution = 10;

PetscInt columns_of(Mat dense)
{
    PetscInt columns = 0;
    DEADPOINT_PETSC(MatGetSize(dense, nullptr, &columns));
    return columns;
}

PetscInt rows_of(Mat dense)
{
    PetscInt rows = 0;
    DEADPOINT_PETSC(MatGetLocalSize(dense, &rows, nullptr));
    return rows;
}

OwnedMat like(Mat dense) { return dense_columns(rows_of(dense), columns_of(dense)); }

// residual = right - matrix solution
void set_residual(const SymmetricTriplets& matrix, Mat right, Mat solution, Mat residual)
{
    matrix.multiply(solution, residual);
    DEADPOINT_PETSC(MatAYPX(residual, -1, right, SAME_NONZERO_PATTERN));
}

std::vector<PetscReal> column_norms(Mat dense)
{
    std::vector<PetscReal> norms(static_cast<std::size_t>(columns_of(dense)));
    DEADPOINT_PETSC(MatGetColumnNorms(dense, NORM_2, norms.data()));
    return norms;
}

bool is_settled(Mat change, Mat solution, double tolerance)
{
    const auto changes = column_norms(change), sizes = column_norms(solution);
    for (std::size_t k = 0; k < changes.size(); ++k)
        if (!(changes[k] <= tolerance * sizes[k]))
            return false;
    return true;
}

}  // namespace

OwnedMat dense_columns(PetscInt rows, PetscInt columns)
{
    OwnedMat result;
    DEADPOINT_PETSC(
        MatCreateDense(PETSC_COMM_WORLD, rows, PETSC_DECIDE, PETSC_DETERMINE, columns, nullptr, result.out()));
    return result;
}

bool FactorSolver::is_sharp(SparseFactor& factor, Mat residual, Mat solution, double tolerance)
{
    const auto residuals = column_norms(residual), sizes = column_norms(solution);
    if (gain_ == 0) {
        const auto sum = dense_columns(rows_of(residual), 1), change = dense_columns(rows_of(residual), 1);
        Vec total = nullptr, column = nullptr;
        DEADPOINT_PETSC(MatDenseGetColumnVecWrite(sum, 0, &total));
        DEADPOINT_PETSC(VecSet(total, 0));
        for (PetscInt k = 0; k < columns_of(residual); ++k) {
            const double size = residuals[static_cast<std::size_t>(k)];
            DEADPOINT_PETSC(MatDenseGetColumnVecRead(residual, k, &column));
            if (size > 0)
                DEADPOINT_PETSC(VecAXPY(total, 1 / size, column));
            DEADPOINT_PETSC(MatDenseRestoreColumnVecRead(residual, k, &column));
        }
        DEADPOINT_PETSC(MatDenseRestoreColumnVecWrite(sum, 0, &total));
        factor.solve(sum, change);
        if (const double size = column_norms(sum)[0]; size > 0)
            gain_ = column_norms(change)[0] / size;
    }
    for (std::size_t k = 0; k < sizes.size(); ++k)
        if (!(residual_caution * gain_ * residuals[k] <= tolerance * sizes[k]))
            return false;
    return true;
}

bool FactorSolver::solve(const SymmetricTriplets& matrix, SparseFactor& factor, Mat right, Mat solution,
                         double tolerance)
{
    const auto residual = like(right);
    factor.solve(right, solution);
    set_residual(matrix, right, solution, residual);
    if (is_sharp(factor, residual, solution, tolerance))
        return true;
    const auto change = like(right);
    for (int round = 0; round < rounds; ++round) {
        factor.solve(residual, change);
        DEADPOINT_PETSC(MatAXPY(solution, 1, change, SAME_NONZERO_PATTERN));
        if (is_settled(change, solution, tolerance))
            return true;
        set_residual(matrix, right, solution, residual);
    }
    return false;
}

}  // namespace deadpoint::fem
