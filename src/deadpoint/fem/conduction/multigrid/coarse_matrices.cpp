#include "deadpoint/fem/conduction/multigrid/coarse_matrices.hpp"

#include "deadpoint/fem/algebra/vectors.hpp"

#include <algorithm>
#include <array>
#include <random>

namespace deadpoint::fem {
namespace {

constexpr int estimate_iterations = 10;
// Share of the start's residual. A small level is solved exactly before the last iteration. PETSc would then count one
// iteration too many, whose coefficients were never written.
constexpr double exact = 1e-10;
// Factor above the estimate, which is a lower bound. If films are far stiffer than the metal, too low a bound makes
// the preconditioner indefinite.
constexpr double room = 1.2;

// Ordered from the coarsest.
std::vector<KSP> solvers_of_levels(PC multigrid)
{
    PetscInt count = 0;
    DEADPOINT_PETSC(PCMGGetLevels(multigrid, &count));
    std::vector<KSP> solvers(static_cast<std::size_t>(count));
    DEADPOINT_PETSC(PCMGGetCoarseSolve(multigrid, &solvers[0]));
    for (PetscInt level = 1; level < count; ++level)
        DEADPOINT_PETSC(PCMGGetSmoother(multigrid, level, &solvers[static_cast<std::size_t>(level)]));
    return solvers;
}

// With values in which all eigenvectors occur, the same at every call, so that a resumed run finds the same bounds.
void fill_unevenly(Vec vector)
{
    PetscInt first = 0, last = 0;
    DEADPOINT_PETSC(VecGetOwnershipRange(vector, &first, &last));
    std::minstd_rand numbers(static_cast<unsigned>(1 + first));
    std::uniform_real_distribution<double> values(-0.5, 0.5);
    Entries entries(vector);
    for (PetscInt i = 0; i < last - first; ++i)
        entries[i] = values(numbers);
}

}  // namespace

double largest_eigenvalue(Mat matrix)
{
    OwnedKsp solver;
    DEADPOINT_PETSC(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(matrix)), solver.out()));
    DEADPOINT_PETSC(KSPSetType(solver, KSPCG));
    DEADPOINT_PETSC(KSPSetOperators(solver, matrix, matrix));
    PC diagonal = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver, &diagonal));
    DEADPOINT_PETSC(PCSetType(diagonal, PCJACOBI));
    DEADPOINT_PETSC(KSPSetNormType(solver, KSP_NORM_NATURAL));
    DEADPOINT_PETSC(KSPSetTolerances(solver, exact, PETSC_DEFAULT, PETSC_DEFAULT, estimate_iterations));
    DEADPOINT_PETSC(KSPSetComputeEigenvalues(solver, PETSC_TRUE));
    OwnedVec load, solution;
    DEADPOINT_PETSC(MatCreateVecs(matrix, solution.out(), load.out()));
    fill_unevenly(load);
    DEADPOINT_PETSC(KSPSolve(solver, load, solution));
    std::array<double, estimate_iterations> real{}, imaginary{};
    PetscInt count = 0;
    DEADPOINT_PETSC(KSPComputeEigenvalues(solver, estimate_iterations, real.data(), imaginary.data(), &count));
    return count > 0 ? *std::max_element(real.begin(), real.begin() + count) : 1;
}

std::vector<double> smoother_bounds(PC multigrid)
{
    const auto solvers = solvers_of_levels(multigrid);
    std::vector<double> bounds(solvers.size(), 0.0);
    for (std::size_t level = 1; level < solvers.size(); ++level)
        bounds[level] = room * largest_eigenvalue(matrix_of(solvers[level]));
    return bounds;
}

void CoarseMatrices::keep(PC multigrid, double factor)
{
    const auto solvers = solvers_of_levels(multigrid);
    const bool first = bounds_.empty();
    auto& kept = first ? first_ : slopes_;
    for (std::size_t level = 0; level + 1 < solvers.size(); ++level)
        DEADPOINT_PETSC(MatDuplicate(matrix_of(solvers[level]), MAT_COPY_VALUES, kept.emplace_back().out()));
    const auto bounds = smoother_bounds(multigrid);
    bounds_.resize(solvers.size());
    for (std::size_t level = 0; level < solvers.size(); ++level)
        bounds_[level] = std::max(bounds_[level], bounds[level]);
    if (first) {
        first_factor_ = factor;
        return;
    }
    for (std::size_t level = 0; level < slopes_.size(); ++level) {
        DEADPOINT_PETSC(MatAXPY(slopes_[level], -1, first_[level], SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatScale(slopes_[level], 1 / (factor - first_factor_)));
    }
}

void CoarseMatrices::follow(PC multigrid, double factor) const
{
    const auto solvers = solvers_of_levels(multigrid);
    for (std::size_t level = 0; level < slopes_.size(); ++level) {
        const Mat matrix = matrix_of(solvers[level]);
        DEADPOINT_PETSC(MatCopy(first_[level], matrix, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatAXPY(matrix, factor - first_factor_, slopes_[level], SAME_NONZERO_PATTERN));
    }
}

}  // namespace deadpoint::fem
