#pragma once

#include <Eigen/Dense>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Q T Q^T of a symmetric matrix K, with T tridiagonal: for 4 n^3/3 operations, and as many again for Q.
struct TridiagonalForm {
    TridiagonalForm() = default;
    /// @param matrix  K, of which only the lower half is read
    explicit TridiagonalForm(const Eigen::MatrixXd& matrix);

    Eigen::MatrixXd basis;             ///< Q
    Eigen::VectorXd diagonal, beside;  ///< of T
};

/// 1 + d T = L D L^T
struct ShiftedFactor {
    ShiftedFactor() = default;
    /// @throws heat::NotFinite if 1 + d T is not positive definite or not finite
    ShiftedFactor(const TridiagonalForm& form, double d);
    /// (1 + d T)^-1 columns
    void solve_in_place(Eigen::Ref<Eigen::MatrixXd> columns) const;

    Eigen::VectorXd below, pivots;  ///< of L; 1 / D
};

}  // namespace deadpoint::reduce
