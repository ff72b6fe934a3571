#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace deadpoint {
struct DriftCauses;
}

/// Contributions of the heat sources to the gap: a file, JSON and a line for the terminal, all in
/// micrometres.
namespace deadpoint::report {

/// Writes a row per cause with its kind and name, and a column per time; the rows of a column sum to E_SW.
/// @param causes  of one case, at least one
/// @throws IoError if the file cannot be written
void write_drift_causes(const std::filesystem::path& path, std::span<const std::string> comments,
                        const std::vector<DriftCauses>& causes);

/// A list with an object per time.
nlohmann::ordered_json drift_causes_json(const std::vector<DriftCauses>& causes);

/// "  by cause at the end: ...", the strongest first, and if they are not exact, how far they may be off; each with a
/// line break; empty without causes.
std::string drift_causes_line(const std::vector<DriftCauses>& causes);

}  // namespace deadpoint::report
