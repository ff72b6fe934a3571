#pragma once

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

/// When a run needs the fields of the press. Needs no mesh.
namespace deadpoint::press {

/// Times at which fields are kept: in each segment denser after its start, where temperatures change fastest; about 36.
std::vector<double> view_times(const std::vector<HeatSegment>& segments);

/// Times at which a run needs fields, ascending [s].
struct FieldTimes {
    /// @param view  whether the page's view is made @param kept  ascending
    FieldTimes(const HeatProblem& problem, bool view, const std::vector<double>& kept = {});
    /// For a run that continues another one: keeps what that run planned up to the time reached, and what this one
    /// plans after it. The end of the former run stays among the written times.
    /// @param reached         by the former run [s]
    /// @param former_written  all times that the former run planned to write
    /// @param former_viewed   all times that it planned to view
    /// @throws CaseError if this run writes fields at a time that has passed and was not planned
    void continue_from(double reached, const std::vector<double>& former_written, std::vector<double> former_viewed);
    std::vector<double> written;  ///< HeatProblem::field_times
    std::vector<double> viewed;   ///< view_times()
    std::vector<double> kept;     ///< for whoever wants them
    std::vector<double> all;      ///< of these three
};

}  // namespace deadpoint::press
