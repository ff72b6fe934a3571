#pragma once

#include "deadpoint/crankshaft/eigen_views.hpp"
#include "deadpoint/crankshaft/system.hpp"

/// The shaft in the modes of the resting, undamped shaft; only for the sources of this folder.
namespace deadpoint::crankshaft {

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

/// First-order system z' = A z + ... with z = (p, sqrt(mu) p'), q = X p, given by the inverse of A: its largest
/// eigenvalues are the lowest modes, which are thus the most accurate.
///
/// @param modal_damping  ratio added to every moving mode
/// @throws InputError if a damper or a skew stiffness acts on shapes without inertia
struct FirstOrder {
    Eigen::MatrixXd inverse;       ///< A^-1, 2m x 2m
    Eigen::MatrixXd static_shape;  ///< (1 + X^T K_skew X)^-1 X^T: p under a constant load
};
FirstOrder first_order(const ShaftSystem& system, const RestingModes& basis, double speed, double modal_damping);

}  // namespace deadpoint::crankshaft
