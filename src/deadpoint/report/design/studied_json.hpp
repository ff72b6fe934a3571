#pragma once

#include "deadpoint/report/folder/json_file.hpp"

#include <cmath>
#include <string>
#include <vector>

/// Internal to report/design, since it shows the JSON library.
namespace deadpoint::report {

struct StudiedCase;

inline nlohmann::ordered_json number_or_null(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// The first keys of a study's JSON file.
nlohmann::ordered_json json_of(const StudiedCase& studied, const std::vector<std::string>& warnings);

}  // namespace deadpoint::report
