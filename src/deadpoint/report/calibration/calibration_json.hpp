#pragma once

#include <nlohmann/json.hpp>

namespace deadpoint::study {
struct Calibration;
}

/// Internal to report/, since it shows the JSON library.
namespace deadpoint::report {

/// The document calibration.json.
nlohmann::ordered_json calibration_json(const study::Calibration& result);

}  // namespace deadpoint::report
