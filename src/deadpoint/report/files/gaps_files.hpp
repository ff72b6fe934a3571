#pragma once

#include "deadpoint/report/folder/csv.hpp"
#include "deadpoint/report/folder/json_file.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct GapSeries;
}

/// Corners of the slide, clearances and force at a fixed die height, in the files and the text of a run.
namespace deadpoint::report {

/// Columns of gaps.csv besides the time.
std::vector<CsvColumn> gap_columns(const GapSeries& gaps, const SeriesSampler& sample);

/// Largest and last values; null if nothing was recorded.
/// @param time  of the steps [s]
nlohmann::ordered_json gaps_json(const GapSeries& gaps, const std::vector<double>& time);

/// A line each for parallelism, clearances and force; empty if nothing was recorded.
std::string gaps_text(const GapSeries& gaps, const std::vector<double>& time);

}  // namespace deadpoint::report
