#pragma once

#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint::casefile {

struct Friction;
struct Case;
struct Joint;
}  // namespace deadpoint::casefile

/// Friction laws from sizes, oil and loads.
namespace deadpoint::press {

/// Duties of the bearings or bushes of a joint over the turn.
struct RubbingJoint {
    std::string name;  ///< in the case, of an image that of its original
    const casefile::Joint* joint = nullptr;
    std::vector<tribology::Duty> duties;  ///< one per bearing or bush
};

struct PhysicalHeat {
    HeatLaw heat;                     ///< of all joints together [W]
    std::optional<double> load_part;  ///< of it without the oil [W]; SKF mixes both
    RingHeatLaw ring_heat;            ///< added by a ring temperature difference; empty without `ring_expansion` [W]
};

/// Heat of a friction law other than the calibrated one, without its `scale`.
///
/// Rolling bearings: every duty is one bearing of the stated size; the preload is an axial force on
/// each (in spin, of a pair, an approach of its rows). Pins: diameter and length by the law, else
/// by the joint's element, else the diameter by the joint's interface. Guides: the film's area is
/// that of one joint. The lubricant's density is stated at 15 degC and falls by 7e-4 per kelvin.
///
/// @throws InputError if the law is calibrated, a size is missing or outside its law, or a film's lubricant has no
/// density
PhysicalHeat physical_heat(const casefile::Case& input, const casefile::Friction& friction,
                           const std::vector<RubbingJoint>& joints);

}  // namespace deadpoint::press
