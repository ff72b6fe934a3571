#pragma once

#include <filesystem>
#include <string>

namespace deadpoint::casefile {
struct Case;
}

/// Whether a reduced press fits itself, its case and its large model. A file with a right checksum
/// may still not be what this program writes.
namespace deadpoint::twin {

struct ReducedPress;

/// What of a press that was read does not fit the rest of it: sizes, indices, names, signs; empty if all does.
/// @param file  from which it was read, for the large model beside it
std::string flaw_of(const ReducedPress& press, const std::filesystem::path& file);

/// What of the machine, the chain and the functionals of a press is not that of a case, whose fixed part it has: names,
/// numbers and order of parts, interfaces, surfaces, probes and other heat; empty if all is.
std::string flaw_for(const casefile::Case& input, const ReducedPress& press);

/// Whether two models are of one press: all but their states and errors agrees.
bool is_same_press(const ReducedPress& press, const ReducedPress& large);

}  // namespace deadpoint::twin
