#pragma once

#include "deadpoint/casefile/check/findings.hpp"

namespace deadpoint::casefile {

/// Foundation, preload, and what stress is asked for.
std::vector<Finding> check_elastic(const Case& c);

}  // namespace deadpoint::casefile
