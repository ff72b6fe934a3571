#pragma once

#include "deadpoint/report/folder/result_files.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace deadpoint::report {

/// Reads a JSON document of a folder of results, just as it was written there. Internal to report/, since it shows the
/// JSON library.
/// @return nothing if there is no such file, nor was
/// @throws as read_json() and ResultFiles::read()
std::optional<nlohmann::ordered_json> read_json(const ResultFiles& files, const std::string& name);

}  // namespace deadpoint::report
