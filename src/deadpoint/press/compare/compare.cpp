#include "deadpoint/press/compare/compare.hpp"

#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/drift/drift_summary.hpp"
#include "deadpoint/press/run/run_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::press {
namespace {

constexpr double same_time = 1.0;   ///< [s]
constexpr double rounding = 1e-12;  ///< relative; smaller differences come from unit conversion

/// Computed less reference, without what changing the unit leaves.
double difference(double computed, double reference)
{
    const double error = computed - reference;
    return std::abs(error) <= rounding * std::abs(reference) ? 0.0 : error;
}

std::string at(double time) { return fmt::format("at {:.4g} h", time / 3600); }

bool was_fitted_to(const RunRecord& run, const casefile::ReferenceRises& rises, const std::string& probe)
{
    return rises.point.empty() && !run.calibrated_on.empty() &&
           std::abs(rises.time - run.calibrated_time) < same_time &&
           std::ranges::find(run.calibrated_probes, probe) != run.calibrated_probes.end();
}

ComparedValue compared_value(ValueKind kind, Dimension dimension, std::string name,
                             const casefile::ReferenceValue& note)
{
    ComparedValue value;
    value.kind = kind;
    value.group = note.group.empty() ? std::string(name_of(kind)) : note.group;
    value.name = std::move(name);
    value.dimension = dimension;
    value.calibrated = note.calibrated;
    value.note = note.note;
    return value;
}

void add_rises(const RunRecord& run, const casefile::ReferenceRises& rises, std::vector<ComparedValue>& values)
{
    for (const auto& [probe, rise] : rises.values) {
        auto value =
            compared_value(ValueKind::rises, Dimension::temperature_difference, probe + " " + at(rises.time), rises);
        value.reference = rise;
        value.computed = value_at(run, run.rises.at(probe), rises.time);
        value.calibrated = value.calibrated || was_fitted_to(run, rises, probe);
        values.push_back(std::move(value));
    }
}

ComparedValue chain_value(const RunRecord& run, const casefile::ReferenceChain& c)
{
    const auto& course = run.chain.at(c.dimension);
    using At = casefile::ReferenceChain::At;
    const std::string when = c.at == At::time ? at(*c.time) : c.at == At::end ? "at the end" : "largest";
    auto value = compared_value(ValueKind::chain, Dimension::length, c.dimension + " " + when, c);
    value.reference = c.opposite_sign ? -c.value : c.value;
    if (c.at == At::time) {
        value.computed = value_at(run, course, *c.time);
    } else if (c.at == At::end) {
        value.computed = course.back();
    } else {
        value.computed = *std::ranges::max_element(course, {}, [](double e) { return std::abs(e); });
    }
    return value;
}

ComparedValue time_value(const RunRecord& run, const casefile::ReferenceTime& t)
{
    const bool of_gap = t.of == casefile::ReferenceTime::Of::largest_E_SW;
    auto value = compared_value(
        ValueKind::times, Dimension::time,
        of_gap ? "E_SW is largest" : fmt::format("{} has {:.3g} % of its rise", t.probe, 100 * t.share), t);
    value.reference = t.value;
    value.computed = of_gap ? run.time[largest_gap_row(run)] : time_to_share(run.time, run.rises.at(t.probe), t.share);
    return value;
}

ComparedValue load_value(const RunRecord& run, const casefile::ReferenceLoad& l)
{
    const auto unit = casefile::load_unit(l.quantity);
    auto value = compared_value(ValueKind::loads, unit.dimension, l.quantity, l);
    value.reference = l.force ? *l.force : l.length ? *l.length : l.power ? *l.power : l.number.value_or(0);
    value.computed = unit.factor * run.loads.at(l.quantity);
    return value;
}

ComparedCurve compared_curve(const RunRecord& run, const casefile::ReferenceCurve& c)
{
    ComparedCurve curve;
    curve.name = c.name;
    using enum casefile::ReferenceCurve::Measures;
    curve.measures = casefile::name_of(*c.measures);
    curve.time = c.time;
    curve.reference = c.value;
    curve.calibrated = c.calibrated;
    curve.note = c.note;
    const bool of_probe = c.measures == temperature || c.measures == rise;
    curve.dimension = !of_probe                   ? Dimension::length
                      : c.measures == temperature ? Dimension::temperature
                                                  : Dimension::temperature_difference;
    const double offset = c.measures == temperature ? run.initial_temperature : 0;
    const auto& course = of_probe ? run.rises.at(c.probe) : run.chain.at(curve.measures);
    for (const double time : c.time) {
        curve.computed.push_back(offset + value_at(run, course, time));
    }
    curve.figures = error_figures(curve.computed, curve.reference, offset);
    return curve;
}

std::vector<ComparedValue> values_of(const RunRecord& run, const casefile::ReferenceFile& reference)
{
    std::vector<ComparedValue> values;
    for (const auto& rises : reference.rises) {
        add_rises(run, rises, values);
    }
    for (const auto& c : reference.chain) {
        values.push_back(chain_value(run, c));
    }
    for (const auto& t : reference.times) {
        values.push_back(time_value(run, t));
    }
    for (const auto& l : reference.loads) {
        if (run.has_loads) {
            values.push_back(load_value(run, l));
        }
    }
    return values;
}

std::vector<ComparedCurve> curves_of(const RunRecord& run, const casefile::ReferenceFile& reference)
{
    std::vector<ComparedCurve> curves;
    for (const auto& c : reference.curves) {
        curves.push_back(compared_curve(run, c));
    }
    return curves;
}

void add_baseline(const RunRecord& baseline, const casefile::ReferenceFile& reference, Comparison& result)
{
    // Loads come last. If the baseline has none, its other values still have the same indices.
    const auto values = values_of(baseline, reference);
    for (std::size_t i = 0; i < std::min(values.size(), result.values.size()); ++i) {
        result.values[i].baseline = values[i].computed;
    }
    const auto curves = curves_of(baseline, reference);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        result.curves[i].baseline = curves[i].computed;
        result.curves[i].figures.rms_baseline = curves[i].figures.rms;
    }
}

