#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
struct Segment;
}  // namespace deadpoint::casefile

/// Enclosed air of a case in the terms of the heat stage.
namespace deadpoint::press {

/// The enclosures in the order of `Case::enclosures`. In a half model capacity and exchange are halved. Air has
/// 1.2 kg/m3 and 1006 J/kg/K (dry, 20 degC, sea level), also for its changes per hour.
std::vector<Enclosure> enclosures(const casefile::Case& input, const Machine& machine);

/// Index of the enclosure that a surface faces, or -1.
int enclosure_of(const casefile::Case& input, const std::string& surface);

/// Radiation among the surfaces of each enclosure, of those whose film states an emissivity. @param surfaces  of the
/// heat problem, with their enclosures
std::vector<RadiantRoom> radiation_inside(const std::vector<SurfaceCondition>& surfaces, const Machine& machine);

/// Heat into each enclosure's air in a segment, in this model [W].
std::vector<TimeCourse> enclosure_power(const casefile::Case& input, const Machine& machine,
                                        const casefile::Segment& segment);

}  // namespace deadpoint::press
