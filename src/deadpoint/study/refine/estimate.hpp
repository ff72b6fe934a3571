#pragma once

#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/study/pipeline/run.hpp"

#include <vector>

/// Internal to study/: how far the mesh of a run is from giving the wanted figure, by part.
namespace deadpoint::study {

struct ErrorEstimate {
    /// The largest over times (and probes) of the sum of all parts' magnitudes [m] or [K]; the part that holds the
    /// probe bears the interpolation in its cell too.
    double total = 0;
    std::vector<double> by_part;  ///< the largest magnitude of each over times (and probes)
};

/// Times at which the error is estimated: an eighth, half and all of the run, and the ends of its segments, six at
/// most.
std::vector<double> estimate_times(const casefile::Case& input);

/// The error of rises or gap at the times of the fields: of the conduction by fem::Model::conduction_errors with the
/// dual of each probe or of the gap's temperature weights, of the gap also that of the deformation.
ErrorEstimate estimate_error(const RunInside& run, casefile::Accuracy::Of of);

}  // namespace deadpoint::study
