#pragma once

#include <optional>
#include <string>
#include <variant>

/// The key `numerics.accuracy`: by how much a further refinement may still change the result.
namespace deadpoint::casefile {

struct Case;
struct Finding;

struct Accuracy {
    enum class Of { rises, gap };
    Of of = Of::rises;     ///< the rises of all probes, or the gap E_SW
    double tolerance = 0;  ///< [K] or [m], > 0
};

/// Why a text is no accuracy.
struct AccuracyProblem {
    std::string message;
    std::string help;
};

/// "0.1 K" is an accuracy of the rises, "0.2 um" one of the gap.
std::variant<Accuracy, AccuracyProblem> parse_accuracy(const std::string& text);

/// The accuracy that a checked case asks for, if any.
std::optional<Accuracy> wanted_accuracy(const Case& input);

/// A mistake where the case has nothing of which it states an accuracy: a gap without [chain], rises without probes.
std::optional<Finding> check_accuracy(const Case& input);

}  // namespace deadpoint::casefile
