#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace deadpoint::press {
struct AccuracyReport;
}

/// Internal to report/: the report of a run to a stated accuracy, as text and files.
namespace deadpoint::report {

/// "not reached: ..." or "reached: ...", one line.
std::string accuracy_line(const press::AccuracyReport& accuracy);
/// That line and the table of the meshes, for the terminal.
std::string accuracy_text(const press::AccuracyReport& accuracy);
nlohmann::ordered_json accuracy_json(const press::AccuracyReport& accuracy);
/// accuracy.csv, a row per mesh, and sizes.toml, the cell sizes of the last one as a case file states them.
void write_accuracy_files(const std::filesystem::path& folder, const press::AccuracyReport& accuracy,
                          std::span<const std::string> comments);

}  // namespace deadpoint::report
