#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/viewer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {

/// The gap between slide and table at one corner of the slide, change since the start.
struct CornerSeries {
    std::string name;  ///< "front left", as Viewer has it
    double x = 0;      ///< place of the corner, to the right of the stroke [m]
    double z = 0;
    Series gap;  ///< [m], > 0 opens
};

/// Parallelism of slide and table.
struct Parallelism {
    std::vector<CornerSeries> corners;  ///< front left, front right, back left, back right
    Series left_right;                  ///< gap on the right less that on the left, over their distance [m/m]
    Series front_back;                  ///< gap at the back less that in front, over their distance [m/m]
    Viewer viewer;                      ///< its left is front x stroke
};

/// A clearance over time.
struct ClearanceSeries {
    enum class Kind { bearing, guide };
    std::string name;
    Kind kind = Kind::bearing;
    Series change;                  ///< since the start, < 0 closes; on the diameter, or of both faces together [m]
    std::optional<double> initial;  ///< at the start, if the case states it [m]
    std::optional<double> used_up;  ///< when initial + change first reaches 0 [s]
};

/// Results of the deformation besides the dimension chain.
struct GapSeries {
    std::optional<Parallelism> parallelism;
    std::vector<ClearanceSeries> clearances;
    std::vector<std::string> left_out;  ///< joints whose clearance cannot be computed, with the reason
    std::optional<Series> force;        ///< change of the force at a fixed die height [N]
    double press_stiffness = 0;         ///< stiffness used for `force` [N/m]
};

}  // namespace deadpoint
