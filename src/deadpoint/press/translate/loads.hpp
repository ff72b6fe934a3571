#pragma once

#include "deadpoint/casefile/describe/case_loads.hpp"
#include "deadpoint/mechanism/process_force.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint::crankshaft {
struct Section;
struct Shaft;
struct ShaftLoads;
}  // namespace deadpoint::crankshaft

namespace deadpoint {

struct Linkage;
struct BodyMass;
struct CycleHistory;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
struct Joint;
struct Segment;
}  // namespace deadpoint::casefile
namespace deadpoint::mechanism {
struct CycleRequest;
struct ForceCorners;
}  // namespace deadpoint::mechanism
namespace deadpoint::tribology {
struct GuideFaces;
}

/// A case in the terms of the stages that compute its loads.
namespace deadpoint::press {

/// Kind of process force: as stated, else "elastic" with a flexible crankshaft or none, "rectangular" with a rigid one.
casefile::ProcessForce::Kind process_force_kind(const casefile::Case& input);

/// The process force of the case as a law for the mechanism.
/// @param peak             of the operation [N]
/// @param throw_at_bottom  direction of the crank throw at bottom dead point [rad]; the case counts crank angles from x
mechanism::ProcessForceLaw describe_process_force(const casefile::Case& input, double peak, double throw_at_bottom);

/// Corners and maximum of that law, between which positions could miss its largest force; none where positions meet it
/// anyhow.
mechanism::ForceCorners describe_corners(const casefile::Case& input, double throw_at_bottom);

/// A warning where the window of a half-sine or rectangular force does not hold bottom dead point.
std::optional<std::string> misplaced_force(const casefile::Case& input, double throw_at_bottom);

/// What drives and loads the linkage: speed (steady, or linear between the points of the table over the angle), process
/// force, positions; without masses.
mechanism::CycleRequest describe_cycle(const casefile::Case& input, const casefile::Segment& segment,
                                       double throw_at_bottom);

/// Joint of the driven body that lies furthest from the driver's axis: the crank pin.
/// @throws InputError if the driven body has no other joint
int crank_pin_joint(const Linkage& linkage);
/// Body that the driver turns.
int driven_body(const Linkage& linkage);

/// The shaft of a case with a [crankshaft].
/// @param crank  mass of the driven body, for the throw's unbalance
crankshaft::Shaft describe_shaft(const casefile::Case& input, const Linkage& linkage, const BodyMass& crank);

/// The same shaft in pieces of at most half their diameter, short enough that a finer division changes the lower
/// natural frequencies by less than 0.1 %.
std::vector<crankshaft::Section> slender_pieces(const std::vector<crankshaft::Section>& sections);

/// What acts on it over the turn: the force of all joints of the driven body but the driver, weight and belt.
crankshaft::ShaftLoads describe_shaft_loads(const casefile::Case& input, const Linkage& linkage,
                                            const CycleHistory& history, double speed);
/// The guide of a slide joint.
tribology::GuideFaces describe_guide(const casefile::Joint& joint);

/// Pull of the belt [N]; 0 without one.
double belt_force(const casefile::Case& input, double speed);

}  // namespace deadpoint::press
