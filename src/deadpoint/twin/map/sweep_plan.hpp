#pragma once

#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/core/quantity.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct StudyFile;
}

/// A study of many runs as plain data: what is varied, and which runs that makes.
namespace deadpoint::twin {

/// One direction in which a case is varied: keys that change together, value by value.
struct SweepAxis {
    std::string name;                              ///< in tables and charts
    std::vector<std::string> keys;                 ///< of the case, like "operation.0.speed"
    std::vector<std::vector<std::string>> values;  ///< per step, one text for each key, as --set takes it
    std::vector<std::string> labels;               ///< per step, for tables: "300 rpm", "traditional"
    std::vector<double> numbers;                   ///< per step in SI units; empty where the steps are no quantities
    Dimension dimension = Dimension::none;         ///< of the numbers
};

/// Axes crossed with each other; no axis is the base case alone.
struct SweepSet {
    std::string name;
    std::vector<SweepAxis> axes;
};

/// Drift that the user allows; the study looks for the widest window of the axes that keeps it.
struct DriftLimits {
    std::optional<double> largest;  ///< of |E_SW| at any time [m]
    std::optional<double> final;    ///< of |E_SW| at the end [m]
};

struct SweepStudy {
    std::string name;
    std::string base;                    ///< path of the base case
    std::vector<std::string> overrides;  ///< "key=value" for all points
    std::vector<SweepSet> sets;
    DriftLimits limits;
    std::string note;                                          ///< for reports
    casefile::FileAccess files = casefile::FileAccess::below;  ///< with which the base case is read
};

/// A place in a set: a step of each of its axes.
struct SweepPlace {
    std::size_t set = 0;
    std::vector<std::size_t> steps;
};

/// One run of the study, with every place that it fills.
struct SweepPoint {
    std::string name;                    ///< names a folder: "speed=300_rpm"; "base" without changes
    std::vector<std::string> overrides;  ///< "key=value": the study's own, then those of its place
    std::vector<SweepPlace> places;
};

/// All runs of a study, each distinct one once, in the order of its sets, the last axis changing fastest. Two places
/// are one run if they set the same keys to the same values; `is_base` tells which value a key has anyway (so that the
/// base case is one run in all sets).
///
/// @param is_base  whether the base case has that value for that key
/// @throws InputError if two axes of a set share a key or a name, two sets a name, or an axis has no step. Points
///         whose names would clash as folders get a mark of what they set at the end of theirs
std::vector<SweepPoint>
sweep_points(const SweepStudy& study,
             const std::function<bool(const std::string& key, const std::string& value)>& is_base);

/// The study that a file describes; an axis gets its numbers where all of its steps are quantities of one dimension
/// (a bare kelvin counts as a difference) or plain numbers, the same for all keys of a step.
/// @param file  as casefile::read_study returns it
SweepStudy translate_study(const casefile::StudyFile& file);

/// For sweep_points: whether the case with the study's overrides stays the same with one more. Reads the case for each
/// value that it is asked for, once.
/// @throws InputError, IoError if the base case cannot be read
std::function<bool(const std::string& key, const std::string& value)> base_values(const SweepStudy& study);

/// Text as part of the name of a file or folder: letters, digits, '.', '-' and '+', and '_' for any row of other signs.
std::string folder_safe(const std::string& text);

/// What became of a point.
struct PointOutcome {
    enum class State { done, kept, failed, left };  ///< kept: finished by an earlier call; left: the study was stopped
    State state = State::left;
    std::string reason;  ///< of a failure
    double seconds = 0;  ///< wall time
};

}  // namespace deadpoint::twin
