#pragma once

#include "deadpoint/press/result/sensitivities.hpp"

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::twin {

struct ReducedPress;

/// The sensitivities of a run of a case on its reduced model, at its end: by every coefficient of the model's box, and
/// by speed and process force of the whole operation.
///
/// Coefficients of the heat balance count by the derivatives of the time steps (reduce/sensitivity). Speed and force
/// act through the loads, laws and films: these are computed at 0.99 and 1.01 of their value, and the run is derived
/// along the difference. The play of the crank's bearings counts as at the end of the run.
/// @throws InputError, CaseError as run_reduced(), whose checks must have passed
press::Sensitivities run_sensitivities(const casefile::Case& input, const ReducedPress& press, Observer& observer);

}  // namespace deadpoint::twin
