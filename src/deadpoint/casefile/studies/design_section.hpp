#pragma once

#include "deadpoint/core/quantity.hpp"

#include <optional>
#include <string>
#include <vector>

/// Sections of a study file for sensitivity and design, which run on a reduced model.
namespace deadpoint::casefile {

class Diagnostics;
class Visitor;
struct Case;
struct Document;

/// Keys of a case that change together within a range.
struct VariedKeys {
    std::string name;               ///< after reading never empty
    std::vector<std::string> keys;  ///< patterns; after reading: paths of the keys
    double factor = 0;              ///< > 1: from 1/factor to factor times their values; 0: not stated
    std::string shift;              ///< "3 K": from 3 K below to 3 K above their values
    std::string from, to;           ///< or the range of the values themselves

    enum class Kind { factor, shift, value };
    // After reading:
    Kind kind = Kind::factor;
    double low = 0, high = 0;  ///< factors, or shifts or values in SI units
    Dimension dimension = Dimension::none;
};

enum class SensitivityMethod { sobol, morris };

struct SensitivitySection {
    std::string method_name = "sobol";
    int points = 256;       ///< rows of the design of Sobol' indices
    int trajectories = 20;  ///< of Morris screening
    int seed = 1;
    int gradients = 0;                 ///< points at which derivatives are computed, for bounds of the total indices
    std::vector<std::string> outputs;  ///< names or patterns; empty: the gap and all probes
    std::vector<double> times;         ///< of figures besides the end [s]
    int course_times = 24;             ///< of indices over time
    bool samples = false;              ///< write all points with their figures
    std::vector<VariedKeys> parameters;
    [[nodiscard]] SensitivityMethod method() const
    {
        return method_name == "morris" ? SensitivityMethod::morris : SensitivityMethod::sobol;
    }
};

/// A speed for each interval from the start of a segment; behind the last one the segment keeps its own.
struct SpeedProfile {
    int segment = 0;
    std::vector<double> ends;          ///< of the intervals, from the start of the segment [s]
    double least = 0, most = 0;        ///< [rad/s]
    std::optional<double> least_mean;  ///< of the mean speed over the intervals [rad/s]
};

/// A limit on an output at all times from one on.
struct OptimiseLimit {
    std::string output;
    std::string most, least;  ///< texts, in the unit of the output
    double from = 0;          ///< [s]
    // After reading:
    std::optional<double> most_value, least_value;  ///< [K] or [m]
};

enum class Objective { drift, warm_up, ambient };
enum class Optimiser { slsqp, ccsa, cobyla };

struct OptimiseSection {
    std::string objective_name = "drift";
    std::string method_name = "slsqp";
    double from = 0;          ///< of drift and ambient [s]
    double rate = 0;          ///< of warm-up; 0: chain.drift_rate_limit [m/s]
    double ambient_step = 2;  ///< of the ambient's effect [K]
    int starts = 4;
    int evaluations = 60;  ///< per start, at most
    int seed = 1;
    double step = 120;                  ///< of time [s]
    std::optional<double> warm_within;  ///< limit of the time to warm [s]
    std::optional<SpeedProfile> speed_profile;
    std::vector<VariedKeys> variables;
    std::vector<OptimiseLimit> limits;
    [[nodiscard]] Objective objective() const
    {
        return objective_name == "warm-up"   ? Objective::warm_up
               : objective_name == "ambient" ? Objective::ambient
                                             : Objective::drift;
    }
    [[nodiscard]] Optimiser method() const
    {
        return method_name == "ccsa" ? Optimiser::ccsa : method_name == "cobyla" ? Optimiser::cobyla : Optimiser::slsqp;
    }
};

void describe(Visitor& v, VariedKeys& k);
void describe(Visitor& v, SensitivitySection& s);
void describe(Visitor& v, SpeedProfile& p);
void describe(Visitor& v, OptimiseLimit& l);
void describe(Visitor& v, OptimiseSection& s);

/// Finds the keys of patterns, reads the ranges and names what has no name; adds every mistake with its place.
/// @param at  path of the list in the document: "sensitivity.parameters"
void complete_varied(std::vector<VariedKeys>& list, const std::string& at, const Case& base, const Document& document,
                     Diagnostics& diagnostics);

/// Checks names of outputs and times against the base case.
void check_sensitivity(SensitivitySection& section, const Case& base, const Document& document,
                       Diagnostics& diagnostics);

/// Checks variables, profile and limits against the base case, and reads the values of the limits.
void check_optimise(OptimiseSection& section, const Case& base, const Document& document, Diagnostics& diagnostics);

}  // namespace deadpoint::casefile
