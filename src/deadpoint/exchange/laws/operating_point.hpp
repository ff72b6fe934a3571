#pragma once

#include <compare>

namespace deadpoint {

/// Operating point of a press: the key under which loads and duties are shared.
struct OperatingPoint {
    double speed = 0;  ///< of the crank [rad/s]
    double force = 0;  ///< of the process, at its peak [N]
    auto operator<=>(const OperatingPoint&) const = default;
};

}  // namespace deadpoint
