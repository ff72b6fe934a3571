#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace deadpoint::study {
struct Calibration;
}

/// Internal to report/, since it shows the JSON library.
namespace deadpoint::report {

/// Writes the page of a calibration: what the data determine, every measured curve beside the model before and after,
/// bands, profiles. Curves are thinned to about as many rows as a screen has pixels.
/// @param json  calibration.json  @throws IoError
void write_calibration_page(const std::filesystem::path& file, const study::Calibration& result,
                            const nlohmann::ordered_json& json);

}  // namespace deadpoint::report
