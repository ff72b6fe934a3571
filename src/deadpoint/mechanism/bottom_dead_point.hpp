#pragma once

#include "deadpoint/exchange/linkage.hpp"

namespace deadpoint::mechanism {

/// Finds bottom dead point and how the slide moves there when joint centres shift.
///
/// The driver is turned once around in steps of two degrees from the assembled position; the lowest slide position
/// along the stroke direction is then refined to a zero of the slide's velocity (to 1e-12 rad). The weights follow from
/// one solve with the transposed Jacobian of the constraints; their signs are those of BottomDeadPointSensitivity.
/// Where the slide touches the same lowest position twice in a turn, the one nearer to the assembled position counts.
///
/// @throws InputError if the linkage is over- or under-constrained, does not close somewhere in the turn, is singular,
///         does not return to where it started, or its slide does not move
BottomDeadPointSensitivity bottom_dead_point(const Linkage& linkage);

}  // namespace deadpoint::mechanism
