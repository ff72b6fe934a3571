#pragma once

namespace deadpoint {
struct Linkage;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::drift {
struct ChainDescription;
}

namespace deadpoint::press {

/// The planar linkage of a case: bodies that take part in a joint of kind revolute or slide, joints in the order of
/// `Case::joints`.
/// The slide is that of [mechanism], else that of [chain].
/// @throws InputError if there is no driver, no slide is named, or nothing says where its stroke points
Linkage describe_linkage(const casefile::Case& input);

/// The dimension chain of a case on its meshed machine.
///
/// A joint's centre in a body is fitted on that body's sides of the interfaces that carry the joint: in the ground
/// those marked `seat`, in the other body those marked `journal`, between two moving bodies those with either mark;
/// where no side in the body is marked, all of them. Everything that takes positions of joints (E_BG, slide height,
/// corners, tilt, static opening) reads these sides. A bearing of the crank counts in its play if it has a seat and a
/// journal.
/// @throws InputError if a joint of the chain touches a body nowhere, or no bearing of the crank has both marks
drift::ChainDescription describe_chain(const casefile::Case& input, const Machine& machine, const Linkage& linkage);

}  // namespace deadpoint::press
