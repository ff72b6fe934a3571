#pragma once

#include <vector>

namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint {

class Observer;
struct HeatProblem;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::press {

class FrictionLaws;

/// Order of the elements of every part of the machine.
std::vector<int> describe_orders(const casefile::Case& input, const Machine& machine);

/// Corners of cells in parts of either order.
struct CornerCount {
    long long first_order = 0;
    long long second_order = 0;
    /// Number of unknowns of the heat, about: a second-order mesh has eight for each corner.
    [[nodiscard]] long long unknowns() const { return first_order + 8 * second_order; }
};
CornerCount count_corners(const casefile::Case& input, const Machine& machine);

/// The heat problem of a case: interfaces in the order of the machine's, sources in the order of `Case::friction`.
///
/// A probe beyond the symmetry plane of a half model stands for its mirror image. Warns about friction that no joint
/// uses, about process forces, where calibrated heat does not follow them, and about conductances outside their law's
/// tested range. Conductances hold for the whole run, at the speed of the first segment in which the press runs.
///
/// @param loads  for contact pressures and speeds of bodies that the case leaves out; may be null
HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads = nullptr);
/// The same with friction laws that have computed loads already.
HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads, FrictionLaws& friction);

}  // namespace deadpoint::press
