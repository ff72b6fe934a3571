#pragma once

#include "deadpoint/crankshaft/shaft/eigen_views.hpp"

/// The shaft in the modes of the resting, undamped shaft; only for the sources of this folder.
namespace deadpoint::crankshaft {

struct ShaftSystem;

/// Modes of M, K (symmetric part of K), scaled so that X^T K X = 1; then X^T M X = diag(mu) with mu = 1/omega^2.
struct RestingModes {
    Eigen::MatrixXd moving;     ///< unknowns x modes with inertia
    Eigen::VectorXd mu;         ///< of the moving modes, descending [s2]
    Eigen::MatrixXd following;  ///< shapes (almost) without inertia, which follow the load
};

/// @throws InputError if K is not positive definite
RestingModes resting_modes(const ShaftSystem& system);

/// C_modal of periodic_response, in the unknowns of the system.
Eigen::MatrixXd modal_damping_matrix(const ShaftSystem& system, const RestingModes& basis);

/// Damping, gyroscopic and skew terms in the moving modes: X^T (.) X.
struct ModalMatrices {
    Eigen::MatrixXd dampers;
    Eigen::MatrixXd gyroscopic;
    Eigen::MatrixXd skew;  ///< part of K

    [[nodiscard]] Eigen::Index modes() const { return skew.cols(); }
};

/// @throws InputError if a damper or a skew stiffness acts on shapes without inertia
ModalMatrices modal_matrices(const ShaftSystem& system, const RestingModes& basis);

/// Some of the moving modes, in their order.
struct ModeRange {
    Eigen::Index first = 0, count = 0;
};

/// A^-1 of the first-order system z' = A z + ... with z = (p, sqrt(mu) p'), q = X p, in some modes of the resting
/// shaft: the largest eigenvalues of A^-1 are the lowest modes, which are thus the most accurate.
///
/// @param modal_damping  ratio added to every mode
/// @throws DomainError if it is not finite
Eigen::MatrixXd first_order_inverse(const RestingModes& basis, const ModalMatrices& matrices, double speed,
                                    double modal_damping, ModeRange modes);

}  // namespace deadpoint::crankshaft
