#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/result.hpp"
#include "deadpoint/study/pipeline/heat_tables.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/pipeline/run.hpp"

#include <string>
#include <vector>

/// Internal to api/: results of the stages in the types of the public headers.
namespace deadpoint {

RunResult public_run(const casefile::Case& input, const study::RunResult& result, std::vector<std::string> warnings,
                     std::string folder);
LoadsResult public_loads(const study::LoadsResult& loads);
HeatTables public_tables(const study::HeatTables& tables);

}  // namespace deadpoint
