#pragma once

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::study {
struct HeatTables;
struct LoadsResult;
struct RunResult;
}  // namespace deadpoint::study

/// Internal to api/: results of the stages in the types of the public headers.
namespace deadpoint {

struct HeatTables;
struct LoadsResult;
struct RunResult;

RunResult public_run(const casefile::Case& input, const study::RunResult& result, std::vector<std::string> warnings,
                     std::string folder);
LoadsResult public_loads(const study::LoadsResult& loads);
HeatTables public_tables(const study::HeatTables& tables);

}  // namespace deadpoint
