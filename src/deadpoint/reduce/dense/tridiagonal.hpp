#pragma once

#include "deadpoint/reduce/dense/symmetric_matrix.hpp"

#include <Eigen/Dense>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Q T Q^T of a symmetric matrix K, with T tridiagonal, by Householder's reflections (Golub and Van Loan, Matrix
/// Computations, 8.3.1): 4 n^3/3 operations in n passes over the lower half. Q stays the product of its reflections; a
/// product with it takes as many operations as one with a matrix, and half the memory's traffic.
class TridiagonalForm {
public:
    TridiagonalForm() = default;
    explicit TridiagonalForm(SymmetricMatrix matrix);

    void into_basis(Eigen::Ref<Eigen::MatrixXd> columns) const;  ///< Q^T columns
    void from_basis(Eigen::Ref<Eigen::MatrixXd> columns) const;  ///< Q columns

    Eigen::VectorXd diagonal, beside;  ///< of T

private:
    void take_reflector(Eigen::Index column, double factor, const Eigen::VectorXd& reflector);
    void finish_panel(Eigen::Index panel);
    void reflect(bool transposed, Eigen::Ref<Eigen::MatrixXd> columns) const;

    Eigen::Index padded_ = 0;
    PaddedNumbers reflectors_;  ///< in panels
    PaddedNumbers triangles_;   ///< of each panel
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
