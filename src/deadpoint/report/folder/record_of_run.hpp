#pragma once

#include <string>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::study {
struct RunRecord;
struct RunResult;
}  // namespace deadpoint::study

namespace deadpoint::report {

/// The record of a run that was not written into a folder, with the numbers that read_result() would read from it; of
/// the loads the peaks of the crankshaft's bearings only.
/// @param hash  case_hash() of the case
study::RunRecord record_of(const casefile::Case& input, std::string hash, const study::RunResult& result);

}  // namespace deadpoint::report
