#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::twin {
struct SweepPoint;
struct SweepStudy;
}  // namespace deadpoint::twin

/// A study of many runs as files and as text for the terminal.
namespace deadpoint::report {

struct SweepResult;

/// Writes into an existing folder: sweep.csv with a row for each place of each set, sweep.json with the plan, the
/// figures and the windows, and the charts of each set (report/sweep/sweep_charts.hpp). Files that stand there are
/// replaced.
/// @param warnings  of the study; they stand in every file
/// @throws IoError if a file cannot be written
void write_sweep_files(const std::filesystem::path& folder, const SweepResult& result,
                       const std::vector<std::string>& warnings = {});

/// What will be computed: sets, axes, number of distinct points and what they share; ends with a line break.
std::string sweep_plan_text(const twin::SweepStudy& study, const std::vector<twin::SweepPoint>& points);

/// The table of all places and the window of each set; ends with a line break.
std::string sweep_text(const SweepResult& result);

}  // namespace deadpoint::report
