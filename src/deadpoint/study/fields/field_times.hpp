#pragma once

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

/// Internal to study/: when a run needs the fields of the press. Needs no mesh.
namespace deadpoint::study {

/// Times at which fields are kept: in each segment denser after its start, where temperatures change fastest; about 36.
std::vector<double> view_times(const std::vector<HeatSegment>& segments);

/// Times at which a run needs fields, ascending [s].
struct FieldTimes {
    /// @param view  whether the page's view is made @param kept  ascending
    FieldTimes(const HeatProblem& problem, bool view, const std::vector<double>& kept = {});
    std::vector<double> written;  ///< HeatProblem::field_times
    std::vector<double> viewed;   ///< view_times()
    std::vector<double> kept;     ///< for whoever wants them
    std::vector<double> all;      ///< of these three
};

}  // namespace deadpoint::study
