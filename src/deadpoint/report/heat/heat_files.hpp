#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::press {
struct HeatTables;
}

namespace deadpoint::casefile {
struct Case;
}

/// The tables of friction heat, contact conductance and convection as files and as a short text for
/// the terminal.
namespace deadpoint::report {

/// Writes into an existing folder: heat.json, joint_heat.csv, conductances.csv and films.csv;
/// without interfaces or convection, their file has no rows.
/// @param warnings  of the whole run; they stand in every file
/// @throws IoError if a file cannot be written
void write_heat_files(const std::filesystem::path& folder, const casefile::Case& input, const press::HeatTables& tables,
                      const std::vector<std::string>& warnings);

/// The tables that end `deadpoint heat`.
std::string heat_text(const casefile::Case& input, const press::HeatTables& tables);

}  // namespace deadpoint::report
