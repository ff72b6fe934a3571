#pragma once

#include "deadpoint/fem/space/petsc.hpp"

#include <vector>

/// Internal to fem/: a multigrid hierarchy that follows the step size.
namespace deadpoint::fem {

/// What a multigrid for A(d) = M + d K needs at each d [s], found at two: the matrices on the coarse levels, P^T A(d) P
/// with an interpolation P that stays, are linear in d; and the largest eigenvalue of D^-1 A(d), D the diagonal, which
/// bounds what a smoother damps, lies between the two d nowhere above both ends. For x^T A x / x^T D x is a mean of
/// the ratios at both ends with weights above zero.
class CoarseMatrices {
public:
    /// Keeps what a multigrid (PCMG or PCML, smoothed by Chebyshev polynomials of the diagonally scaled matrix) has
    /// that is set up for `factor` [s]; with the second factor its smoothers get their bounds for good.
    void keep(PC multigrid, double factor);
    [[nodiscard]] bool complete() const { return slopes_.size() + 1 == bounds_.size(); }
    /// Gives the coarse levels the matrices of M + factor K, whatever they had before. Needs two factors kept, and
    /// bounds hold between them.
    void follow(PC multigrid, double factor) const;

private:
    double first_factor_ = 0;
    std::vector<OwnedMat> first_;   ///< at the first factor, from the coarsest level on
    std::vector<OwnedMat> slopes_;  ///< change with the factor [1/s]
    std::vector<double> bounds_;    ///< largest eigenvalue of each level; none of the coarsest
};

}  // namespace deadpoint::fem
