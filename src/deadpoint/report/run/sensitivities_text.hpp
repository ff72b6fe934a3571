#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace deadpoint::press {
struct Sensitivities;
}

/// How the figures at the end of a run depend on its coefficients: a file, JSON and a line for the terminal. E_SW is in
/// micrometres.
namespace deadpoint::report {

/// Writes a row per coefficient, strongest first.
/// @throws IoError if the file cannot be written
void write_sensitivities(const std::filesystem::path& path, std::span<const std::string> comments,
                         const press::Sensitivities& sensitivities);

/// The ten strongest.
nlohmann::ordered_json sensitivities_json(const press::Sensitivities& sensitivities);

/// "  most at the end, per tenth of ...", the five strongest, with a line break.
std::string sensitivities_line(const press::Sensitivities& sensitivities);

}  // namespace deadpoint::report
