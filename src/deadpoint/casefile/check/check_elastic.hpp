#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;

struct Finding;

/// Checks foundation, preload, and the names in output.stress.
std::vector<Finding> check_elastic(const Case& c);

}  // namespace deadpoint::casefile
