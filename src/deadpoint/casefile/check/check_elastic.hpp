#pragma once

#include "deadpoint/casefile/check/findings.hpp"

namespace deadpoint::casefile {

/// Checks foundation, preload, and the names in output.stress.
std::vector<Finding> check_elastic(const Case& c);

}  // namespace deadpoint::casefile
