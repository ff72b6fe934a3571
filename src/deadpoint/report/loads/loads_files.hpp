#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint::casefile {
struct Case;
}

/// The loads of a case as files and as a short text for the terminal.
namespace deadpoint::report {

/// Writes into an existing folder: loads.json, motion.json, joints.csv, slide.svg, joints.svg, linkage.svg, and with a
/// crankshaft bearings.csv, campbell.csv, bearings.svg and campbell.svg.
/// @param warnings  of the whole run; they stand in every file
/// @throws IoError if a file cannot be written
void write_loads_files(const std::filesystem::path& folder, const casefile::Case& input,
                       const press::LoadsResult& loads, const std::vector<std::string>& warnings);

/// The tables that end `deadpoint loads`.
std::string loads_text(const casefile::Case& input, const press::LoadsResult& loads);
/// One line for `deadpoint run`.
std::string loads_line(const press::LoadsResult& loads);
/// What `deadpoint check` shows of a case without parts: its bodies, joints and operation.
std::string linkage_plan_text(const casefile::Case& input);

}  // namespace deadpoint::report
