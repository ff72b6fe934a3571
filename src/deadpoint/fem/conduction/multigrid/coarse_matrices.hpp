#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <vector>

/// Internal to fem/: one multigrid hierarchy for all step sizes.
namespace deadpoint::fem {

/// Coarse matrices and smoother bounds of a multigrid for A(d) = M + d K at any d [s], from those
/// at two values of d. With a fixed interpolation P, the coarse matrices P^T A(d) P are linear in
/// d. The largest eigenvalue of D^-1 A(d), D the diagonal, bounds the range of a smoother. Between
/// the two d it never exceeds the larger end value, since x^T A x / x^T D x is a mean of the ratios
/// at both ends with positive weights.
class CoarseMatrices {
public:
    /// Keeps the coarse matrices and bounds of a multigrid that is set up for `factor` [s] (PCMG or PCML).
    void keep(PC multigrid, double factor);
    /// True if two factors are kept.
    [[nodiscard]] bool complete() const { return slopes_.size() + 1 == bounds_.size(); }
    /// Sets the coarse levels to the matrices of M + factor K. Needs two kept factors; the bounds
    /// are valid between them.
    void follow(PC multigrid, double factor) const;
    /// Upper bounds of the eigenvalues of D^-1 A per level, from the coarsest on; 0 for the coarsest.
    [[nodiscard]] const std::vector<double>& bounds() const { return bounds_; }

private:
    double first_factor_ = 0;
    std::vector<OwnedMat> first_;   ///< at the first factor, from the coarsest level on
    std::vector<OwnedMat> slopes_;  ///< change with the factor [1/s]
    std::vector<double> bounds_;
};

/// Estimate of the largest eigenvalue of D^-1 A from below, D the diagonal, by ten iterations of conjugate gradients.
/// @param matrix  symmetric and positive definite
double largest_eigenvalue(Mat matrix);
/// Such bounds of a multigrid that is set up.
std::vector<double> smoother_bounds(PC multigrid);

}  // namespace deadpoint::fem
