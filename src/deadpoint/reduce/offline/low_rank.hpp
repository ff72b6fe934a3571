#pragma once

#include <Eigen/Dense>
#include <functional>

/// Symmetric positive semidefinite matrices as factors of low rank, A = V V^T.
namespace deadpoint::reduce {

/// A times a block of columns.
using SymmetricProduct = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// V of a matrix that is known by its products: the eigenvectors whose eigenvalue is above `tolerance` times the
/// largest, by Nystroem's approximation with random columns (Tropp, Yurtsever, Udell and Cevher, Fixed-rank
/// approximation of a positive-semidefinite matrix from streaming data, 2017). The number of columns doubles until the
/// smallest eigenvalue found is below the tolerance. Two calls give the same result.
/// @throws ConvergenceError if the matrix is not positive semidefinite
Eigen::MatrixXd low_rank_factor(const SymmetricProduct& product, Eigen::Index size, double tolerance);
/// The same of a matrix that is at hand, by its eigenvectors. Columns are orthogonal, the largest first.
Eigen::MatrixXd factor_of(const Eigen::MatrixXd& matrix, double tolerance);

/// The same of a matrix that has this load on the uniform field u: A u = load. V keeps it exactly: its first column is
/// load / sqrt(u . load), and what is left, A - load load^T / (u . load), is cut. A term of a film or of oil then takes
/// no heat from a machine that is as warm as its surroundings.
Eigen::MatrixXd low_rank_factor(const SymmetricProduct& product, const Eigen::VectorXd& load,
                                const Eigen::VectorXd& uniform, double tolerance);

/// V with fewer columns: after the first `kept` ones, the directions in which states with these second moments
/// give off the most heat, eigenvectors of V^T moments V; those with `least` or less are left out. What is left out
/// of V V^T is positive semidefinite.
/// @param moments  symmetric
Eigen::MatrixXd cut(const Eigen::MatrixXd& factor, Eigen::Index kept, const Eigen::MatrixXd& moments, double least);

}  // namespace deadpoint::reduce
