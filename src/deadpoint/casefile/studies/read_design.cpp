#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/casefile/studies/design_section.hpp"
#include "deadpoint/casefile/syntax/diagnostics.hpp"
#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <set>

namespace deadpoint::casefile {
namespace {

/// Reads the ranges of a list of varied keys.
class VariedReader {
public:
    VariedReader(const Case& base, const Document& document, Diagnostics& diagnostics)
        : numbers_(numbers_of(base)), document_(document), diagnostics_(diagnostics)
    {}

    void read(VariedKeys& varied, const std::string& at)
    {
        const auto found = numbers_of_patterns(varied, at);
        if (found.empty())
            return;
        if (varied.name.empty())
            varied.name = last_word(found.front());
        varied.keys.clear();
        for (const auto* number : found)
            varied.keys.push_back(number->path);
        varied.dimension = found.front()->dimension;
        for (const auto* number : found)
            if (number->dimension != varied.dimension)
                return report("unit-mismatch", at + ".keys",
                              fmt::format("'{}' is {}, but '{}' is {}", found.front()->by_name,
                                          dimension_info(varied.dimension).name, number->by_name,
                                          dimension_info(number->dimension).name),
                              "let keys of one kind change together");
        read_range(varied, at);
        check_range(varied, found, at);
        check_twice(varied, at);
    }

    void report(std::string code, const std::string& path, std::string message, std::string help)
    {
        diagnostics_.add({Severity::error, std::move(code), place_of(document_.root, path), path, std::move(message),
                          std::move(help), std::nullopt, ""});
    }

    double quantity(const std::string& text, Dimension dimension, const std::string& at)
    {
        const auto read = try_parse_quantity(text, dimension);
        if (const auto* problem = std::get_if<QuantityProblem>(&read)) {
            report(problem->code, at, problem->message, problem->help);
            return 0;
        }
        return std::get<double>(read);
    }

private:
    static std::string last_word(const CaseNumber* number)
    {
        const auto dot = number->by_name.rfind('.');
        return dot == std::string::npos ? number->by_name : number->by_name.substr(dot + 1);
    }

    std::vector<const CaseNumber*> numbers_of_patterns(const VariedKeys& varied, const std::string& at)
    {
        std::vector<const CaseNumber*> result;
        bool all_found = true;
        for (std::size_t k = 0; k < varied.keys.size(); ++k) {
            const auto found = numbers_matching(numbers_, varied.keys[k]);
            if (found.empty())
                report("unknown-key", fmt::format("{}.keys.{}", at, k),
                       fmt::format("the case has no number '{}'", varied.keys[k]),
                       fmt::format("did you mean '{}'? The resolved case (case.toml of a run) shows all keys",
                                   nearest_key(numbers_, varied.keys[k])));
            all_found = all_found && !found.empty();
            for (const auto* number : found)
                if (std::ranges::find(result, number) == result.end())
                    result.push_back(number);
        }
        return all_found ? result : std::vector<const CaseNumber*>();
    }

    void read_range(VariedKeys& varied, const std::string& at)
    {
        if (varied.factor > 0) {
            varied.kind = VariedKeys::Kind::factor;
            varied.low = 1 / varied.factor;
            varied.high = varied.factor;
        } else if (!varied.shift.empty()) {
            const bool temperature = varied.dimension == Dimension::temperature;
            varied.kind = VariedKeys::Kind::shift;
            varied.high = quantity(varied.shift, temperature ? Dimension::temperature_difference : varied.dimension,
                                   at + ".shift");
            varied.low = -varied.high;
        } else {
            varied.kind = VariedKeys::Kind::value;
            varied.low = quantity(varied.from, varied.dimension, at + ".from");
            varied.high = quantity(varied.to, varied.dimension, at + ".to");
        }
    }

    void check_range(const VariedKeys& varied, const std::vector<const CaseNumber*>& found, const std::string& at)
    {
        using Kind = VariedKeys::Kind;
        const std::string last = varied.kind == Kind::factor  ? ".factor"
                                 : varied.kind == Kind::shift ? ".shift"
                                                              : ".to";
        if (!(varied.low < varied.high))
            return report("inconsistent", at + last, "the range has no extent",
                          varied.kind == Kind::shift ? "give a shift above zero" : "let `from` be less than `to`");
        const auto is_zero = [](const CaseNumber* number) { return number->value == 0; };
        if (varied.kind == Kind::factor && std::ranges::all_of(found, is_zero))
            return report("inconsistent", at + ".keys",
                          fmt::format("'{}' is zero, which no factor changes", found.front()->by_name),
                          "give `from` and `to`");
        for (const auto* number : found)
            for (const double end : {varied.low, varied.high})
                check_end(varied, *number, end, at + last);
    }

    void check_end(const VariedKeys& varied, const CaseNumber& number, double end, const std::string& at)
    {
        using Kind = VariedKeys::Kind;
        const double value = varied.kind == Kind::factor  ? end * number.value
                             : varied.kind == Kind::shift ? end + number.value
                                                          : end;
        if (value >= number.least && value <= number.most)
            return;
        report("out-of-range", at,
               fmt::format("'{}' would become {}, outside of its allowed values", number.by_name,
                           format_quantity(value, number.dimension)),
               "make the range narrower");
    }

    void check_twice(const VariedKeys& varied, const std::string& at)
    {
        if (!names_.insert(varied.name).second)
            report("duplicate-name", at, fmt::format("two entries are called '{}'", varied.name),
                   "give each its own `name`");
        for (const auto& key : varied.keys)
            if (!keys_.insert(key).second)
                return report("duplicate-key", at + ".keys", fmt::format("'{}' is varied twice", key),
                              "name each key in one entry only");
    }

