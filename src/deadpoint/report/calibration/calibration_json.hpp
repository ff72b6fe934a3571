#pragma once

#include <nlohmann/json.hpp>

namespace deadpoint::study {
struct Calibration;
struct CalibrationPlan;
}  // namespace deadpoint::study

/// Internal to report/, since it shows the JSON library.
namespace deadpoint::report {

/// The document calibration.json.
nlohmann::ordered_json calibration_json(const study::Calibration& result);
/// The document plan.json.
nlohmann::ordered_json plan_json(const study::CalibrationPlan& plan);

}  // namespace deadpoint::report
