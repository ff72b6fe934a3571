#pragma once

#include "deadpoint/core/write_file.hpp"
#include "deadpoint/report/result_files.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

namespace deadpoint::report {

/// Writes a JSON document, indented and with its keys in the order in which they were set; complete or absent.
/// Numbers that are not finite become null. Internal to report/, since it shows the JSON library.
/// @throws IoError if the file cannot be written
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& document,
                IfThere if_there = IfThere::replace);

/// Reads a JSON document that deadpoint wrote. Internal to report/ as well.
/// @return nothing if there is no such file
/// @throws IoError if it cannot be read
/// @throws InputError if it is not JSON, too large, or nested deeper than what is written here
std::optional<nlohmann::ordered_json> read_json(const std::filesystem::path& path);

/// The same from a folder of results, and just as it was written there.
/// @throws as ResultFiles::read() besides
std::optional<nlohmann::ordered_json> read_json(const ResultFiles& files, const std::string& name);

}  // namespace deadpoint::report
