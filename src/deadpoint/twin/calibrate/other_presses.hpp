#pragma once

#include <memory>
#include <vector>

namespace deadpoint::twin {

struct ReducedPress;

/// Reduced models of the alternatives of a calibration file, in its order; null: that of the calibration.
using OtherPresses = std::vector<std::shared_ptr<const ReducedPress>>;

}  // namespace deadpoint::twin
