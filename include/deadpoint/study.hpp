#pragma once

#include "deadpoint/press.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Studies: several runs of a press, and comparisons with measured values.
namespace deadpoint {

/// One key of the case and the values it takes.
struct SweepAxis {
    std::string key;                  ///< "operation.0.speed"
    std::vector<std::string> values;  ///< "300 rpm", "400 rpm"; at least one
};

/// One run of a sweep.
struct SweepRun {
    std::string name;                                           ///< distinct: "speed=300_rpm"
    std::vector<std::pair<std::string, std::string>> settings;  ///< key, value
    std::optional<RunResult> result;                            ///< none: it failed, or the sweep was cancelled
    std::string error;                                          ///< why it failed
};

/// Runs a press for all combinations of the values, the last axis changing fastest. Runs that
/// differ in operation, loads, friction, lubricants, oil, conductances, convection or media share mesh, unknowns and
/// dimension chain. If a run fails, the others continue. Collective.
/// @throws InputError if an axis has no value, or a setting makes a case that cannot be read
std::vector<SweepRun> sweep(const Press& press, const std::vector<SweepAxis>& axes, Observer* observer = nullptr);

/// One mesh of a refinement.
struct RefinementRound {
    long long cells = 0;
    double value = 0;              ///< the gap at the end [m], or the largest final rise of a probe [K]
    std::optional<double> change;  ///< largest change from the previous mesh over the run [m] or [K]
    double estimate = 0;           ///< estimated change by finer parts [m] or [K]
};

struct Refinement {
    Press press;  ///< with the cell sizes and time steps as used
    RunResult result;
    bool reached = false;
    std::string why_not;  ///< reason if it was not reached
    std::vector<RefinementRound> rounds;
};

/// Runs a press with finer parts and smaller time steps until the figure no longer changes. It
/// controls mesh and time-step error only, not the error of laws and data. Collective.
/// @param accuracy  "0.1 K" of the probes' rises or "0.2 um" of the gap; empty: numerics.accuracy of the case
/// @throws InputError if the text is not an accuracy, or the case has no such figure
Refinement refine(const Press& press, const std::string& accuracy = {}, Observer* observer = nullptr);

/// One value beside its reference.
struct ComparedValue {
    std::string name;  ///< "P1 at 3 h"
    std::string unit;  ///< SI
    double computed = 0;
    double reference = 0;
    bool calibrated = false;  ///< a parameter was fitted to it
};

/// A claim of the reference in words.
struct ComparedClaim {
    enum class Outcome { holds, fails, unchecked };
    std::string text;
    Outcome outcome = Outcome::unchecked;
    std::string evidence;  ///< the numbers behind it, or why it is not checked
};

struct Comparison {
    std::vector<ComparedValue> values;
    std::vector<ComparedClaim> claims;
    std::vector<std::string> warnings;
    std::string text;  ///< the comparison as tables, as `deadpoint compare` prints it
};

/// Compares the files of a run with measured or published values.
/// @param results    a folder that a run has written
/// @param reference  a reference file (TOML)
/// @param point      operating point of the reference; empty: values without one
/// @throws InputError for mistakes in the reference file, IoError if a file cannot be read
Comparison compare(const std::filesystem::path& results, const std::filesystem::path& reference,
                   const std::string& point = {});

}  // namespace deadpoint
