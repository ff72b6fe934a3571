#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What a run on a reduced model says of its error.
namespace deadpoint::press {

/// The error of a model of some size.
struct StatedError {
    std::string of;          ///< "anywhere in the box, to the large model"
    double temperature = 0;  ///< largest, of probes and sides of joints, after the first minute [K]
    double gap = 0;          ///< the same of E_SW [m]
};

/// The error of a model of another number of states, anywhere in the box, to the large model.
struct ErrorOfSize {
    std::size_t states = 0;
    double temperature = 0;  ///< [K]
    double gap = 0;          ///< [m]
};

/// Bounds of the difference to the full model at the end of the run, both by implicit Euler steps.
struct Certified {
    std::string refused;                                 ///< why there are none, or empty
    std::optional<double> gap;                           ///< of E_SW, where the case has a dimension chain [m]
    std::vector<std::pair<std::string, double>> probes;  ///< [K]
};

struct ReducedResult {
    std::string file;  ///< of the model
    std::size_t states = 0;
    std::vector<StatedError> errors;      ///< as measured when the model was built
    std::optional<StatedError> estimate;  ///< of this run: the large model less this one
    std::optional<StatedError> full_run;  ///< of this run: a full run less this one, where one was asked for
    std::optional<Certified> certified;   ///< if the run was to be certified
    std::vector<std::string> outside;     ///< coefficients outside the range for which it was built
};

}  // namespace deadpoint::press
