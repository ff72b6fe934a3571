#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;
struct Finding;

/// Pairs of [bonds]: each names parts of the case, two of which at least belong to one body.
std::vector<Finding> check_bonds(const Case& c);

}  // namespace deadpoint::casefile
