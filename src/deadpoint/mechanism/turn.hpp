#pragma once

#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/mechanism/planar_motion.hpp"

#include <vector>

namespace deadpoint {
struct CycleHistory;
}

namespace deadpoint::mechanism {

struct CycleRequest;

/// Closed positions of a linkage over a turn of the driver, evenly spaced from bottom dead point on. They follow from
/// its geometry alone; a cycle at any speed and force is computed on them.
struct Turn {
    std::vector<PlanarPosition> positions;
};
/// @throws InputError if the linkage is at fault (see PlanarSystem and bottom_dead_point), or there are fewer than four
///         positions
Turn turn_of(const Linkage& linkage, int positions);

/// analyse_cycle() on positions that are known.
/// @param turn  turn_of() the same linkage and CycleRequest::positions
CycleHistory analyse_cycle(const Linkage& linkage, const CycleRequest& request, const Turn& turn);

}  // namespace deadpoint::mechanism
