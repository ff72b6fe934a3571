#pragma once

#include "deadpoint/casefile/describe/accuracy.hpp"

#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Estimated mesh error of the requested figure, by part.
namespace deadpoint::full {

struct RunContext;

struct ErrorEstimate {
    /// The largest over times (and probes) of the sum of all parts' magnitudes [m] or [K]; the part
    /// of the probe also has the interpolation error in its cell.
    double total = 0;
    std::vector<double> by_part;  ///< the largest magnitude of each over times (and probes)
};

/// Times at which the error is estimated: an eighth, half and all of the run, and the ends of its segments, six at
/// most.
std::vector<double> estimate_times(const casefile::Case& input);

/// The error of rises or gap at the times of the fields: of the conduction by
/// fem::Model::conduction_errors with the adjoint solution of each probe or of the gap's
/// temperature weights; for the gap also the error of the deformation.
ErrorEstimate estimate_error(const RunContext& run, casefile::Accuracy::Of of);

}  // namespace deadpoint::full
