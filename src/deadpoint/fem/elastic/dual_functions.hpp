#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

/// Internal to fem/: the dual functions of a mortar condition.
namespace deadpoint::fem {

/// A face, or the part of it that a bond covers: shape functions at points with weights.
struct CoveredFace {
    Eigen::MatrixXd shape;   ///< points x nodes of the face
    Eigen::VectorXd weight;  ///< of the points [m2]
};

/// psi of some nodes of a face, points x those nodes:
///
///     integral of psi_i N_j = delta_ij integral of N_j,      sum of psi_i = 1       for i, j among those nodes
///
/// over the covered area, exactly in the sum over the points (Wohlmuth, SIAM J. Numer. Anal. 38,
/// 2000; boundaries as in Puso and Laursen, Comput. Methods Appl. Mech. Eng. 193, 2004). psi = D
/// M^-1 N', with D_i = integral of N_i, M_ij = integral of N'_i N_j and N' the shape functions of
/// those nodes plus equal shares of the other nodes'.
/// @param chosen  nodes of the face, by column of `shape`
/// @return none if the covered area determines one of them too weakly: an integral of N_i is below
///         1e-3 of the area, as at the corners of a triangle of second order (0), or the least
///         singular value of D^-1/2 M D^-1/2 is below 0.02 (on a whole square 1/9, of second order
///         4/25; on a whole triangle 1/4)
std::optional<Eigen::MatrixXd> dual_functions(const CoveredFace& face, const std::vector<int>& chosen);

}  // namespace deadpoint::fem
