#include "deadpoint/casefile/describe/accuracy.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/quantity.hpp"

#include <fmt/format.h>

namespace deadpoint::casefile {

std::variant<Accuracy, AccuracyProblem> parse_accuracy(const std::string& text)
{
    const auto rise = try_parse_quantity(text, Dimension::temperature_difference);
    const auto length = try_parse_quantity(text, Dimension::length);
    const auto* kelvin = std::get_if<double>(&rise);
    const auto* metre = std::get_if<double>(&length);
    if (kelvin == nullptr && metre == nullptr) {
        const auto& problem = std::get<QuantityProblem>(rise);
        const std::string message = problem.code == "unit-mismatch"
                                        ? fmt::format("'{}' is neither a temperature difference nor a length", text)
                                    : problem.code == "missing-unit" ? fmt::format("'{}' has no unit", text)
                                                                     : problem.message;
        return AccuracyProblem{message, "write \"0.1 K\" for the rises of the probes or \"0.2 um\" for the gap"};
    }
    const double value = kelvin != nullptr ? *kelvin : *metre;
    if (!(value > 0)) {
        return AccuracyProblem{fmt::format("'{}' is not positive", text), "give the largest acceptable change"};
    }
    return Accuracy{kelvin != nullptr ? Accuracy::Of::rises : Accuracy::Of::gap, value};
}

std::optional<Accuracy> wanted_accuracy(const Case& input)
{
    if (input.numerics.accuracy.empty()) {
        return std::nullopt;
    }
    const auto parsed = parse_accuracy(input.numerics.accuracy);
    const auto* accuracy = std::get_if<Accuracy>(&parsed);
    return accuracy != nullptr ? std::optional(*accuracy) : std::nullopt;
}

std::optional<Finding> check_accuracy(const Case& input)
{
    const auto accuracy = wanted_accuracy(input);
    if (!accuracy) {
        return std::nullopt;
    }
    if (accuracy->of == Accuracy::Of::gap && !input.chain) {
        return Finding{"inconsistent", "numerics.accuracy", "an accuracy of the gap needs a dimension chain",
                       "add [chain], or ask for an accuracy of the rises like \"0.1 K\"", false};
    }
    if (accuracy->of == Accuracy::Of::rises && input.probes.empty()) {
        return Finding{"inconsistent", "numerics.accuracy", "an accuracy of the rises needs probes",
                       "add [probes], or ask for an accuracy of the gap like \"0.2 um\"", false};
    }
    return std::nullopt;
}

}  // namespace deadpoint::casefile
