#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/study/drift_summary.hpp"
#include "deadpoint/study/run.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The results of a run as files and as a short text for the terminal. Heat is that of the whole press throughout.
namespace deadpoint::report {

/// One probe against a published or measured rise.
struct ProbeComparison {
    std::string probe;
    double rise = 0;       ///< at the reference's time, or at the end of a shorter run [K]
    double reference = 0;  ///< [K]
};

/// What the user wants to know first.
struct RunSummary {
    std::vector<ProbeComparison> comparison;
    double rms_residual = 0;  ///< of the comparison [K]
    double rms_null = 0;      ///< of predicting no rise at all [K]
    double largest_gap = 0;   ///< E_SW of largest magnitude [m]
    double largest_gap_time = 0;
    double final_gap = 0;
    std::optional<double> warm_up_time;               ///< |dE_SW/dt| stays below the case's limit from here on [s]
    std::vector<double> time_to_95;                   ///< per probe: reaches 95 % of its final rise for good [s]
    std::optional<study::CourseSummary> gap_course;   ///< of E_SW [m]
    std::vector<study::CourseSummary> probe_courses;  ///< [K]
};
RunSummary summarise(const casefile::Case& input, const study::RunResult& result);

/// Writes into an existing folder: case.toml (resolved), history.csv, contributions.csv, gaps.csv, summary.json,
/// temperatures.svg, drift.svg and contributions.svg; with loads also what write_loads_files writes, with
/// stress also stress.csv, with a view also view.json, with causes of the drift also causes.csv.
/// @param warnings  of the whole run; they stand in every file
/// @throws IoError if a file cannot be written
void write_run_files(const std::filesystem::path& folder, const casefile::Case& input, const Machine& machine,
                     const study::RunResult& result, const std::vector<std::string>& warnings);

/// The short text that ends a run.
std::string run_text(const casefile::Case& input, const study::RunResult& result);

}  // namespace deadpoint::report
