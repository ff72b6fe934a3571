#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <string>
#include <utility>
#include <vector>

namespace deadpoint {

/// The dimension chain over time, changes since the start along the stroke, away from the table [m]. E_SW > 0: the gap
/// between slide and table opens.
struct DriftSeries {
    std::vector<double> time;                  ///< [s], as ThermalHistory::time
    Series bearing_to_ground;                  ///< E_BG
    Series table_to_ground;                    ///< E_WG
    Series crank_to_slide;                     ///< E_CS
    Series clearance;                          ///< E_BC
    Series gap;                                ///< E_SW = E_BG - E_WG - E_CS - E_BC
    Series play;                               ///< what the play of the crank's bearings adds to E_SW
    std::vector<std::vector<double>> by_part;  ///< [part][step], parts of E_SW; they sum to it
};

/// Contributions to the change of the gap until one time, by heat source [m]. A contribution is the
/// change that this heat, or this temperature above the initial one, would make alone, with
/// everything else as in the run. All contributions sum to the gap's change.
struct DriftCauses {
    double time = 0;                                           ///< [s]
    double gap = 0;                                            ///< E_SW
    std::vector<std::pair<std::string, double>> joints;        ///< friction heat
    std::vector<std::pair<std::string, double>> heat_sources;  ///< other heat
    std::vector<std::pair<std::string, double>> surfaces;      ///< of prescribed temperature or flux
    double oil = 0;                                            ///< oil that was not at the initial temperature
    double air = 0;                                            ///< the same of the ambient
    double start = 0;                                          ///< temperatures from which the run started
    double remainder = 0;  ///< remainder: coefficients that depend on temperature, and the error of the solvers
    int fields = 0;        ///< on which the contributions were computed; 0: in all unknowns
    double change = 0;     ///< of a contribution by the last few of these fields: how far one may be off
};

}  // namespace deadpoint
