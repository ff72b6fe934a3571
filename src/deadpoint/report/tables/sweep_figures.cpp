#include "deadpoint/report/tables/sweep_figures.hpp"

#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::report {
namespace {

/// "crankshaft.flexible.seats.B.peak_N" is the peak of seat B by the flexible model.
std::map<std::string, double> bearing_forces(const std::map<std::string, double>& loads)
{
    std::map<std::string, double> forces;
    for (const std::string model : {"rigid", "flexible"}) {
        const std::string start = fmt::format("crankshaft.{}.seats.", model);
        const std::string end = ".peak_N";
        for (const auto& [path, value] : loads) {
            if (path.starts_with(start) && path.ends_with(end)) {
                forces[model + " " + path.substr(start.size(), path.size() - start.size() - end.size())] = value;
            }
        }
    }
    return forces;
}

/// SI value = offset + factor * number.
std::vector<double> in_preferred_unit(const twin::SweepAxis& axis)
{
    const std::string unit(dimension_info(axis.dimension).preferred);
    const double offset = parse_quantity("0 " + unit, axis.dimension);
    const double factor = parse_quantity("1 " + unit, axis.dimension) - offset;
    std::vector<double> values;
    for (const double number : axis.numbers) {
        values.push_back((number - offset) / factor);
    }
    return values;
}

std::string steps_text(const twin::SweepAxis& axis, const std::vector<std::size_t>& steps)
{
    std::vector<std::string> labels;
    for (const std::size_t step : steps) {
        labels.push_back(axis.labels[step]);
    }
    if (axis.numbers.empty()) {
        return fmt::format("{} {}", axis.name, fmt::join(labels, " or "));
    }
    return labels.size() == 1 ? fmt::format("{} {}", axis.name, labels.front())
                              : fmt::format("{} {} to {}", axis.name, labels.front(), labels.back());
}

}  // namespace

SweepFigures sweep_figures(const press::RunRecord& run)
{
    SweepFigures figures;
    if (const auto gap = run.chain.find("E_SW"); gap != run.chain.end() && !gap->second.empty()) {
        const auto row = press::largest_gap_row(run);
        figures.drift = SweepDrift{gap->second[row], run.time[row], gap->second.back(), run.gap};
    }
    for (const auto& [probe, rises] : run.rises) {
        figures.rises[probe] = rises.back();
    }
    for (const auto& [joint, heat] : run.joint_heat) {
        figures.joint_heat = figures.joint_heat.value_or(0) + heat.back();
    }
    figures.bearing_forces = bearing_forces(run.loads);
    return figures;
}

std::vector<std::optional<SweepFigures>> sweep_figures(const SweepResult& result)
{
    if (result.outcomes.size() != result.points.size() || result.records.size() != result.points.size()) {
        throw DomainError("a study needs one outcome for each of its points, and a run or none");
    }
    std::vector<std::optional<SweepFigures>> figures(result.points.size());
    for (std::size_t p = 0; p < figures.size(); ++p) {
        if (result.records[p] && !result.records[p]->interrupted) {
            figures[p] = sweep_figures(*result.records[p]);
        }
    }
    return figures;
}

std::optional<twin::PointDrift> magnitudes(const SweepFigures& figures)
{
    if (!figures.drift) {
        return std::nullopt;
    }
    return twin::PointDrift{std::abs(figures.drift->largest), std::abs(figures.drift->final)};
}

std::vector<std::optional<twin::DriftWindow>> sweep_windows(const SweepResult& result)
{
    std::vector<std::optional<twin::PointDrift>> drift;
    for (const auto& figures : sweep_figures(result)) {
        drift.push_back(figures ? magnitudes(*figures) : std::nullopt);
    }
    std::vector<std::optional<twin::DriftWindow>> windows;
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        windows.push_back(twin::best_window(result.study, s, result.points, drift));
    }
    return windows;
}

AxisNumbers axis_numbers(const twin::SweepAxis& axis)
{
    if (axis.numbers.empty()) {
        return {};
    }
    AxisNumbers result;
    for (const auto& step : axis.values) {
        const auto value = casefile::number_and_unit(step.front());
        if (!value || (!result.values.empty() && value->unit != result.unit)) {
            return {std::string(dimension_info(axis.dimension).preferred), in_preferred_unit(axis)};
        }
        result.unit = value->unit;
        result.values.push_back(value->number);
    }
    return result;
}

std::vector<std::size_t> points_of_set(const SweepResult& result, std::size_t set)
{
    const auto& axes = result.study.sets[set].axes;
    std::size_t places = 1;
    for (const auto& axis : axes) {
        places *= axis.values.size();
    }
    std::vector<std::size_t> points(places, 0);
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        for (const auto& place : result.points[p].places) {
            if (place.set == set) {
                points.at(twin::grid_index(result.study.sets[set], place.steps)) = p;
            }
        }
    }
    return points;
}

std::vector<std::size_t> steps_at(const twin::SweepSet& set, std::size_t index)
{
    std::vector<std::size_t> steps(set.axes.size());
    for (std::size_t a = set.axes.size(); a-- > 0;) {
        steps[a] = index % set.axes[a].values.size();
        index /= set.axes[a].values.size();
    }
    return steps;
}

std::string place_label(const twin::SweepSet& set, const std::vector<std::size_t>& steps)
{
    std::string label;
    for (std::size_t a = 0; a < steps.size(); ++a) {
        label += (a == 0 ? "" : ", ") + set.axes[a].labels[steps[a]];
    }
    return label.empty() ? "base case" : label;
}

const char* state_name(twin::PointOutcome::State state)
{
    switch (state) {
    case twin::PointOutcome::State::done:
        return "done";
    case twin::PointOutcome::State::kept:
        return "kept";
    case twin::PointOutcome::State::failed:
        return "failed";
    default:
        return "left";
    }
}

std::string window_text(const twin::SweepSet& set, const std::optional<twin::DriftWindow>& window)
{
    if (!window) {
        return "no limits were given";
    }
    if (window->points == 0) {
        return "no point keeps the limits";
    }
    std::string text;
    for (std::size_t a = 0; a < set.axes.size(); ++a) {
        text += (a == 0 ? "" : "; ") + steps_text(set.axes[a], window->steps[a]);
    }
    return fmt::format("{} ({} {})", text.empty() ? "the base case" : text, window->points,
                       window->points == 1 ? "point" : "points");
}

std::string limits_text(const twin::DriftLimits& limits)
{
    std::string text;
    if (limits.largest) {
        text = fmt::format("largest |E_SW| up to {:g} um", micrometre * *limits.largest);
    }
    if (limits.final) {
        text += fmt::format("{}|E_SW| at the end up to {:g} um", text.empty() ? "" : ", ", micrometre * *limits.final);
    }
    return text;
}

}  // namespace deadpoint::report