    std::vector<CaseNumber> numbers_;
    const Document& document_;
    Diagnostics& diagnostics_;
    std::set<std::string> names_, keys_;
};

// Names of outputs that a case states; corners of the slide are known only with its geometry.
std::vector<std::string> output_names(const Case& base)
{
    std::vector<std::string> names;
    for (const auto& [name, probe] : base.probes)
        names.push_back(name);
    if (base.chain)
        for (const char* dimension : {"E_SW", "E_BG", "E_WG", "E_CS", "E_BC"})
            names.emplace_back(dimension);
    return names;
}

double length_of(const Case& base)
{
    return std::accumulate(base.operation.begin(), base.operation.end(), 0.0,
                           [](double sum, const Segment& segment) { return sum + segment.duration; });
}

void check_profile(const OptimiseSection& section, const Case& base, VariedReader& reader)
{
    if (!section.speed_profile)
        return;
    const auto& profile = *section.speed_profile;
    const auto segment = static_cast<std::size_t>(profile.segment);
    if (segment >= base.operation.size())
        return reader.report("out-of-range", "optimise.speed_profile.segment",
                             fmt::format("the operation has {} segments", base.operation.size()), "count them from 0");
    if (profile.ends.empty() || profile.ends.back() >= base.operation[segment].duration)
        reader.report(
            "out-of-range", "optimise.speed_profile.ends",
            fmt::format("the segment takes {}", format_quantity(base.operation[segment].duration, Dimension::time)),
            "let the last interval end before the segment does");
    if (base.operation[segment].ambient &&
        (base.operation[segment].ambient->table || base.operation[segment].ambient->daily))
        reader.report("inconsistent", "optimise.speed_profile.segment",
                      "the segment has an ambient over time, which cannot be divided",
                      "state the ambient in [machine]");
}

void read_limit(OptimiseLimit& limit, const std::string& at, const Case& base, VariedReader& reader)
{
    const auto names = output_names(base);
    if (std::ranges::find(names, limit.output) == names.end() && !limit.output.starts_with("corner "))
        return reader.report("unknown-name", at + ".output", fmt::format("the case has no output '{}'", limit.output),
                             fmt::format("outputs are {}", fmt::join(names, ", ")));
    const auto dimension = base.probes.contains(limit.output) ? Dimension::temperature : Dimension::length;
    if (!limit.most.empty())
        limit.most_value = reader.quantity(limit.most, dimension, at + ".most");
    if (!limit.least.empty())
        limit.least_value = reader.quantity(limit.least, dimension, at + ".least");
}

}  // namespace

void complete_varied(std::vector<VariedKeys>& list, const std::string& at, const Case& base, const Document& document,
                     Diagnostics& diagnostics)
{
    VariedReader reader(base, document, diagnostics);
    for (std::size_t k = 0; k < list.size(); ++k)
        reader.read(list[k], fmt::format("{}.{}", at, k));
}

void check_sensitivity(SensitivitySection& section, const Case& base, const Document& document,
                       Diagnostics& diagnostics)
{
    complete_varied(section.parameters, "sensitivity.parameters", base, document, diagnostics);
    VariedReader reader(base, document, diagnostics);
    const auto names = output_names(base);
    for (std::size_t k = 0; k < section.outputs.size(); ++k) {
        const auto& wanted = section.outputs[k];
        const bool known = std::ranges::any_of(names, [&](const auto& name) { return matches(wanted, name); });
        if (!known && !wanted.starts_with("corner "))
            reader.report("unknown-name", fmt::format("sensitivity.outputs.{}", k),
                          fmt::format("the case has no output '{}'", wanted),
                          closest_name(wanted, names).empty()
                              ? fmt::format("outputs are {}", fmt::join(names, ", "))
                              : fmt::format("did you mean '{}'?", closest_name(wanted, names)));
    }
    const double end = length_of(base);
    for (std::size_t k = 0; k < section.times.size(); ++k)
        if (section.times[k] > end)
            reader.report("out-of-range", fmt::format("sensitivity.times.{}", k),
                          fmt::format("the run ends at {}", format_quantity(end, Dimension::time)),
                          "give a time within the operation of the case");
}

void check_optimise(OptimiseSection& section, const Case& base, const Document& document, Diagnostics& diagnostics)
{
    complete_varied(section.variables, "optimise.variables", base, document, diagnostics);
    VariedReader reader(base, document, diagnostics);
    if (!base.chain)
        reader.report("inconsistent", "optimise", "the base case has no dimension chain, so that E_SW is not known",
                      "add [chain] to the case");
    if (section.rate == 0 && base.chain)
        section.rate = base.chain->drift_rate_limit;
    if (section.rate == 0 && (section.objective() == Objective::warm_up || section.warm_within))
        reader.report("inconsistent", "optimise.rate", "neither study nor case states a rate of drift",
                      "give `rate`, like \"1 um/h\"");
    const double end = length_of(base);
    if (section.from >= end)
        reader.report("out-of-range", "optimise.from",
                      fmt::format("the run ends at {}", format_quantity(end, Dimension::time)),
                      "give a time within the operation of the case");
    check_profile(section, base, reader);
    for (std::size_t k = 0; k < section.limits.size(); ++k)
        read_limit(section.limits[k], fmt::format("optimise.limits.{}", k), base, reader);
}

}  // namespace deadpoint::casefile
