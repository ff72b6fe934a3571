#pragma once

#include <Eigen/Dense>
#include <petscmat.h>

/// Internal to fem/: solutions for several right-hand sides at once.
namespace deadpoint::fem {

class FloatCycle;

struct BlockSolution {
    Eigen::MatrixXd columns;
    int iterations = 0;  ///< of the block that took most
};

/// Solves A X = B by conjugate gradients with multigrid cycles (Saad, Iterative Methods for Sparse Linear Systems,
/// 2003, algorithm 9.1). Eight columns go at once, each with its own coefficients, so that matrices are read once for
/// all. They end together, when the next correction of each is expected to be small. Collective.
/// @param matrix    symmetric, positive definite, AIJ on one rank or many
/// @param right     this rank's rows
/// @param relative  largest norm of a correction, as a share of that of the largest one
/// @param what      the solution, for errors
/// @throws ConvergenceError if a column does not converge
BlockSolution solve_together(Mat matrix, FloatCycle& cycle, const Eigen::MatrixXd& right, double relative,
                             const char* what);

}  // namespace deadpoint::fem
