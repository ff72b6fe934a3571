#pragma once

#include <optional>
#include <string>
#include <variant>

/// The key `numerics.accuracy`: the largest change of the result that a further refinement may
/// cause.
namespace deadpoint::casefile {

struct Case;
struct Finding;

struct Accuracy {
    enum class Of { rises, gap };
    Of of = Of::rises;     ///< the rises of all probes, or the gap E_SW
    double tolerance = 0;  ///< [K] or [m], > 0
};

/// Reason why a text is not an accuracy.
struct AccuracyProblem {
    std::string message;
    std::string help;
};

/// "0.1 K" is an accuracy of the rises, "0.2 um" one of the gap.
std::variant<Accuracy, AccuracyProblem> parse_accuracy(const std::string& text);

/// The accuracy that a checked case requests, if any.
std::optional<Accuracy> wanted_accuracy(const Case& input);

/// A mistake if the case lacks the figure of its accuracy: a gap without [chain], or rises without
/// probes.
std::optional<Finding> check_accuracy(const Case& input);

}  // namespace deadpoint::casefile
