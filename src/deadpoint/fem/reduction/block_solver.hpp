#pragma once

#include "deadpoint/fem/space/petsc.hpp"

#include <Eigen/Dense>

/// Internal to fem/: a sparse factor that solves for blocks of right-hand sides.
namespace deadpoint::fem {

/// Solves (stiffness + shift mass) X = B by a Cholesky factor (MUMPS). Matrices set later have the pattern of the first
/// one, whose ordering serves all.
class BlockSolver {
public:
    explicit BlockSolver(Mat pattern);
    void set(Mat stiffness, double shift, Mat mass);
    /// @param right  a column for each right-hand side, this rank's rows @throws ConvergenceError
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right);

private:
    OwnedMat matrix_;
    OwnedKsp solver_;
};

}  // namespace deadpoint::fem
