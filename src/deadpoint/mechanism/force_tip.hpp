#pragma once

#include <vector>

namespace deadpoint {
struct CycleHistory;
}

/// Crank positions that meet the tip of a steep process force.
namespace deadpoint::mechanism {

struct CycleRequest;

/// Places at which a law of the process force has a corner or a maximum.
struct ForceCorners {
    std::vector<double> past_bottom;  ///< angles of the driver [rad]
    std::vector<double> height;       ///< heights of the slide above bottom dead point [m]
};

/// A number of evenly spaced positions over the turn at which a process force is met to 0.1 % of its largest value:
/// that of the history if it does so, else the smallest larger one that has a position near enough to the tip. If none
/// of up to four times as many has, the best of them.
///
/// Heights between the positions follow from the cubic through heights and slide speeds.
///
/// @param history  of the same request, as the law of its process force sees it
/// @throws DomainError if the force is not finite at a corner
int positions_for_tip(const CycleHistory& history, const CycleRequest& request, const ForceCorners& corners);

}  // namespace deadpoint::mechanism
