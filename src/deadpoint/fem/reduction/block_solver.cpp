#include "deadpoint/fem/reduction/block_solver.hpp"

namespace deadpoint::fem {
namespace {

// A view of the columns; their memory must outlive it.
OwnedMat dense_view(const Eigen::MatrixXd& columns)
{
    OwnedMat view;
    DEADPOINT_PETSC(MatCreateDense(PETSC_COMM_WORLD, static_cast<PetscInt>(columns.rows()), PETSC_DECIDE,
                                   PETSC_DETERMINE, static_cast<PetscInt>(columns.cols()),
                                   const_cast<double*>(columns.data()), view.out()));
    return view;
}

}  // namespace

BlockSolver::BlockSolver(Mat pattern) : factor_(SymmetricTriplets(pattern), 1)
{
    DEADPOINT_PETSC(MatDuplicate(pattern, MAT_COPY_VALUES, matrix_.out()));
}

void BlockSolver::set(Mat stiffness, double shift, Mat mass)
{
    DEADPOINT_PETSC(MatCopy(stiffness, matrix_, SAME_NONZERO_PATTERN));
    DEADPOINT_PETSC(MatAXPY(matrix_, shift, mass, SAME_NONZERO_PATTERN));
    factor_.factorise(SymmetricTriplets(matrix_));
}

Eigen::MatrixXd BlockSolver::solve(const Eigen::MatrixXd& right)
{
    Eigen::MatrixXd solution(right.rows(), right.cols());
    const auto from = dense_view(right), to = dense_view(solution);
    factor_.solve(from, to);
    if (!solution.allFinite())
        throw ConvergenceError("a field of the reduced basis is not finite; look for a coefficient of the case that "
                               "cannot be meant");
    return solution;
}

}  // namespace deadpoint::fem
