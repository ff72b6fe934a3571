#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// States of a reduced run that its fields are made of.
namespace deadpoint::twin {

/// States of a run at the time of a field.
struct StatesAt {
    double time = 0;  ///< [s]
    std::vector<double> states;
};

/// A run on a reduced model that is over, as far as its fields need it.
struct ReducedStates {
    std::string model;             ///< reduce::mark_of() its terms
    std::size_t count = 0;         ///< number of states
    std::vector<StatesAt> states;  ///< at FieldTimes::all of the run, up to its end
};

}  // namespace deadpoint::twin
