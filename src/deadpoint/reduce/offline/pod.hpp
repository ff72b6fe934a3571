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
    /// Sums over all ranks. Collective.
    void sum_over(const Ranks& ranks);
    [[nodiscard]] const Eigen::MatrixXd& sum() const { return sum_; }

private:
    Eigen::MatrixXd sum_;  ///< lower triangle
};

/// The moments of the states' deviations from the uniform field. @param unit  that field, of length 1
Eigen::MatrixXd deviations(const Moments& moments, const Eigen::VectorXd& unit);

/// By what the states of a small model are chosen.
struct StateWeights {
    Eigen::VectorXd uniform;  ///< states of a temperature of 1 K everywhere
    Eigen::MatrixXd norm;     ///< of errors, symmetric and positive definite
    double dual_share = 0;    ///< of dual states
};
/// The norm  x^T x + readings |uniform|^2 (mean of f_k(x)^2)  with the functionals f_k by which errors are told: means
/// of sides of interfaces, and probes. A uniform field has the share `readings` by its functionals.
Eigen::MatrixXd error_norm(const DenseTerms& terms, double readings);

/// Combinations of states: the uniform field, then those without it that span, in this order, the eigenvectors of
/// largest eigenvalue of
///   L^T (moments / trace + dual_share duals / trace) L,    norm = L L^T,
/// times L^-T: of all bases of that size they leave the least of the states, in that norm.
/// @return a column for each, orthonormal; at most `count`
Eigen::MatrixXd most_frequent(const Moments& moments, const Moments& duals, const StateWeights& weights,
                              Eigen::Index count);

/// Other combinations of the same span: the first as it is, the others so that K of the solids is diagonal on them, the
/// slowest first. The first has to be uniform, whose row and column of K are zero.
Eigen::MatrixXd by_conduction(const DenseTerms& terms, const Eigen::MatrixXd& combinations);

/// The terms on combinations of the states.
DenseTerms combined(const DenseTerms& terms, const Eigen::MatrixXd& combinations);

}  // namespace deadpoint::reduce
