#pragma once

/// Error tolerance of time steps for a given error of the run.
namespace deadpoint {

/// Allowed error of a single time step, so that the accumulated error of a run stays near
/// `time_tolerance` [K]:
///
///   tolerance min(1, sqrt(tolerance / 0.02 K))
///
/// An error of third order per step adds up to one of second order. If each step used the tolerance
/// itself, the error of a run would fall only with its power 2/3, and would be five times the
/// tolerance at 1e-4 K. With the power 3/2 the error of a run is proportional to the tolerance. At
/// 0.02 K, the default of `numerics.time_tolerance`, the two are the same.
double step_tolerance(double time_tolerance);
/// The time tolerance that allows this error of a step [K]; the inverse of step_tolerance().
double time_tolerance_of(double step_tolerance);

}  // namespace deadpoint
