#pragma once

#include "deadpoint/crankshaft/modes.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct JointCycle;
}
namespace deadpoint::press {
struct CrankshaftLoads;
struct LoadsResult;
}  // namespace deadpoint::press

/// Pictures of the loads as SVG documents, over the crank angle with bottom dead point in the middle.
namespace deadpoint::report {

/// Height, speed and acceleration of the slide, one above the other.
std::string slide_motion_svg(const std::string& machine, const press::LoadsResult& loads);
/// Magnitudes of the largest joint forces and the drive torque.
std::string joint_forces_svg(const std::string& machine, const press::LoadsResult& loads);
/// Loads of the seats across and along the stroke; with the flexible model the rigid one is dashed beside it.
/// @throws InputError if there is no crankshaft
std::string bearing_loads_svg(const std::string& machine, const press::LoadsResult& loads);
/// Natural frequencies of the turning crankshaft over its speed, with the line on which they equal the speed.
/// @throws InputError if there is no crankshaft
std::string campbell_svg(const std::string& machine, const press::LoadsResult& loads);
/// The linkage at bottom dead point and at four more crank positions.
std::string linkage_svg(const std::string& machine, const press::LoadsResult& loads);

/// Indices of the joints of the case's own linkage by falling peak force.
std::vector<std::size_t> joints_by_peak(const press::LoadsResult& loads);
/// Largest magnitude of a joint's force over the turn [N].
double peak_force(const JointCycle& joint);
/// Direction of the crank throw at the times of the bearings' histories [rad].
std::vector<double> throw_angles(const press::CrankshaftLoads& shaft);
const char* whirl_name(crankshaft::Whirl whirl);

}  // namespace deadpoint::report
