#pragma once

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct HeatTables;
struct LoadsResult;
struct RunResult;
}  // namespace deadpoint::press

/// Internal to api/: results of the stages in the types of the public headers.
namespace deadpoint {

struct HeatTables;
struct LoadsResult;
struct RunResult;

RunResult public_run(const casefile::Case& input, const press::RunResult& result, std::vector<std::string> warnings,
                     std::string folder);
/// The segment for which loads or laws are asked: the wanted one; for -1 the first in which the press runs, else 0.
/// @param needs_speed  the press must run in some segment
/// @throws InputError if the operation has no such segment
int segment_of(const casefile::Case& input, int wanted, bool needs_speed);

LoadsResult public_loads(const press::LoadsResult& loads);
HeatTables public_tables(const press::HeatTables& tables);

}  // namespace deadpoint
