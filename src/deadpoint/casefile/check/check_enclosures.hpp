#pragma once

#include "deadpoint/casefile/check/findings.hpp"

namespace deadpoint::casefile {

/// Surfaces of enclosures: each faces one enclosure at most, and has a film that leaves its air to the enclosure.
/// Passes over surfaces that the case does not have.
std::vector<Finding> check_enclosures(const Case& c);

}  // namespace deadpoint::casefile
