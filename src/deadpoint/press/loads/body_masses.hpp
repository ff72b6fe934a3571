#pragma once

#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/warning.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct Linkage;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Mass, centre of mass and inertia of the linkage's bodies, as stated or from their meshed parts.
namespace deadpoint::press {

/// Mass of the parts of a body, by MeshPart::moments.
///
/// In a half model a body that is not marked `mirror` counts with its image at x = 0, a mirrored
/// body counts alone.
/// @return mass 0 if no part belongs to the body
BodyMass mass_of_parts(const casefile::Case& input, const Machine& machine, const std::string& body);

/// True if the parts must be meshed before the loads: a body of the linkage that has parts lacks
/// mass or centre, or lacks the inertia that its rotation needs.
bool masses_need_parts(const casefile::Case& input, const Linkage& linkage);

struct BodyMasses {
    std::vector<BodyMass> values;  ///< as in Linkage::bodies
    std::vector<std::string>
        origins;  ///< "stated", "parts", "stated and parts", "slender rod" for the inertia; ground: ""
    std::vector<Warning> warnings;
};

/// Masses of a case's own linkage (without images). Values that the case states take precedence;
/// the rest follows from the parts, the inertia scaled to a stated mass; without parts the inertia
/// is that of a slender rod between the body's joint centres that lie furthest apart, m l^2 / 12.
///
/// @param machine  may be null: no parts
/// @throws InputError if a body has neither parts nor a stated mass and centre
BodyMasses describe_masses(const casefile::Case& input, const Linkage& linkage, const Machine* machine);

}  // namespace deadpoint::press
