#pragma once

#include <Eigen/Dense>

/// Internal to reduce/, since it shows Eigen: products of larger matrices, with the kernels of the processor.
namespace deadpoint::reduce {

/// Row-major matrix, so that a row is contiguous in memory.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// a^T b
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// upper b, where nothing below the diagonal of `upper` is read.
Eigen::MatrixXd upper_product(const RowMatrix& upper, const Eigen::MatrixXd& b);

}  // namespace deadpoint::reduce
