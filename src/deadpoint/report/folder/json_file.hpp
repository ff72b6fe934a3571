#pragma once

#include "deadpoint/io/write_file.hpp"

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

/// The document in a text. @param name  of its file, for errors, which are those of read_json()
nlohmann::ordered_json parse_json(const std::string& text, const std::filesystem::path& name);

}  // namespace deadpoint::report
