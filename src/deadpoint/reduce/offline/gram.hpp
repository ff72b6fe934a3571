#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace deadpoint::reduce {

/// Which fields become part of a basis.
struct FieldChoice {
    double least = 0;            ///< a field's new part must be larger, relative to the field
    std::size_t most = 1;        ///< number of fields
    std::vector<double> weight;  ///< of each field's new part, relative to the field; infinite: before all others
};

/// Combinations of fields that are orthonormal, from the fields' inner products: T with T^T G T = 1, by a Cholesky
/// decomposition with pivots. The first field comes first; of the others always the one whose weight times the part of
/// it that is new is largest.
/// @param gram  symmetric, positive semidefinite, its first entry positive
Eigen::MatrixXd orthonormal_combinations(const Eigen::MatrixXd& gram, const FieldChoice& choice);

}  // namespace deadpoint::reduce
