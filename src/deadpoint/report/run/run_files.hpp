#pragma once

#include "deadpoint/report/tables/csv.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::press {
struct RunResult;
}

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// The results of a run as files. Heat is that of the whole press throughout.
namespace deadpoint::report {

/// A table of a run by the name of its file.
struct RunTable {
    std::string file;
    std::vector<CsvColumn> columns;
};

/// Lines for the head of every result file: version, case and hash, warnings.
std::vector<std::string> file_comments(const casefile::Case& input, const std::vector<std::string>& warnings);
/// What a run computed over its time: history.csv, and where the case has a dimension chain contributions.csv and
/// gaps.csv.
std::vector<RunTable> course_tables(const casefile::Case& input, const press::RunResult& result);
/// The text of summary.json, in one line.
std::string summary_text(const casefile::Case& input, const Machine& machine, const press::RunResult& result,
                         const std::vector<std::string>& warnings);

/// Writes into an existing folder: case.toml (resolved), history.csv, contributions.csv, gaps.csv, summary.json,
/// temperatures.svg, drift.svg and contributions.svg; with loads also what write_loads_files writes, with
/// stress also stress.csv, with a view also view.json, with causes of the drift also causes.csv,
/// with sensitivities also sensitivities.csv.
/// @param warnings  of the whole run; they stand in every file
/// @throws IoError if a file cannot be written
void write_run_files(const std::filesystem::path& folder, const casefile::Case& input, const Machine& machine,
                     const press::RunResult& result, const std::vector<std::string>& warnings);

}  // namespace deadpoint::report
