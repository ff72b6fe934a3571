#pragma once

#include <string>
#include <vector>

namespace deadpoint {
struct InterfaceLaw;
struct Machine;
struct OilCourse;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
struct Segment;
}  // namespace deadpoint::casefile

/// Circulating oil of a case in the terms of the heat stage.
namespace deadpoint::press {

/// The circuits in the order of `Case::oil_circuits`. In a half model flow, sump and its loss are halved.
std::vector<OilCourse> oil_circuits(const casefile::Case& input, const Machine& machine);

/// Mass flow times heat capacity of each circuit in a segment, in this model [W/K]; 0 where the oil stands.
std::vector<double> oil_flows(const casefile::Case& input, const Machine& machine, const casefile::Segment& segment);

/// Multiplies the oil coefficients of friction laws named in `Case::oil_with_speed` by their growth.
/// @param speed  of the crank [rad/s]
void grow_with_speed(std::vector<InterfaceLaw>& laws, const casefile::Case& input, double speed);

/// Puts the coefficients against the oil that arrives in place of those against the oil itself: with N = h A / flow of
/// a joint, h is reduced by (1 - exp(-N)) / N, as in a heat exchanger with one side at constant temperature (see
/// surroundings/oil_circuit.hpp). Joints of a circuit that stands give nothing to the oil.
void warm_within_joints(std::vector<InterfaceLaw>& laws, const Machine& machine, const std::vector<OilCourse>& circuits,
                        const std::vector<double>& flows);

}  // namespace deadpoint::press
