#include "deadpoint/study/compare.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/study/drift_summary.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::study {
namespace {

constexpr double same_time = 1.0;   ///< [s]
constexpr double rounding = 1e-12;  ///< differences below it come from units, relative

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

ComparedValue value_of(const char* kind, Dimension dimension, const casefile::ReferenceNote& note)
{
    ComparedValue value;
    value.kind = kind;
    value.dimension = dimension;
    value.calibrated = note.calibrated;
    value.note = note.note;
    return value;
}

void add_rises(const RunRecord& run, const casefile::ReferenceRises& rises, std::vector<ComparedValue>& values)
{
    for (const auto& [probe, rise] : rises.values) {
        auto value = value_of("rises", Dimension::temperature_difference, rises);
        value.name = probe + " " + at(rises.time);
        value.reference = rise;
        value.computed = value_at(run, run.rises.at(probe), rises.time);
        value.calibrated = value.calibrated || was_fitted_to(run, rises, probe);
        values.push_back(std::move(value));
    }
}

ComparedValue chain_value(const RunRecord& run, const casefile::ReferenceChain& c)
{
    auto value = value_of("chain", Dimension::length, c);
    const auto& course = run.chain.at(c.dimension);
    value.reference = c.opposite_sign ? -c.value : c.value;
    if (c.at == "time") {
        value.name = c.dimension + " " + at(*c.time);
        value.computed = value_at(run, course, *c.time);
    } else if (c.at == "end") {
        value.name = c.dimension + " at the end";
        value.computed = course.back();
    } else {
        value.name = c.dimension + " largest";
        value.computed = *std::ranges::max_element(course, {}, [](double e) { return std::abs(e); });
    }
    return value;
}

ComparedValue time_value(const RunRecord& run, const casefile::ReferenceTime& t)
{
    auto value = value_of("times", Dimension::time, t);
    value.reference = t.value;
    if (t.of == "largest_E_SW") {
        value.name = "E_SW is largest";
        value.computed = run.time[largest_gap_row(run)];
    } else {
        value.name = fmt::format("{} has {:.3g} % of its rise", t.probe, 100 * t.share);
        value.computed = time_to_share(run.time, run.rises.at(t.probe), t.share);
    }
    return value;
}

ComparedValue load_value(const RunRecord& run, const casefile::ReferenceLoad& l)
{
    const auto unit = casefile::load_unit(l.quantity);
    auto value = value_of("loads", unit.dimension, l);
    value.name = l.quantity;
    value.reference = l.force ? *l.force : l.length ? *l.length : l.power ? *l.power : l.number.value_or(0);
    value.computed = unit.factor * run.loads.at(l.quantity);
    return value;
}

ComparedCurve compared_curve(const RunRecord& run, const casefile::ReferenceCurve& c)
{
    ComparedCurve curve;
    curve.name = c.name;
    curve.measures = c.measures;
    curve.time = c.time;
    curve.reference = c.value;
    curve.calibrated = c.calibrated;
    curve.note = c.note;
    const bool of_probe = c.measures == "temperature" || c.measures == "rise";
    curve.dimension = !of_probe                     ? Dimension::length
                      : c.measures == "temperature" ? Dimension::temperature
                                                    : Dimension::temperature_difference;
    const double offset = c.measures == "temperature" ? run.initial_temperature : 0;
    const auto& course = of_probe ? run.rises.at(c.probe) : run.chain.at(c.measures);
    for (const double time : c.time) {
        curve.computed.push_back(offset + value_at(run, course, time));
    }
    curve.figures = error_figures(curve.computed, curve.reference, offset);
    return curve;
}

/// Groups in the order in which their first values come.
std::vector<ComparedGroup> grouped(const std::vector<ComparedValue>& values)
{
    std::vector<ComparedGroup> groups;
    std::vector<std::vector<const ComparedValue*>> members;
    for (const auto& value : values) {
        const auto found = std::ranges::find_if(groups, [&](const ComparedGroup& g) {
            return g.kind == value.kind && g.dimension == value.dimension && g.calibrated == value.calibrated;
        });
        if (found == groups.end()) {
            groups.push_back({value.kind, value.dimension, value.calibrated, {}, ""});
            members.push_back({&value});
        } else {
            members[static_cast<std::size_t>(found - groups.begin())].push_back(&value);
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        std::vector<double> computed, reference;
        for (const auto* value : members[i]) {
            computed.push_back(value->computed);
            reference.push_back(value->reference);
        }
        const bool change = groups[i].kind == "rises" || groups[i].kind == "chain";
        groups[i].figures = error_figures(computed, reference, change ? std::optional(0.0) : std::nullopt);
        groups[i].largest_name = members[i][groups[i].figures.largest_at]->name;
    }
    return groups;
}

}  // namespace

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

Comparison compare(const RunRecord& run, const casefile::ReferenceFile& reference, const std::string& point)
{
    Comparison result;
    result.reference = reference.name;
    result.source = reference.source;
    result.note = reference.note;
    result.point = point;
    for (const auto& rises : reference.rises) {
        add_rises(run, rises, result.values);
    }
    for (const auto& c : reference.chain) {
        result.values.push_back(chain_value(run, c));
    }
    for (const auto& t : reference.times) {
        result.values.push_back(time_value(run, t));
    }
    for (const auto& l : reference.loads) {
        if (run.has_loads) {
            result.values.push_back(load_value(run, l));
        }
    }
    if (!reference.loads.empty() && !run.has_loads) {
        result.warnings.push_back(fmt::format("{} figure{} of loads.json not compared: the result has no loads",
                                              reference.loads.size(), reference.loads.size() == 1 ? "" : "s"));
    }
    if (run.interrupted) {
        result.warnings.push_back(fmt::format("the run was interrupted: its end is {}", at(run.time.back())));
    }
    result.groups = grouped(result.values);
    for (const auto& c : reference.curves) {
        result.curves.push_back(compared_curve(run, c));
    }
    for (const auto& claim : reference.claims) {
        result.verdicts.push_back(judge(run, claim));
    }
    return result;
}

}  // namespace deadpoint::study
