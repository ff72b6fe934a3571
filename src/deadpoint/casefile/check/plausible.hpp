#pragma once

#include <vector>

namespace deadpoint::casefile {

struct Case;
struct Finding;

/// Warns of values that can be computed with but are not meant, since no press has them: another decade, a radius for
/// a diameter, kelvin for degrees Celsius, radians for degrees. Each bound is stated with its reason where it is used.
std::vector<Finding> check_values(const Case& c);

}  // namespace deadpoint::casefile
