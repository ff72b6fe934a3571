#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace deadpoint::report {

/// Writes a JSON document, indented and with its keys in the order in which they were set; complete or absent.
/// Numbers that are not finite become null. Internal to report/, since it shows the JSON library.
/// @throws IoError if the file cannot be written
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& document);

}  // namespace deadpoint::report
