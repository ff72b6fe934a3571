#pragma once

#include "deadpoint/fem/algebra/sparse_factor.hpp"

#include <Eigen/Dense>

/// Internal to fem/: a sparse factor that solves for blocks of right-hand sides.
namespace deadpoint::fem {

/// Solves (stiffness + shift mass) X = B by a sparse factor. Matrices set later have the pattern of the first
/// one, whose ordering serves all.
class BlockSolver {
public:
    explicit BlockSolver(Mat pattern);
    void set(Mat stiffness, double shift, Mat mass);
    /// @param right  a column for each right-hand side, this rank's rows @throws ConvergenceError
    [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& right);

private:
    OwnedMat matrix_;
    SparseFactor factor_;
};

}  // namespace deadpoint::fem
