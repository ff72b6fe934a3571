#pragma once

#include "deadpoint/design/morris.hpp"
#include "deadpoint/design/sobol.hpp"
#include "deadpoint/twin/explore/figures.hpp"
#include "deadpoint/twin/explore/varied.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
class Observer;
}

namespace deadpoint::twin {

/// Sensitivity of one figure to all parameters.
struct FigureSensitivity {
    Figure figure;
    design::SobolIndices sobol;                ///< without inputs after a screening
    std::vector<design::MorrisEffect> morris;  ///< per parameter, over its whole range; empty for Sobol' indices
    std::vector<double> bound;                 ///< of the total index, per parameter; empty without gradients
};

struct SensitivityResult {
    std::vector<VariedRange> ranges;
    std::vector<ForwardOutput> outputs;      ///< of the model; figures name them by place
    std::vector<std::size_t> chosen;         ///< outputs that the study asks for
    std::vector<FigureSensitivity> figures;  ///< per chosen output: at the times, at the end, time to warm
    std::vector<FigureSensitivity> course;   ///< at evenly spread times, output by output
    std::size_t runs = 0, failed = 0;
    std::string failure;               ///< reason of the first point that failed
    std::vector<std::string> outside;  ///< coefficients that leave the range of the reduced model at an end of a range
    std::vector<std::vector<double>> points;  ///< per run the values of the ranges; empty unless asked for
    std::vector<std::vector<double>> values;  ///< per run the figures
};

/// Runs the points of a design on a reduced press. A point that fails is left out with its row.
/// @param input    the base case with the settings of the study
/// @param section  as casefile::read_study() leaves it
/// @return nothing if the observer was cancelled
/// @throws InputError if the case is not that press, if a parameter changes what a reduced model cannot, if no output
///         has a name, or if the design is too large for the memory
/// @throws ConvergenceError if more than a tenth of the points fail
std::optional<SensitivityResult> run_sensitivity(casefile::Case input, const ReducedPress& press,
                                                 const casefile::SensitivitySection& section, int threads,
                                                 Observer& observer);

}  // namespace deadpoint::twin
