#pragma once

#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/viewer.hpp"

#include <variant>
#include <vector>

/// The directions of a case: of gravity, of the stroke, and those that have names.
namespace deadpoint::casefile {

struct Case;

inline constexpr double aligned = 1e-6;  ///< directions whose angle has a smaller sine are the same

/// Unit direction of the slide's stroke, from the table towards the slide:
/// `mechanism.stroke_direction`; without it along the guide that holds the slide on the ground,
/// against gravity; without such a guide straight against gravity. Returns a finding if these are
/// missing or contradict each other.
std::variant<Vec2, Finding> find_stroke_direction(const Case& c);

/// The same for a case that was checked.
/// @throws InputError with that finding's message
Vec2 stroke_direction(const Case& c);

/// Gravity in the plane of the linkage, 9.81 m/s2 along `machine.gravity_direction` [m/s2].
Vec2 plane_gravity(const Case& c);

/// Front, left and up of `machine`: `up` is stated or the axis most against gravity; `front` is stated or up x left
/// (the inverse of left = front x up) or, with neither, z where up is y. Returns a finding if they do not fit each
/// other, gravity or the stroke.
std::variant<Viewer, Finding> find_viewer(const Case& c);

/// The same for a case that was checked.
/// @throws InputError with that finding's message
Viewer viewer_of(const Case& c);

/// Checks stroke, gravity and the named directions, also against a half model or bodies with mirror images.
std::vector<Finding> check_directions(const Case& c);

}  // namespace deadpoint::casefile
