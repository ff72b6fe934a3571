#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;

struct Finding;

/// Surfaces of enclosures: each faces at most one enclosure, and has a `film` without an ambient of
/// its own. Skips surfaces that the case does not have.
std::vector<Finding> check_enclosures(const Case& c);

}  // namespace deadpoint::casefile