/// Groups in the order in which their first values come.
std::vector<ComparedGroup> grouped(const std::vector<ComparedValue>& values)
{
    std::vector<ComparedGroup> groups;
    std::vector<std::vector<const ComparedValue*>> members;
    for (const auto& value : values) {
        const auto found = std::ranges::find_if(groups, [&](const ComparedGroup& g) {
            return g.kind == value.kind && g.group == value.group && g.dimension == value.dimension &&
                   g.calibrated == value.calibrated;
        });
        if (found == groups.end()) {
            groups.push_back({value.kind, value.group, value.dimension, value.calibrated, {}, ""});
            members.push_back({&value});
        } else {
            members[static_cast<std::size_t>(found - groups.begin())].push_back(&value);
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        std::vector<double> computed, reference, baseline;
        for (const auto* value : members[i]) {
            computed.push_back(value->computed);
            reference.push_back(value->reference);
            if (value->baseline) {
                baseline.push_back(*value->baseline);
            }
        }
        const bool change = groups[i].kind == ValueKind::rises || groups[i].kind == ValueKind::chain;
        groups[i].figures = error_figures(computed, reference, change ? std::optional(0.0) : std::nullopt);
        if (baseline.size() == reference.size()) {
            groups[i].figures.rms_baseline = error_figures(baseline, reference, std::nullopt).rms;
        }
        groups[i].largest_name = members[i][groups[i].figures.largest_at]->name;
    }
    return groups;
}

}  // namespace

std::string_view name_of(ValueKind kind)
{
    constexpr std::array<std::string_view, 4> names{"rises", "chain", "times", "loads"};
    return names.at(static_cast<std::size_t>(kind));
}

double ComparedValue::error() const { return difference(computed, reference); }

std::optional<double> ComparedValue::relative_error() const
{
    return reference == 0 ? std::nullopt : std::optional(error() / std::abs(reference));
}

