#pragma once

#include "deadpoint/reduce/online/box.hpp"

#include <string>
#include <vector>

namespace deadpoint::twin {

struct SplitProblem;

/// Coefficients of a problem that lie outside the box of a reduced model, each with its value and its range.
/// @param start  temperature at the start, at which laws of friction heat are compared, and those of convection 20 K
/// above
///               it [K]
std::vector<std::string> outside_of(const reduce::Box& box, const SplitProblem& split, double start);

}  // namespace deadpoint::twin
