#pragma once

#include "deadpoint/reduce/offline/full_model.hpp"

namespace deadpoint::reduce {

/// Second moments of states, for a basis of those that occur most (proper orthogonal decomposition).
class Moments {
public:
    explicit Moments(Eigen::Index states) : sum_(Eigen::MatrixXd::Zero(states, states)) {}
    /// With this sum().
    explicit Moments(Eigen::MatrixXd sum) : sum_(std::move(sum)) {}
    /// @param states  a column for each
    void add(const Eigen::MatrixXd& states);
    /// Of all ranks. Collective.
    void sum_over(const Ranks& ranks);
    [[nodiscard]] const Eigen::MatrixXd& sum() const { return sum_; }

private:
    Eigen::MatrixXd sum_;  ///< lower triangle
};

/// Combinations of states: the uniform field, then the eigenvectors of largest eigenvalue of
///   moments / trace + dual_share duals / trace
/// without the uniform field. @return a column for each, orthonormal; at most `count`
Eigen::MatrixXd most_frequent(const Moments& moments, const Moments& duals, double dual_share,
                              const Eigen::VectorXd& uniform, Eigen::Index count);

/// The terms on combinations of the states, cut to lower rank.
DenseTerms combined(const DenseTerms& terms, const Eigen::MatrixXd& combinations, const Truncation& truncation);

}  // namespace deadpoint::reduce
