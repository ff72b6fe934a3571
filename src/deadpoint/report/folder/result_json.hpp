#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace deadpoint::report {

class ResultFiles;

/// Reads a JSON document of a result folder, which must be unchanged. Internal to report/, since it
/// shows the JSON library.
/// @return none if the file neither exists nor is listed
/// @throws as read_json() and ResultFiles::read()
std::optional<nlohmann::ordered_json> read_json(const ResultFiles& files, const std::string& name);

}  // namespace deadpoint::report
