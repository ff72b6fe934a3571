#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <string>
#include <vector>

namespace deadpoint {

/// The dimension chain over time, changes since the start [m]. E_SW > 0: the gap between slide and table opens.
struct DriftSeries {
    std::vector<double> time;                  ///< [s], as ThermalHistory::time
    Series bearing_to_ground;                  ///< E_BG
    Series table_to_ground;                    ///< E_WG
    Series crank_to_slide;                     ///< E_CS
    Series clearance;                          ///< E_BC
    Series gap;                                ///< E_SW = E_BG - E_WG - E_CS - E_BC
    std::vector<std::vector<double>> by_part;  ///< [part][step], parts of E_SW; they sum to it
};

}  // namespace deadpoint
