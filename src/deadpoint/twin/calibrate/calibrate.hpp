#pragma once

#include "deadpoint/twin/calibrate/calibration_result.hpp"
#include "deadpoint/twin/calibrate/other_presses.hpp"

#include <optional>

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct CalibrationFile;
}

/// Calibration of a case on its reduced press.
namespace deadpoint::twin {

struct ReducedPress;

/// Fits the unknowns of a calibration file to its runs.
///
/// Minimises 1/2 |L^-1 (y - f(theta))|^2 + 1/2 |theta / sigma|^2 over all fitted runs, from the prior's centre and from
/// Sobol' points. If the residuals are unlike the stated errors, a slow model error is added to the noise of the
/// curves, and the fit is repeated, so that intervals and bands are as wide as the model is wrong.
///
/// @return nothing after Observer::cancelled()
/// @throws InputError if a parameter has no influence on any measured value, with its place
std::optional<Calibration> calibrate(const casefile::CalibrationFile& file, const ReducedPress& press,
                                     const OtherPresses& others, int threads, Observer& observer);

/// What planned runs can determine, and what candidates would add, by derivatives at the prior's centre.
/// @return nothing after Observer::cancelled()
std::optional<CalibrationPlan> plan_calibration(const casefile::CalibrationFile& file, const ReducedPress& press,
                                                const OtherPresses& others, int threads, Observer& observer);

}  // namespace deadpoint::twin
