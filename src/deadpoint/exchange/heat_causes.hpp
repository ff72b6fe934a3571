#pragma once

#include <vector>

namespace deadpoint {

/// Contributions of the heat sources to a functional of the temperature field at one time, in the
/// unit of the functional, with heat, oil and convection coefficients as in the run. They sum to
/// the functional if no convection coefficient depends on temperature.
struct HeatCauses {
    std::vector<double> friction;   ///< per interface: the friction heat that enters there
    std::vector<double> oil;        ///< per interface: oil that is not at the reference temperature
    std::vector<double> surfaces;   ///< per HeatProblem::surfaces: its air, its prescribed temperature, or its flux
    std::vector<double> body_heat;  ///< per HeatProblem::body_heat
    double start = 0;               ///< the temperatures from which the run started
    int fields = 0;                 ///< on which they were computed; 0: in all unknowns
    double change = 0;              ///< of one of them by the last few of these fields: how far they may be off
};

}  // namespace deadpoint
