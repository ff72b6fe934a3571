#pragma once

#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/shaft/matrix.hpp"

/// Forced vibration of the shaft that repeats every turn.
namespace deadpoint::crankshaft {

struct PeriodicLoad;
struct PeriodicSettings;
struct Readings;
struct ShaftSystem;

/// Periodic response of  M q'' + (C + C_modal - omega G) q' + K q = F(t)  at the times of the load.
///
/// C_modal gives every mode of M, K (symmetric part) the ratio zeta = system.modal_damping: C_modal = K X diag(2 zeta /
/// omega_i^3) X^T K with X^T K X = diag(omega_i^2), X^T M X = 1. Methods:
/// - modal: exact for the piecewise linear load. Complex modes of the first-order system; each is
/// integrated over a sample in closed form, and its periodic start is the response over one turn
/// from rest divided by 1 - exp(lambda T). There is no error of a time step or of truncation.
/// - harmonic_balance: exact Fourier coefficients of the load, one complex solve per harmonic.
/// - newmark: average acceleration from the static position under the first load, until it repeats.
///
/// Shapes above 1e6 times the fifth lowest frequency (massless sections) follow the load without inertia in `modal`.
///
/// @param speed  spin, positive from x to y [rad/s]
/// @return readings over time, times x readings
/// @throws InputError if there is no damping (the periodic response would be unbounded at resonance
///         and undefined), sizes do not fit, or a damper acts where there is no mass; DomainError
///         if a mode grows; ConvergenceError if two modes coincide to rounding (critical damping)
///         or Newmark does not repeat
Matrix periodic_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings,
                         const PeriodicSettings& settings = {});

}  // namespace deadpoint::crankshaft
