#include "deadpoint/fem/reduction/block_solver.hpp"

namespace deadpoint::fem {
namespace {

PC preconditioner_of(KSP solver)
{
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver, &preconditioner));
    return preconditioner;
}

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

BlockSolver::BlockSolver(Mat pattern)
{
    DEADPOINT_PETSC(MatDuplicate(pattern, MAT_COPY_VALUES, matrix_.out()));
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPPREONLY));
    DEADPOINT_PETSC(PCSetType(preconditioner_of(solver_), PCCHOLESKY));
    DEADPOINT_PETSC(PCFactorSetMatSolverType(preconditioner_of(solver_), MATSOLVERMUMPS));
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
}

void BlockSolver::set(Mat stiffness, double shift, Mat mass)
{
    DEADPOINT_PETSC(MatCopy(stiffness, matrix_, SAME_NONZERO_PATTERN));
    DEADPOINT_PETSC(MatAXPY(matrix_, shift, mass, SAME_NONZERO_PATTERN));
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
    DEADPOINT_PETSC(PCSetUp(preconditioner_of(solver_)));
}

Eigen::MatrixXd BlockSolver::solve(const Eigen::MatrixXd& right)
{
    Eigen::MatrixXd solution(right.rows(), right.cols());
    Mat factor = nullptr;
    DEADPOINT_PETSC(PCFactorGetMatrix(preconditioner_of(solver_), &factor));
    const auto from = dense_view(right), to = dense_view(solution);
    DEADPOINT_PETSC(MatMatSolve(factor, from, to));
    if (!solution.allFinite())
        throw ConvergenceError("a field of the reduced basis is not finite; look for a coefficient of the case that "
                               "cannot be meant");
    return solution;
}

}  // namespace deadpoint::fem
