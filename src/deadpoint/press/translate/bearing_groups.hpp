#pragma once

#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Which contacts of a joint make one bearing.
namespace deadpoint::press {

/// The contacts of a revolute joint by bearing, in their order: one bearing's contacts share a ring, a part of a body
/// that is `thermal_only`.
std::vector<std::vector<int>> bearings_of(const casefile::Case& input, const Machine& machine,
                                          const std::vector<int>& contacts);

}  // namespace deadpoint::press
