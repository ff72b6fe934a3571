#include "deadpoint/twin/calibrate/parameter.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::twin {
namespace {

std::map<std::string, casefile::NumberChange> changes_of(const std::vector<CaseParameter>& parameters,
                                                         const std::vector<double>& theta)
{
    if (theta.size() != parameters.size())
        throw InputError(fmt::format("{} values for {} parameters", theta.size(), parameters.size()));
    std::map<std::string, casefile::NumberChange> changes;
    for (std::size_t k = 0; k < parameters.size(); ++k)
        for (const auto& key : parameters[k].keys) {
            auto& change = changes[key];
            if (parameters[k].kind == CaseParameter::Kind::factor) {
                change.factor *= std::exp(theta[k]);
            } else {
                change.shift += theta[k];
            }
        }
    return changes;
}

}  // namespace

std::vector<std::string> keys_of(const casefile::Case& input, const std::vector<std::string>& patterns,
                                 const std::string& owner)
{
    const auto numbers = casefile::numbers_of(input);
    std::vector<std::string> keys;
    for (const auto& pattern : patterns) {
        const auto found = casefile::numbers_matching(numbers, pattern);
        if (found.empty())
            throw InputError(
                fmt::format("{}: the case has no number '{}'\n  help: did you mean '{}'? A pattern has * for "
                            "any letters; the resolved case (case.toml of a run) shows all keys",
                            owner, pattern, casefile::nearest_key(numbers, pattern)));
        for (const auto* number : found)
            if (std::ranges::find(keys, number->path) == keys.end())
                keys.push_back(number->path);
    }
    return keys;
}

casefile::Case with_parameters(const casefile::Case& input, const std::vector<CaseParameter>& parameters,
                               const std::vector<double>& theta)
{
    auto result = input;
    casefile::change_numbers(result, changes_of(parameters, theta));
    return result;
}

std::vector<std::string> settings_of(const casefile::Case& input, const std::vector<CaseParameter>& parameters,
                                     const std::vector<double>& theta)
{
    std::vector<std::string> keys;
    for (const auto& parameter : parameters)
        for (const auto& key : parameter.keys)
            if (std::ranges::find(keys, key) == keys.end())
                keys.push_back(key);
    std::vector<std::string> settings;
    const auto changed = with_parameters(input, parameters, theta);
    const auto texts = casefile::texts_of(changed, keys);
    for (const auto& key : keys)
        settings.push_back(fmt::format("{}={}", key, texts.at(key)));
    return settings;
}

}  // namespace deadpoint::twin
