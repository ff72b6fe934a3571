#pragma once

#include "deadpoint/reduce/dense/tridiagonal.hpp"

#include <Eigen/Dense>
#include <map>
#include <memory>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Systems (1 + d K) x = b with a symmetric K >= 0 and any d >= 0, and terms of low rank beside.
///
/// K is brought to tridiagonal form Q T Q^T once. Each d then costs the factors of a tridiagonal matrix, and each solve
/// two products with Q: a run with a dozen step sizes needs no dozen Cholesky factors of n^3/3.
class ShiftedSolver {
public:
    /// @param form  of K
    void set_matrix(std::shared_ptr<const TridiagonalForm> form);
    /// @param loads  L of solve(), a column each
    void set_loads(const Eigen::MatrixXd& loads);
    /// @throws heat::NotFinite if 1 + d K is not positive definite or not finite
    void set_shift(double d);
    [[nodiscard]] Eigen::Index loads() const { return loads_.rows(); }
    [[nodiscard]] const std::shared_ptr<const TridiagonalForm>& form() const { return form_; }

    /// x = (1 + d K - L C L^T - N E N^T)^-1 right, with C and E diagonal:
    ///   x = A^-1 b + Z (1 - C L^T Z)^-1 C L^T A^-1 b,   Z = A^-1 L   (Woodbury's formula)
    /// @param of_loads  C, one for each load, or empty for none of them
    /// @param others, of_others  N and E
    void solve(const Eigen::VectorXd& right, const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
               const Eigen::VectorXd& of_others, Eigen::VectorXd& solution);

private:
    using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    /// The factors for one d, and the loads of all solves: in the basis of T.
    struct Shifted {
        ShiftedFactor factor;
        RowMatrix solved;          ///< (1 + d T)^-1 loads, a row each
        Eigen::MatrixXd products;  ///< of loads and solved
    };
    [[nodiscard]] Shifted factored(double d) const;
    void correct(const RowMatrix& loads, const Shifted& factor, const Eigen::VectorXd& coefficients);
    void correct_with_others(const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
                             const Eigen::VectorXd& of_others);

    std::shared_ptr<const TridiagonalForm> form_;
    RowMatrix loads_;                    ///< Q^T L, a row each
    std::map<double, Shifted> shifted_;  ///< by d
    const Shifted* present_ = nullptr;
    Eigen::VectorXd work_;
};

}  // namespace deadpoint::reduce
