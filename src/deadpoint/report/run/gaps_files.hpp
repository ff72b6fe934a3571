#pragma once

#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct GapSeries;
}
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct PressCompliance;
}

/// Corners of the slide, clearances, force at a fixed die height and the static opening under the process force, in the
/// files and the text of a run.
namespace deadpoint::report {

/// Columns of gaps.csv besides the time.
std::vector<CsvColumn> gap_columns(const GapSeries& gaps, const SeriesSampler& sample);

/// Largest and last values; null if nothing was recorded.
/// @param time  of the steps [s]
nlohmann::ordered_json gaps_json(const GapSeries& gaps, const std::vector<double>& time);

/// A line each for parallelism, clearances and force; empty if nothing was recorded.
std::string gaps_text(const GapSeries& gaps, const std::vector<double>& time);

/// The static opening per kilonewton, and at the force of each segment of the operation that states one.
nlohmann::ordered_json compliance_json(const casefile::Case& input, const press::PressCompliance& compliance);

/// Two lines: stiffness and tilt per kilonewton, and the opening at the operation's largest force.
std::string compliance_text(const casefile::Case& input, const press::PressCompliance& compliance);

}  // namespace deadpoint::report
