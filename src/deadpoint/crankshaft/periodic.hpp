#pragma once

#include "deadpoint/crankshaft/system.hpp"

#include <complex>
#include <span>
#include <vector>

/// Forced vibration of the shaft that repeats every turn.
namespace deadpoint::crankshaft {

/// F(t) = sum over channels of pattern(:, channel) history(t, channel); linear between times evenly spaced over the
/// period, the first at 0, and periodic.
struct PeriodicLoad {
    double period = 0;  ///< [s]
    Matrix patterns;    ///< unknowns x channels
    Matrix histories;   ///< times x channels
};

/// What is read off the motion: y = D q + V q'.
struct Readings {
    Matrix displacement;  ///< readings x unknowns
    Matrix velocity;      ///< readings x unknowns
};

enum class PeriodicMethod { modal, harmonic_balance, newmark };

struct PeriodicSettings {
    PeriodicMethod method = PeriodicMethod::modal;
    int harmonics = 400;           ///< harmonic balance: of the turn
    int steps_per_sample = 4;      ///< Newmark
    int longest_run = 400;         ///< Newmark: turns until it must repeat
    double newmark_repeat = 1e-7;  ///< Newmark: change of the readings from turn to turn, relative to their largest
};

/// Periodic response of  M q'' + (C + C_modal - omega G) q' + K q = F(t)  at the times of the load.
///
/// C_modal gives every mode of M, K (symmetric part) the ratio zeta = system.modal_damping: C_modal = K X diag(2 zeta /
/// omega_i^3) X^T K with X^T K X = diag(omega_i^2), X^T M X = 1. Methods:
/// - modal: exact for the piecewise linear load. Complex modes of the first-order system; each is carried over a
///   sample in closed form, and its periodic start follows from the response over one turn from rest divided by
///   1 - exp(lambda T). No time step, no truncation.
/// - harmonic_balance: exact Fourier coefficients of the load, one complex solve per harmonic.
/// - newmark: average acceleration from the static position under the first load, until it repeats.
///
/// Shapes above 1e6 times the lowest frequency (massless sections) follow the load without inertia in `modal`.
///
/// @param speed  spin, positive from x to y [rad/s]
/// @return readings over time, times x readings
/// @throws InputError if nothing damps (the periodic response would be unbounded at resonance and undefined), sizes do
///         not fit, or a damper acts where there is no mass; DomainError if a mode grows; ConvergenceError if two
///         modes coincide to rounding (critical damping) or Newmark does not repeat
Matrix periodic_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings,
                         const PeriodicSettings& settings = {});

/// Amplitude q of the response Re(q e^(i Omega t)) to a load Re(F e^(i Omega t)), Omega in [rad/s], any sign.
/// @throws InputError if sizes do not fit; DomainError at an undamped resonance
std::vector<std::complex<double>> harmonic_response(const ShaftSystem& system, double speed, double omega,
                                                    std::span<const std::complex<double>> force);

struct UnbalanceResponse {
    double speed = 0;  ///< [rad/s]
    std::vector<std::complex<double>>
        x;  ///< amplitude per node: x(t) = Re(x e^(i theta)), theta the throw's direction [m]
    std::vector<std::complex<double>> y;
    std::vector<std::complex<double>> bearing_x;  ///< force on every bearing by the shaft, with its damping [N]
    std::vector<std::complex<double>> bearing_y;
};

/// Response to the unbalance of disks and throw, m e omega^2 [cos, sin](theta + angle), at every speed.
/// @throws InputError as check_shaft; DomainError at an undamped critical speed
std::vector<UnbalanceResponse> unbalance_response(const Shaft& shaft, std::span<const double> speeds);

}  // namespace deadpoint::crankshaft
