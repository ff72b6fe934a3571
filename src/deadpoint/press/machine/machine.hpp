#pragma once

#include <string>

namespace deadpoint {
class Mistakes;
struct MachineDescription;
struct SurfaceSelector;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
struct Surface;
}  // namespace deadpoint::casefile

namespace deadpoint::press {

/// What the machine stage needs of a case: its parts, surfaces and the interfaces of its joints.
///
/// Surfaces come in the order of `Case::surfaces`. Interfaces come joint by joint in the order of `Case::joints`, those
/// of a joint as listed, and are named "joint.interface". A side that names a part, with a diameter given, is the
/// cylinder about the joint's centre along z on that part; a side that names a surface is that surface. Interfaces of
/// slides get their travel (press/machine/travel.hpp).
///
/// @param size_scale  scales every cell size, > 0
/// @throws InputError if a name leads nowhere, a selector lacks what its kind needs, or the scale is not positive,
///         or the linkage of a case with travelling slides is at fault
MachineDescription describe_machine(const casefile::Case& input, double size_scale = 1);

/// The same, without the parts, surfaces and interfaces at fault, and without travel where that is.
/// @param mistakes  gets what is wrong with them
MachineDescription describe_machine(const casefile::Case& input, double size_scale, Mistakes& mistakes);

/// The selector of a surface of the case.
/// @param name  for messages
/// @throws InputError if it lacks what its kind needs
SurfaceSelector selector_of(const casefile::Surface& surface, const std::string& name);

}  // namespace deadpoint::press
