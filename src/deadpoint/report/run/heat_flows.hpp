#pragma once

#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <functional>
#include <string>
#include <vector>

namespace deadpoint::press {
struct RunResult;
}

/// Oil circuits, enclosed air and heat that is not friction, in the files and the text of a run. Everything is of the
/// whole press.
namespace deadpoint::report {

/// Interpolates a quantity that is known at the steps to the rows of a table: factor * value +
/// offset.
using Sampler = std::function<std::vector<double>(const std::vector<double>& values, double factor, double offset)>;

void add_heat_flow_columns(std::vector<CsvColumn>& columns, const press::RunResult& result,
                           const SeriesSampler& sample_series, const Sampler& sample);

/// State at the end by circuit, enclosure and source; null where there is none of them.
nlohmann::ordered_json heat_flows_json(const press::RunResult& result);

/// A line per circuit, enclosure and source; empty where there is none.
std::string heat_flows_text(const press::RunResult& result);

}  // namespace deadpoint::report
