#pragma once

#include <nlohmann/json.hpp>

namespace deadpoint::twin {
struct Calibration;
struct CalibrationPlan;
}  // namespace deadpoint::twin

/// Internal to report/, since it shows the JSON library.
namespace deadpoint::report {

/// The document calibration.json.
nlohmann::ordered_json calibration_json(const twin::Calibration& result);
/// The document plan.json.
nlohmann::ordered_json plan_json(const twin::CalibrationPlan& plan);

}  // namespace deadpoint::report
