#pragma once

#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/design/studied_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::twin {
struct FullDesign;
struct OptimiseResult;
}  // namespace deadpoint::twin

/// Files, text and page of a search for an optimum.
namespace deadpoint::report {

struct OptimiseReport : StudiedCase {
    const twin::OptimiseResult& result;
    const twin::FullDesign* full = nullptr;  ///< of the optimum; null: left out
};

/// Writes optimum.toml, search.csv, courses.csv and optimise.json. @throws IoError
void write_optimise_files(const std::filesystem::path& folder, const OptimiseReport& report,
                          const std::vector<std::string>& warnings);

/// The same for the terminal.
std::string optimise_text(const OptimiseReport& report);

/// Writes the page of such a folder; complete or absent. @throws as write_sweep_report()
void write_optimise_page(const std::filesystem::path& file, const std::filesystem::path& folder,
                         IfThere if_there = IfThere::replace);

}  // namespace deadpoint::report
