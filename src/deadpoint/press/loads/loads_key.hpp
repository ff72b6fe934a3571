#pragma once

#include "deadpoint/exchange/laws/operating_point.hpp"

namespace deadpoint::press {

/// Conditions for which loads are computed.
struct LoadsKey {
    OperatingPoint at;
    bool at_reference = false;  ///< of a calibrated law: with the flexible crankshaft
    double stiffness = 0;       ///< of its bearings at the reference [N/m]; 0: as the case has them
    auto operator<=>(const LoadsKey&) const = default;
};

}  // namespace deadpoint::press