ErrorFigures error_figures(const std::vector<double>& computed, const std::vector<double>& reference,
                           std::optional<double> nothing)
{
    if (computed.empty() || computed.size() != reference.size()) {
        throw DomainError("errors need one reference for each value, and one value at least");
    }
    const auto count = static_cast<double>(computed.size());
    const double mean = std::accumulate(reference.begin(), reference.end(), 0.0) / count;
    const auto rms_of = [&](auto&& prediction) {
        double sum = 0;
        for (std::size_t i = 0; i < reference.size(); ++i) {
            const double error = difference(prediction(i), reference[i]);
            sum += error * error;
        }
        return std::sqrt(sum / count);
    };
    ErrorFigures figures;
    figures.count = computed.size();
    figures.rms = rms_of([&](std::size_t i) { return computed[i]; });
    for (std::size_t i = 0; i < computed.size(); ++i) {
        const double error = difference(computed[i], reference[i]);
        figures.bias += error / count;
        if (std::abs(error) > std::abs(figures.largest)) {
            figures.largest = error;
            figures.largest_at = i;
        }
    }
    if (nothing) {
        figures.rms_nothing = rms_of([&](std::size_t) { return *nothing; });
    }
    if (nothing && computed.size() > 1) {
        figures.rms_mean = rms_of([&](std::size_t) { return mean; });
    }
    if (!std::isfinite(figures.rms) || !std::isfinite(figures.bias) ||
        !std::isfinite(figures.rms_nothing.value_or(0)) || !std::isfinite(figures.rms_mean.value_or(0))) {
        throw DomainError("the error of a value is no finite number\n  help: a value of the reference file or of the "
                          "result is too large to be meant; correct it");
    }
    return figures;
}

casefile::ResultContents contents(const RunRecord& run)
{
    casefile::ResultContents result;
    result.probes = run.probes;
    for (const auto& [name, course] : run.chain) {
        result.dimensions.push_back(name);
    }
    for (const auto& [path, value] : run.loads) {
        result.loads.push_back(path);
    }
    result.has_loads = run.has_loads;
    result.end = run.time.back();
    result.interrupted = run.interrupted;
    return result;
}

Comparison compare(const RunRecord& run, const casefile::ReferenceFile& reference, const std::string& point,
                   const RunRecord* baseline)
{
    Comparison result;
    result.reference = reference.name;
    result.source = reference.source;
    result.note = reference.note;
    result.point = point;
    result.values = values_of(run, reference);
    result.curves = curves_of(run, reference);
    if (baseline != nullptr) {
        result.baseline = baseline->folder;
        add_baseline(*baseline, reference, result);
    }
    result.groups = grouped(result.values);
    for (const auto& claim : reference.claims) {
        result.verdicts.push_back(judge(run, claim));
    }
    if (!reference.loads.empty() && !run.has_loads) {
        result.warnings.push_back(fmt::format("{} figure{} of loads.json not compared: the result has no loads",
                                              reference.loads.size(), reference.loads.size() == 1 ? "" : "s"));
    }
    for (const ComparedCurve& curve : result.curves) {
        constexpr double much = 100;  // [K] at the start, between one scale and another
        if (curve.dimension == Dimension::temperature && !curve.time.empty() &&
            std::abs(curve.reference.front() - curve.computed.front()) > much) {
            result.warnings.push_back(fmt::format(
                "'{}' begins at {}, and the run has {} then\n  help: check the unit of the column: degC, K or "
                "degF",
                curve.name, format_quantity(curve.reference.front(), Dimension::temperature),
                format_quantity(curve.computed.front(), Dimension::temperature)));
        }
    }
    if (run.interrupted) {
        result.warnings.push_back(fmt::format("the run was interrupted: its end is {}", at(run.time.back())));
    }
    return result;
}

std::optional<Agreement> agreement(const Comparison& comparison)
{
    Agreement predicted{0, 0, false}, fitted{0, 0, true};
    const auto add = [&](const ErrorFigures& figures, bool calibrated) {
        if (figures.rms_nothing.value_or(0) > 0) {
            auto& sum = calibrated ? fitted : predicted;
            sum.value += std::pow(figures.rms / *figures.rms_nothing, 2);
            ++sum.sets;
        }
    };
    for (const auto& group : comparison.groups) {
        add(group.figures, group.calibrated);
    }
    for (const auto& curve : comparison.curves) {
        add(curve.figures, curve.calibrated);
    }
    auto result = predicted.sets > 0 ? predicted : fitted;
    if (result.sets == 0) {
        return std::nullopt;
    }
    result.value = 1 - std::sqrt(result.value / static_cast<double>(result.sets));
    return result;
}

}  // namespace deadpoint::press
