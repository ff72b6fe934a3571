#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace deadpoint::press {
struct CourseSummary;
struct RunSummary;
}  // namespace deadpoint::press

/// The summary of a drift in the style of ISO 230-3. Internal to report/, since it shows the JSON library.
namespace deadpoint::report {

/// For summary.json: the gap, where there is one, and every probe.
nlohmann::ordered_json drift_summary_json(const std::vector<std::string>& probes, const press::RunSummary& summary);

/// The gap in one line that ends with a line break, for the terminal.
std::string drift_summary_line(const press::CourseSummary& gap);

}  // namespace deadpoint::report
