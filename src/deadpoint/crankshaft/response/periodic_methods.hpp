#pragma once

/// The methods behind periodic_response; arguments as checked there.
namespace deadpoint::crankshaft {

struct Matrix;

struct PeriodicLoad;
struct PeriodicSettings;
struct Readings;
struct ShaftSystem;

/// Exact Fourier coefficients of the piecewise linear load, discrete ones times (sin(a) / a)^2 with a = pi k / N.
/// @throws InputError if the number of harmonics is negative
Matrix harmonic_balance_response(const ShaftSystem& system, double speed, const PeriodicLoad& load,
                                 const Readings& readings, const PeriodicSettings& settings);

/// Average acceleration (beta 1/4, gamma 1/2).
/// @throws InputError if steps or turns are not positive; ConvergenceError if the motion does not repeat
Matrix newmark_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings,
                        const PeriodicSettings& settings);

}  // namespace deadpoint::crankshaft
