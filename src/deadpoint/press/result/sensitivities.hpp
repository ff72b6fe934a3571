#pragma once

#include <string>
#include <vector>

/// How a run's figures at its end depend on its coefficients.
namespace deadpoint::press {

/// A coefficient, and the derivatives by it.
struct Sensitivity {
    std::string coefficient;          ///< key of the case, as in the ranges of a reduced model
    double value = 0;                 ///< in the first segment; 1 for a factor on several values [unit]
    std::string unit;                 ///< of the value; empty: a factor
    double change = 0;                ///< a tenth of the value, or 1 K [unit]
    double gap = 0;                   ///< derivative of E_SW [m per unit]
    std::vector<double> temperature;  ///< derivative of each probe [K per unit]
};

struct Sensitivities {
    double time = 0;  ///< [s]
    bool has_gap = false;
    std::vector<std::string> probes;
    std::vector<Sensitivity> of;  ///< strongest first: E_SW by the change, or the probes without a chain
};

}  // namespace deadpoint::press
