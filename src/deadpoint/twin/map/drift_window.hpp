#pragma once

#include "deadpoint/twin/map/sweep_plan.hpp"

#include <optional>
#include <vector>

/// The ranges of a study's axes within which the drift stays small.
namespace deadpoint::twin {

/// One axis of a grid of steps.
struct WindowAxis {
    std::size_t steps = 0;
    std::vector<double> numbers;  ///< per step; empty: the steps have no order
};

/// A box in a grid: every combination of the chosen steps of each axis.
struct DriftWindow {
    std::size_t points = 0;                       ///< 0: nothing fits
    std::vector<std::vector<std::size_t>> steps;  ///< per axis, in the order of the numbers; empty if nothing fits
    double share = 0;  ///< mean over the axes of the share of the whole range (of the steps, without order)
};

/// The largest box that lies inside: most points, then the largest share, then the one that comes
/// first. On an axis with numbers the steps are neighbours in the order of the numbers; on an axis
/// without order they may be any steps. If there are more than about a million choices of steps,
/// axes without order count as ordered as listed.
///
/// @param inside  per place of the grid, the last axis changing fastest
/// @throws DomainError if `inside` has not one entry per place, or an axis not one number per step
DriftWindow best_window(const std::vector<WindowAxis>& axes, const std::vector<bool>& inside);

/// Drift of one run.
struct PointDrift {
    double largest = 0;  ///< |E_SW| at any time [m]
    double final = 0;    ///< |E_SW| at the end [m]
};

/// True if a drift keeps the limits; false if it is not known.
bool keeps(const DriftLimits& limits, const std::optional<PointDrift>& drift);

/// The best window of a set; nothing if the study has no limits.
/// @param drift  per point; none where the run failed or has no dimension chain
std::optional<DriftWindow> best_window(const SweepStudy& study, std::size_t set, const std::vector<SweepPoint>& points,
                                       const std::vector<std::optional<PointDrift>>& drift);

/// Index of a place in its set's grid, the last axis changing fastest.
std::size_t grid_index(const SweepSet& set, const std::vector<std::size_t>& steps);

}  // namespace deadpoint::twin
