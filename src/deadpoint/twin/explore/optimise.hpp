#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/design/minimise.hpp"
#include "deadpoint/twin/explore/varied.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
class Observer;
}
namespace deadpoint::press {
struct RunResult;
}

namespace deadpoint::twin {

struct ReducedPress;

/// What a design gives, on the reduced or on the full model.
struct DesignFigures {
    double drift = 0;               ///< as drift_of() from the time of the study [m]
    double largest_change = 0;      ///< of E_SW since that time, in magnitude [m]
    std::optional<double> warm;     ///< as warm_time() [s]; none without a rate, or if it is not reached
    std::optional<double> ambient;  ///< as ambient_effect() [m/K]; only of the reduced model
    std::vector<double> extremes;   ///< per limit of the section: the value nearest to it or beyond it
};

/// The course of a design.
struct DesignCourse {
    std::vector<double> time;  ///< [s]
    std::vector<double> gap;   ///< E_SW [m]
};

/// A search from one start.
struct DesignStart {
    design::Point start;
    design::Minimum minimum;
    std::vector<std::string> stages;  ///< of each step of the minimum
};

struct OptimiseResult {
    std::vector<VariedRange> ranges;  ///< of the variables: speeds of the profile first
    std::vector<DesignStart> starts;
    std::size_t best = 0;         ///< start whose minimum is the smallest that keeps all limits
    bool feasible = false;        ///< it keeps all limits
    std::size_t minima = 0;       ///< number of different ones among the starts
    DesignFigures before, after;  ///< of the case itself and of the optimum, on the reduced model
    DesignCourse course_before, course_after;
    casefile::Case optimum;
    std::vector<std::string> outside;  ///< coefficients of the optimum outside of the range of the reduced model
};

/// Two minima count as one if no variable differs by more than this share of its range.
inline constexpr double same_minimum = 0.05;

/// Looks for the optimum from several starts, of which the case itself is the first.
/// @param input    the base case with the settings of the study
/// @param section  as casefile::read_study() leaves it
/// @return nothing if the observer was cancelled
/// @throws InputError if the case is not that press, or if a variable changes what a reduced model cannot
std::optional<OptimiseResult> run_optimise(const casefile::Case& input, const ReducedPress& press,
                                           const casefile::OptimiseSection& section, int threads, Observer& observer);

/// The optimum in full: figures and course of a run of the case.
struct FullDesign {
    DesignFigures figures;
    DesignCourse course;
};
/// @param input  of the run, with a dimension chain
FullDesign full_design(const casefile::Case& input, const press::RunResult& run,
                       const casefile::OptimiseSection& section);

/// The case with its segment divided as a profile says, each interval with the speed of the segment.
casefile::Case divided(casefile::Case input, const casefile::SpeedProfile& profile);

}  // namespace deadpoint::twin
