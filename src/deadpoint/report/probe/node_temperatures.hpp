#pragma once

#include <vector>

namespace deadpoint {
struct Machine;
}

namespace deadpoint::report {

class ResultFiles;

/// Temperatures of the nodes of a machine at the end of a run on the same mesh [degC], by part and place.
/// @throws InputError if the results hold no fields, or the fields of another mesh
std::vector<double> node_temperatures(const ResultFiles& results, const Machine& machine);

}  // namespace deadpoint::report
