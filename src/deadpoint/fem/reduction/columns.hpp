#pragma once

#include "deadpoint/fem/space/petsc.hpp"

#include <Eigen/Dense>

/// Internal to fem/: blocks of vectors, a column for each. Rows are this rank's unknowns.
namespace deadpoint::fem {

/// A^T B, of all ranks, by the machine's BLAS.
Eigen::MatrixXd inner_products(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// A B of a block and a small matrix, by the machine's BLAS.
Eigen::MatrixXd combined(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& combinations);
/// A sparse matrix times each column.
Eigen::MatrixXd times(Mat matrix, const Eigen::MatrixXd& columns);
/// Sums a small matrix over the ranks, in place.
void sum_over_ranks(Eigen::MatrixXd& matrix);

}  // namespace deadpoint::fem
