#pragma once

#include <Eigen/Dense>

namespace deadpoint::reduce {

/// Upper triangle R with R^T R = gram + a small multiple of its diagonal, as large as rounding demands; so no size is
/// computed too small. A row without a diagonal stays zero. @throws ConvergenceError if the matrix is not positive
/// semidefinite
Eigen::MatrixXd residual_root(const Eigen::MatrixXd& gram);

}  // namespace deadpoint::reduce
