#pragma once

#include <Eigen/Dense>

namespace deadpoint::reduce {

/// Combinations of fields that are orthonormal, from the fields' inner products: T with T^T G T = 1, by a Cholesky
/// decomposition with pivots. The first field comes first; of the others always the one whose part that is new is
/// largest, until that is below `least` times the field's own norm.
/// @param gram  symmetric, positive semidefinite, its first entry positive
Eigen::MatrixXd orthonormal_combinations(const Eigen::MatrixXd& gram, double least);

}  // namespace deadpoint::reduce
