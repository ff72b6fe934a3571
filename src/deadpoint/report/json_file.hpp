#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

namespace deadpoint::report {

/// Writes a JSON document, indented and with its keys in the order in which they were set; complete or absent.
/// Numbers that are not finite become null. Internal to report/, since it shows the JSON library.
/// @throws IoError if the file cannot be written
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& document);

/// Reads a JSON document of a result folder, which may have been changed since. Internal to report/ as well.
/// @return nothing if there is no such file
/// @throws IoError if it cannot be read
/// @throws InputError if it is not JSON, too large, or nested deeper than what is written here
std::optional<nlohmann::ordered_json> read_json(const std::filesystem::path& path);

}  // namespace deadpoint::report
