#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::study {
struct Calibration;
struct CalibrationPlan;
enum class Knowledge;
}  // namespace deadpoint::study

/// Files and texts of a calibration.
namespace deadpoint::report {

/// Writes calibrated.toml, calibration.json, parameters.csv, correlation.csv, combinations.csv, residuals.csv,
/// prediction_RUN.csv of every run, and posterior.csv if samples were drawn. @throws IoError
void write_calibration_files(const std::filesystem::path& folder, const study::Calibration& result);

/// Writes the page of a calibration into its finished folder: what the data determine, every measured curve beside the
/// model before and after, bands, profiles. Curves are thinned to about as many rows as a screen has pixels.
/// @throws IoError
void write_calibration_page(const std::filesystem::path& file, const study::Calibration& result);

/// Writes plan.json, parameters.csv, combinations.csv and candidates.csv. @throws IoError
void write_plan_files(const std::filesystem::path& folder, const study::CalibrationPlan& plan);

/// Writes the page of a plan into its finished folder: what it will determine, and what would help most. @throws
/// IoError
void write_plan_page(const std::filesystem::path& file, const study::CalibrationPlan& plan);

/// What data tell of an unknown or a combination, as all files, the page and the texts say it: "only if the model were
/// right".
std::string_view words_of(study::Knowledge known);

/// What the data say, one sentence each: what they determine, what is prior only, whether the model explains them.
std::vector<std::string> conclusions(const study::Calibration& result);
std::vector<std::string> conclusions(const study::CalibrationPlan& plan);

/// For the terminal: tables and conclusions.
std::string calibration_text(const study::Calibration& result);
std::string calibration_text(const study::CalibrationPlan& plan);

}  // namespace deadpoint::report
