#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <vector>

namespace deadpoint {
struct BodyMass;
}

/// Full linkages from one given half.
namespace deadpoint::mechanism {

/// Origin of each body or joint of a full linkage.
struct MirrorOrigin {
    int original = 0;    ///< index in the given linkage
    bool image = false;  ///< at the plane x = 0
};

struct MirroredLinkage {
    Linkage linkage;                   ///< the given bodies and joints with their indices, then the images
    std::vector<MirrorOrigin> bodies;  ///< one per body of the full linkage
    std::vector<MirrorOrigin> joints;  ///< one per joint
    std::vector<int> freed;            ///< joints whose guides_rotation was cleared because the halves hold the body
};

/// Adds the mirror images at the plane x = 0 of all bodies that exist twice.
///
/// An image's name is that of its original with "'" appended. A joint that touches a doubled body is doubled: its image
/// connects the images of its bodies (a single body is its own), with centre and direction reflected. Single bodies
/// must be symmetric to the plane themselves.
///
/// The two halves hold the rotation of a single body if it carries a pair of pins off the plane. A
/// slide that also guides its rotation would constrain it once too often, without a unique
/// reaction; guides_rotation of that slide becomes false, and the joint is listed in `freed`. A
/// body whose pins lie on the plane keeps its guide.
///
/// @param exists_twice  one per body
/// @throws InputError if the sizes differ, the ground, the slide or the driven body is doubled, or a name is taken
MirroredLinkage mirrored(const Linkage& half, const std::vector<bool>& exists_twice);

/// Masses of the full linkage: an image has its original's with the centre reflected. Of a body that exists twice the
/// mass given is that of one.
/// @param masses  one per body of the given linkage
std::vector<BodyMass> mirrored(const std::vector<BodyMass>& masses, const MirroredLinkage& full);

}  // namespace deadpoint::mechanism
