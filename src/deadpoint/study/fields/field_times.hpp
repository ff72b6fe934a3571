#pragma once

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint
namespace deadpoint::fem {
struct CheckpointHead;
}

/// Internal to study/: when a run needs the fields of the press. Needs no mesh.
namespace deadpoint::study {

/// Times at which fields are kept: in each segment denser after its start, where temperatures change fastest; about 36.
std::vector<double> view_times(const std::vector<HeatSegment>& segments);

/// Times at which a run needs fields, ascending [s].
struct FieldTimes {
    /// @param view  whether the page's view is made @param kept  ascending
    FieldTimes(const HeatProblem& problem, bool view, const std::vector<double>& kept = {});
    /// Of a run that continues from a checkpoint: what that run planned up to there, and what this one plans after it.
    /// The end of the former run stays among the written times.
    /// @throws CaseError if this run writes fields at a time that has passed and was not planned
    void continue_from(const fem::CheckpointHead& former);
    std::vector<double> written;  ///< HeatProblem::field_times
    std::vector<double> viewed;   ///< view_times()
    std::vector<double> kept;     ///< for whoever wants them
    std::vector<double> all;      ///< of these three
};

}  // namespace deadpoint::study
