#pragma once

#include "deadpoint/crankshaft/response/modal_basis.hpp"
#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"

#include <complex>

/// Internal to crankshaft/: matrices of the shaft's forced vibration.
namespace deadpoint::crankshaft {

/// C + C_modal - omega G.
inline Eigen::MatrixXd velocity_matrix(const ShaftSystem& system, double speed)
{
    Eigen::MatrixXd c = view(system.damping) - speed * view(system.gyroscopic);
    if (system.modal_damping > 0)
        c += modal_damping_matrix(system, resting_modes(system));
    return c;
}

/// K - omega^2 M + i omega C.
inline Eigen::MatrixXcd dynamic_stiffness(const ShaftSystem& system, const Eigen::MatrixXd& velocity, double omega)
{
    return (view(system.stiffness) - omega * omega * view(system.mass)).cast<std::complex<double>>() +
           std::complex<double>(0, omega) * velocity.cast<std::complex<double>>();
}

}  // namespace deadpoint::crankshaft
