#pragma once

#include <vector>

namespace deadpoint {

/// How much of a functional of the temperature field at one time each cause of warming has made, in the unit of the
/// functional, with heat, oil and film coefficients as the run had them. They sum to the functional where no film
/// coefficient follows the temperature.
struct HeatCauses {
    std::vector<double> friction;   ///< per interface: the friction heat that falls there
    std::vector<double> oil;        ///< per interface: oil that is not at the reference temperature
    std::vector<double> surfaces;   ///< per HeatProblem::surfaces: its air, its prescribed temperature, or its flux
    std::vector<double> body_heat;  ///< per HeatProblem::body_heat
    double start = 0;               ///< the temperatures from which the run started
};

}  // namespace deadpoint
