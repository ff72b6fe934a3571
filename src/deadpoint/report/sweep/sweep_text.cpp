#include "deadpoint/core/units.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/map/drift_window.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::report {
namespace {

constexpr std::size_t shown_steps = 6;
constexpr std::size_t most_terminal_rows = 200;  // of a set on the terminal

std::string counted(std::size_t count, const char* one, const char* many)
{
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// The first and last labels of a long axis.
std::string labels_text(const std::vector<std::string>& labels)
{
    if (labels.size() <= shown_steps) {
        return fmt::format("{}", fmt::join(labels, ", "));
    }
    return fmt::format("{}, {}, ... {} ({} steps)", labels[0], labels[1], labels.back(), labels.size());
}

std::string axis_text(const twin::SweepAxis& axis)
{
    const std::string keys =
        axis.keys.size() == 1
            ? axis.keys.front()
            : fmt::format("{} and {}", axis.keys.front(), counted(axis.keys.size() - 1, "more key", "more keys"));
    return fmt::format("    {}: {}\n      {}\n", axis.name, labels_text(axis.labels), keys);
}

std::string signed_micrometres(double value)
{
    const double um = micrometre * value;
    return fmt::format("{}{}", um > 0 ? "+" : "", significant(um, 4));
}

std::vector<std::string> row(const SweepResult& result, std::size_t p, const std::optional<SweepFigures>& figures,
                             bool limited)
{
    if (!figures) {
        return {};
    }
    std::vector<std::string> cells(4, "-");
    if (figures->drift) {
        const auto& drift = *figures->drift;
        cells = {signed_micrometres(drift.largest), duration_text(drift.largest_time), signed_micrometres(drift.final),
                 drift.gap ? signed_micrometres(drift.gap->first_hour_change) : "-"};
    }
    double hottest = -HUGE_VAL;
    std::string probe;
    for (const auto& [name, rise] : figures->rises) {
        if (rise > hottest) {
            hottest = rise;
            probe = name;
        }
    }
    cells.push_back(probe.empty() ? "-" : fmt::format("{} ({})", significant(hottest), probe));
    cells.push_back(figures->joint_heat ? fmt::format("{:.0f}", *figures->joint_heat) : "-");
    cells.push_back(duration_text(result.outcomes[p].seconds));
    if (limited) {
        cells.emplace_back(twin::keeps(result.study.limits, magnitudes(*figures)) ? "kept" : "exceeded");
    }
    return cells;
}

std::string window_line(const twin::SweepSet& set, const std::optional<twin::DriftWindow>& window)
{
    return window ? fmt::format("  window: {}\n", window_text(set, window)) : "";
}

std::string set_text(const SweepResult& result, std::size_t s, const std::vector<std::optional<SweepFigures>>& figures,
                     const std::optional<twin::DriftWindow>& window)
{
    const auto& set = result.study.sets[s];
    std::vector<std::string> titles;
    for (const auto& axis : set.axes) {
        titles.push_back(axis.name);
    }
    if (titles.empty()) {
        titles.emplace_back();
    }
    for (const char* title : {"largest um", "after", "at end um", "first hour um", "warmest K", "heat W", "took"}) {
        titles.emplace_back(title);
    }
    const bool limited = result.study.limits.largest || result.study.limits.final;
    if (limited) {
        titles.emplace_back("limits");
    }
    TextTable table(titles);
    for (std::size_t a = 1; a < set.axes.size(); ++a) {
        table.align_left(a);
    }
    const auto points = points_of_set(result, s);
    if (points.size() > most_terminal_rows) {
        return fmt::format("\n{}\n  {} points, in sweep.csv\n{}", set.name, points.size(), window_line(set, window));
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t p = points[i];
        const auto steps = steps_at(set, i);
        std::vector<std::string> cells;
        for (std::size_t a = 0; a < steps.size(); ++a) {
            cells.push_back(set.axes[a].labels[steps[a]]);
        }
        if (cells.empty()) {
            cells.emplace_back("base case");
        }
        const auto values = row(result, p, figures[p], limited);
        if (values.empty()) {
            cells.emplace_back(state_name(result.outcomes[p].state));
        }
        cells.insert(cells.end(), values.begin(), values.end());
        table.add_row(std::move(cells));
    }
    return fmt::format("\n{}\n{}", set.name, table.text()) + window_line(set, window);
}

std::string failures_text(const SweepResult& result)
{
    std::string text;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        if (result.outcomes[p].state == twin::PointOutcome::State::failed) {
            const auto& reason = result.outcomes[p].reason;
            text += fmt::format("  {}: {}\n", result.points[p].name, reason.substr(0, reason.find('\n')));
        }
    }
    return text.empty() ? text : "\nfailed\n" + text;
}

}  // namespace

std::string sweep_plan_text(const twin::SweepStudy& study, const std::vector<twin::SweepPoint>& points)
{
    std::string text = fmt::format("{}\n  base case {}\n", study.name, study.base);
    if (!study.note.empty()) {
        text += fmt::format("  {}\n", study.note);
    }
    if (!study.overrides.empty()) {
        text += fmt::format("  in all points {}\n", fmt::join(study.overrides, ", "));
    }
    std::size_t places = 0;
    for (std::size_t s = 0; s < study.sets.size(); ++s) {
        const auto& set = study.sets[s];
        std::size_t of_set = 1;
        std::string axes;
        for (const auto& axis : set.axes) {
            of_set *= axis.values.size();
            axes += axis_text(axis);
        }
        places += of_set;
        text += fmt::format("  {}, {}\n{}", set.name, counted(of_set, "point", "points"),
                            axes.empty() ? "    the base case\n" : axes);
    }
    text += fmt::format("  {} to compute", counted(points.size(), "distinct point", "distinct points"));
    if (places > points.size()) {
        text += fmt::format(" for {} places; shared:", places);
        for (const auto& point : points) {
            if (point.places.size() > 1) {
                text += fmt::format(" {} ({})", point.name, counted(point.places.size(), "place", "places"));
            }
        }
    }
    return text + "\n";
}

std::string sweep_text(const SweepResult& result)
{
    const auto figures = sweep_figures(result);
    const auto windows = sweep_windows(result);
    std::string text = fmt::format("\n{}\n", result.study.name);
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        text += set_text(result, s, figures, windows[s]);
    }
    text += failures_text(result);
    text += "\n  um: E_SW, above zero the gap opens; warmest: rise at the end; heat: of all joints at the end\n";
    if (const auto limits = limits_text(result.study.limits); !limits.empty()) {
        text += fmt::format("  limits: {}\n", limits);
    }
    return text;
}

}  // namespace deadpoint::report
