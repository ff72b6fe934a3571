#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace deadpoint {
struct CsvTable;
}

/// Internal to report/: the main results as plain HTML, for readers whose browser runs no scripts.
namespace deadpoint::report {

/// @param run  an entry of the page's data: summary and loads, if present
std::string run_tables(const nlohmann::ordered_json& run);

/// A table as it is, its numbers with five digits.
std::string table_html(const std::string& caption, const CsvTable& table);

/// @param sweep  sweep.json
/// @param points  sweep.csv
std::string sweep_tables(const nlohmann::ordered_json& sweep, const CsvTable& points);

}  // namespace deadpoint::report
