#pragma once

#include <utility>
#include <vector>

namespace deadpoint {
struct Series;
}

/// Sums of courses over time.
namespace deadpoint::press {

/// Sum of factor times series, values and rates. @param terms  at least one, all over the same times
Series combined(const std::vector<std::pair<double, const Series*>>& terms);

}  // namespace deadpoint::press
