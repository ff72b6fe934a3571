#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;
struct Finding;

/// Checks every name that refers to something else, and the rules that span sections. It does not
/// check geometry. It skips empty names, since reading reports missing names.
std::vector<Finding> check_references(const Case& c);

}  // namespace deadpoint::casefile
