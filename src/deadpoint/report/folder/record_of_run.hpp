#pragma once

#include <string>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct RunRecord;
struct RunResult;
}  // namespace deadpoint::press

namespace deadpoint::report {

/// The record of a run that was not written into a folder, with the numbers that read_result() would read from it; of
/// the loads the peaks of the crankshaft's bearings only.
/// @param hash  case_hash() of the case
press::RunRecord record_of(const casefile::Case& input, std::string hash, const press::RunResult& result);

}  // namespace deadpoint::report
