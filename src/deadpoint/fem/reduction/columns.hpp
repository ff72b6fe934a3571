#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <Eigen/Dense>

/// Internal to fem/: blocks of vectors, a column for each. Rows are this rank's unknowns.
namespace deadpoint::fem {

/// A^T B of this rank's rows, by the machine's BLAS.
Eigen::MatrixXd product_of_transposed(const Eigen::MatrixXd& a, const Eigen::Ref<const Eigen::MatrixXd>& b);
/// A B of a block and a small matrix, by the machine's BLAS.
Eigen::MatrixXd combined(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& combinations);
/// A sparse matrix times each column. Collective.
Eigen::MatrixXd times(Mat matrix, const Eigen::MatrixXd& columns);
/// Sums a small matrix over the ranks, in place, and equal bit by bit on all of them. Collective.
void sum_over_ranks(Eigen::MatrixXd& matrix);

}  // namespace deadpoint::fem
