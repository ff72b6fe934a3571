#pragma once

/// How sharp the steps of a run must be for the run to be.
namespace deadpoint {

/// Error that a single time step may make, so that those of a run stay near `time_tolerance` together [K]:
///
///   tolerance min(1, sqrt(tolerance / 0.02 K))
///
/// An error of third order per step adds up to one of second order. With the tolerance itself for each step the error
/// of a run would fall with its power 2/3 only, and be five times the tolerance at 1e-4 K; with its power 3/2 it falls
/// as the tolerance does. At 0.02 K, the default of `numerics.time_tolerance`, the two are the same.
double step_tolerance(double time_tolerance);
/// The time tolerance of steps that may make such an error, the inverse of step_tolerance() [K].
double time_tolerance_of(double step_tolerance);

}  // namespace deadpoint
