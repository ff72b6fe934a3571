#pragma once

#include "deadpoint/casefile/check/findings.hpp"
#include "deadpoint/casefile/describe/case.hpp"

#include <vector>

namespace deadpoint::casefile {

/// Checks every name that refers to something else, and the rules that span sections. Does not look at geometry.
/// Names left empty are passed over: that they are missing is found on reading.
std::vector<Finding> check_references(const Case& c);

}  // namespace deadpoint::casefile
