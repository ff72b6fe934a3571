#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::twin {
struct Calibration;
struct CalibrationPlan;
enum class Knowledge;
}  // namespace deadpoint::twin

/// Files and texts of a calibration.
namespace deadpoint::report {

/// Writes calibrated.toml, calibration.json, parameters.csv, correlation.csv, combinations.csv, residuals.csv,
/// prediction_RUN.csv of every run, and posterior.csv if samples were drawn. @throws IoError
void write_calibration_files(const std::filesystem::path& folder, const twin::Calibration& result);

/// Writes the page of a calibration into its finished folder: what the data determine, every measured curve beside the
/// model before and after, bands, profiles. Curves are thinned to about as many rows as a screen has pixels.
/// @throws IoError
void write_calibration_page(const std::filesystem::path& file, const twin::Calibration& result);

/// Writes plan.json, parameters.csv, combinations.csv and candidates.csv. @throws IoError
void write_plan_files(const std::filesystem::path& folder, const twin::CalibrationPlan& plan);

/// Writes the page of a plan into its finished folder: what it will determine, and what would help most. @throws
/// IoError
void write_plan_page(const std::filesystem::path& file, const twin::CalibrationPlan& plan);

/// What data tell of an unknown or a combination, as all files, the page and the texts say it: "only if the model were
/// right".
std::string_view words_of(twin::Knowledge known);

/// What the data say, one sentence each: what they determine, what is prior only, whether the model explains them.
std::vector<std::string> conclusions(const twin::Calibration& result);
std::vector<std::string> conclusions(const twin::CalibrationPlan& plan);

/// For the terminal: tables and conclusions.
std::string calibration_text(const twin::Calibration& result);
std::string calibration_text(const twin::CalibrationPlan& plan);

}  // namespace deadpoint::report
