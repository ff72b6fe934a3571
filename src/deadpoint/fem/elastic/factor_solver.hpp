#pragma once

#include "deadpoint/fem/algebra/sparse_factor.hpp"

/// Internal to fem/: solves with a sparse factor.
namespace deadpoint::fem {

/// A dense matrix of `columns` columns with so many rows on this rank.
OwnedMat dense_columns(PetscInt rows, PetscInt columns);

/// Solves with a sparse factor to a tolerance of the relative change by one more step of iterative refinement (Golub
/// and Van Loan, Matrix Computations, section 3.5.3).
///
/// Nearly always the first solution is good enough, and a step would only confirm it, at the price of the solution. A
/// residual r of rounding errors changes the solution by about gain |r|. The gain is measured once per factor, with the
/// sum of the first residuals, at the price of one right side.
class FactorSolver {
public:
    /// @param right, solution  dense, of the same number of columns
    /// @return false if the refinement does not converge
    bool solve(const SymmetricTriplets& matrix, SparseFactor& factor, Mat right, Mat solution, double tolerance);

private:
    [[nodiscard]] bool is_sharp(SparseFactor& factor, Mat residual, Mat solution, double tolerance);

    double gain_ = 0;  ///< 0: not measured
};

}  // namespace deadpoint::fem
