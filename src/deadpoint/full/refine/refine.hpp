#pragma once

#include "deadpoint/press/result/run_result.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace deadpoint {
class Observer;
}  // namespace deadpoint

namespace deadpoint::casefile {
struct Case;
}  // namespace deadpoint::casefile

/// Runs with finer parts until the requested figure no longer changes.
namespace deadpoint::full {

class Press;
struct RunOptions;

struct PartError {
    double error = 0;    ///< its share, of whatever unit, >= 0
    double cells = 0;    ///< > 0
    double order = 2;    ///< the error falls as size^order
    bool fixed = false;  ///< cannot be refined
};

/// Factors on the cell sizes of the parts that bring the sum of their errors down to a target with the fewest cells:
/// least sum of n_p f_p^-3 with sum of e_p f_p^order = target, hence f_p ~ (n_p / (order e_p))^(1 / (order + 3)), held
/// between `least` and 1. Factors above 0.93 become 1: those parts keep their meshes.
/// @param most_cells  a weaker target is used if there would be more cells
std::vector<double> size_factors(const std::vector<PartError>& parts, double target, double least, double most_cells);

struct RefinedRun {
    std::unique_ptr<Press>
        press;  ///< of the case with the sizes of all parts and the time steps as used, without its accuracy
    press::RunResult result;
};

/// Options of the last run, of the refined case.
using OptionsOfLast = std::function<RunOptions(const casefile::Case&)>;

/// Computes a case to its `numerics.accuracy`, stated in press/result/accuracy.hpp and
/// docs/theory.md. The result's `accuracy` reports the meshes and whether the accuracy was reached.
/// Collective.
/// @param size_scale  on the cell sizes to start from
/// @param options     without `start_from`; empty function: nothing
/// @throws InputError if the case states no accuracy; as prepare_machine and run_case
RefinedRun run_to_accuracy(const casefile::Case& input, double size_scale, const OptionsOfLast& options,
                           Observer& observer);

}  // namespace deadpoint::full
