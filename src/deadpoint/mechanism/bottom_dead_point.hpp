#pragma once

#include <vector>

namespace deadpoint {
struct BottomDeadPointSensitivity;
struct LengthSensitivity;
struct Linkage;
}  // namespace deadpoint

namespace deadpoint::mechanism {

/// Finds bottom dead point and the motion of the slide there when joint centres shift.
///
/// The driver is turned once around in steps of two degrees from the assembled position; the lowest slide position
/// along the stroke direction is then refined to a zero of the slide's velocity (to 1e-12 rad). The weights follow from
/// one solve with the transposed Jacobian of the constraints; their signs are those of BottomDeadPointSensitivity.
/// Where the slide touches the same lowest position twice in a turn, the one nearer to the assembled position counts.
/// The angle is within half a turn of the assembled position, and the poses are those reached by turning that way.
///
/// @throws InputError if the linkage is over- or under-constrained, does not close somewhere in the turn, is singular,
///         does not return to where it started, or its slide does not move
BottomDeadPointSensitivity bottom_dead_point(const Linkage& linkage);

/// Motion of the slide at bottom dead point due to a change of the distance between two joint
/// centres of one body, driver held: d(height)/d(length) = +-dot(weight of `to`, direction from
/// `from` to `to`), where the centre `to` moves away from `from` in the body while the body's other
/// centres stay.
///
/// A body with two joints gives one entry; one with more, and the ground, gives one for each order of the two, since
/// it then matters which of them stays. Pairs whose centres coincide are left out. For a slide joint only the shift
/// across its travel counts.
///
/// @param bottom  of the same linkage
std::vector<LengthSensitivity> length_sensitivities(const Linkage& linkage, const BottomDeadPointSensitivity& bottom);

}  // namespace deadpoint::mechanism
