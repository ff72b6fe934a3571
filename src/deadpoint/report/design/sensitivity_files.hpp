#pragma once

#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/design/studied_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::twin {
struct SensitivityResult;
}

/// Files, text and page of a study of sensitivity.
namespace deadpoint::report {

/// A study that was computed.
struct SensitivityReport : StudiedCase {
    const twin::SensitivityResult& result;
};

/// Writes indices.csv, indices_over_time.csv, samples.csv if asked for, and sensitivity.json. @throws IoError
void write_sensitivity_files(const std::filesystem::path& folder, const SensitivityReport& report,
                             const std::vector<std::string>& warnings);

/// The same for the terminal: per figure the parameters that matter, strongest first.
std::string sensitivity_text(const SensitivityReport& report);

/// Figures whose indices the points do not tell, as warnings: a band of a total index is wider than one, since some
/// points lie far off, as where a time to warm jumps.
std::vector<std::string> vague_figures(const twin::SensitivityResult& result);

/// Writes the page of such a folder; complete or absent. @throws as write_sweep_report()
void write_sensitivity_page(const std::filesystem::path& file, const std::filesystem::path& folder,
                            IfThere if_there = IfThere::replace);

}  // namespace deadpoint::report
