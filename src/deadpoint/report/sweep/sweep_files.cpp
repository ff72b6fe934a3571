#include "deadpoint/report/sweep/sweep_files.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/sweep/sweep_charts.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/drift_columns.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;
using Figures = std::vector<std::optional<SweepFigures>>;
using Windows = std::vector<std::optional<twin::DriftWindow>>;
namespace sweep_table = schema::sweep;

/// One place of one set: a row of the table.
struct SweepRow {
    std::size_t set;
    std::vector<std::size_t> steps;
    std::size_t point;
};

std::vector<SweepRow> rows_of(const SweepResult& result)
{
    std::vector<SweepRow> rows;
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        const auto points = points_of_set(result, s);
        for (std::size_t i = 0; i < points.size(); ++i) {
            rows.push_back({s, steps_at(result.study.sets[s], i), points[i]});
        }
    }
    return rows;
}

bool limited(const twin::DriftLimits& limits) { return limits.largest || limits.final; }

bool keeps_limits(const SweepResult& result, const SweepFigures& figures)
{
    return twin::keeps(result.study.limits, magnitudes(figures));
}

bool in_window(const std::optional<twin::DriftWindow>& window, const std::vector<std::size_t>& steps)
{
    if (!window || window->points == 0) {
        return false;
    }
    for (std::size_t a = 0; a < steps.size(); ++a) {
        if (std::ranges::find(window->steps[a], steps[a]) == window->steps[a].end()) {
            return false;
        }
    }
    return true;
}

// ---------------------------------------------------------------- table

class TableWriter {
public:
    TableWriter(const SweepResult& result, const Figures& figures, const Windows& windows)
        : result_(result), figures_(figures), windows_(windows), rows_(rows_of(result))
    {
        for (const auto& set : result.study.sets) {
            auto& numbers = numbers_.emplace_back();
            for (const auto& axis : set.axes) {
                numbers.push_back(axis_numbers(axis));
            }
        }
    }

    std::vector<CsvColumn> run()
    {
        texts(sweep_table::set, [&](const SweepRow& row) { return result_.study.sets[row.set].name; });
        texts(sweep_table::point, [&](const SweepRow& row) { return result_.points[row.point].name; });
        texts(sweep_table::state, [&](const SweepRow& row) { return state_name(result_.outcomes[row.point].state); });
        axes();
        drift();
        rises();
        figure(sweep_table::heat, [](const SweepFigures& f) { return f.joint_heat.value_or(no_value); });
        bearing_forces();
        if (limited(result_.study.limits)) {
            texts(sweep_table::keeps, [&](const SweepRow& row) {
                const auto& figures = figures_[row.point];
                return !figures ? "" : keeps_limits(result_, *figures) ? "yes" : "no";
            });
            texts(sweep_table::window,
                  [&](const SweepRow& row) { return in_window(windows_[row.set], row.steps) ? "yes" : "no"; });
        }
        numbers(sweep_table::wall_time, [&](const SweepRow& row) {
            const auto& outcome = result_.outcomes[row.point];
            return outcome.state == twin::PointOutcome::State::left ? no_value : outcome.seconds;
        });
        texts(sweep_table::reason, [&](const SweepRow& row) {
            std::string reason = result_.outcomes[row.point].reason;
            std::ranges::replace(reason, '\n', ' ');  // many programs cannot read line breaks inside a cell
            return reason;
        });
        return std::move(columns_);
    }

private:
    template <class Of>
    void texts(const schema::Column& column, Of&& of, const std::string& name = {})
    {
        std::vector<std::string> values;
        for (const auto& row : rows_) {
            values.emplace_back(of(row));
        }
        columns_.push_back(csv_column(column, std::move(values), name));
    }
    template <class Of>
    void numbers(const schema::Column& column, Of&& of, const std::string& name = {}, const std::string& unit = {})
    {
        std::vector<double> values;
        for (const auto& row : rows_) {
            values.push_back(of(row));
        }
        columns_.push_back(csv_column(column, std::move(values), name, unit));
    }
    template <class Of>
    void figure(const schema::Column& column, Of&& of, const std::string& name = {})
    {
        numbers(
            column, [&](const SweepRow& row) { return figures_[row.point] ? of(*figures_[row.point]) : no_value; },
            name);
    }

    /// The axis of a set with a given name, and its position in the set.
    [[nodiscard]] const twin::SweepAxis* axis_of(const SweepRow& row, const std::string& name, std::size_t& place) const
    {
        const auto& axes = result_.study.sets[row.set].axes;
        const auto found = std::ranges::find(axes, name, &twin::SweepAxis::name);
        place = static_cast<std::size_t>(found - axes.begin());
        return found == axes.end() ? nullptr : &*found;
    }

    /// Axes with the same name share columns; numbers with the same unit do as well.
    void axes()
    {
        std::vector<std::string> names;
        std::vector<std::pair<std::string, std::string>> units;
        for (std::size_t s = 0; s < result_.study.sets.size(); ++s) {
            for (std::size_t a = 0; a < result_.study.sets[s].axes.size(); ++a) {
                const auto& axis = result_.study.sets[s].axes[a];
                if (std::ranges::find(names, axis.name) == names.end()) {
                    names.push_back(axis.name);
                }
                const std::pair unit{axis.name, numbers_[s][a].unit};
                if (!axis.numbers.empty() && std::ranges::find(units, unit) == units.end()) {
                    units.push_back(unit);
                }
            }
        }
        for (const auto& name : names) {
            texts(
                sweep_table::axis,
                [&](const SweepRow& row) {
                    std::size_t a = 0;
                    const auto* axis = axis_of(row, name, a);
                    return axis == nullptr ? std::string() : axis->labels[row.steps[a]];
                },
                name);
            for (const auto& unit : units) {
                if (unit.first == name) {
                    axis_column(name, unit.second);
                }
            }
        }
    }

    void axis_column(const std::string& name, const std::string& unit)
    {
        const auto value = [&](const SweepRow& row) {
            std::size_t a = 0;
            const auto* axis = axis_of(row, name, a);
            if (axis == nullptr) {
                return no_value;
            }
            const auto& numbers = numbers_[row.set][a];
            return numbers.values.empty() || numbers.unit != unit ? no_value : numbers.values[row.steps[a]];
        };
        numbers(sweep_table::axis_value, value, name, unit);
    }

    void drift()
    {
        for (const auto& [column, value] : drift_columns) {
            figure(column, [of = value](const SweepFigures& f) { return f.drift ? of(*f.drift) : no_value; });
        }
    }

    void rises()
    {
        std::vector<std::string> probes;
        for (const auto& record : result_.records) {
            for (const auto& probe : record ? record->probes : std::vector<std::string>()) {
                if (std::ranges::find(probes, probe) == probes.end()) {
                    probes.push_back(probe);
                }
            }
        }
        for (const auto& probe : probes) {
            figure(
                sweep_table::rise,
                [&](const SweepFigures& f) { return f.rises.contains(probe) ? f.rises.at(probe) : no_value; }, probe);
        }
    }

    void bearing_forces()
    {
        std::map<std::string, double> names;
        for (const auto& figures : figures_) {
            if (figures) {
                names.insert(figures->bearing_forces.begin(), figures->bearing_forces.end());
            }
        }
        for (const auto& [name, value] : names) {
            const auto force = [&key = name](const SweepFigures& f) {
                return f.bearing_forces.contains(key) ? f.bearing_forces.at(key) : no_value;
            };
            figure(sweep_table::bearing_force, force, name);
        }
    }

    const SweepResult& result_;
    const Figures& figures_;
    const Windows& windows_;
    std::vector<SweepRow> rows_;
    std::vector<std::vector<AxisNumbers>> numbers_;  ///< per set and axis
    std::vector<CsvColumn> columns_;
};

// ---------------------------------------------------------------- JSON

Json optional(const std::optional<double>& value, double factor)
{
    return value ? Json(factor * *value) : Json(nullptr);
}

Json window_json(const twin::SweepSet& set, const std::optional<twin::DriftWindow>& window)
{
    if (!window) {
        return nullptr;
    }
    Json json{{"text", window_text(set, window)}, {"points", window->points}, {"share_of_range", window->share}};
    json["axes"] = Json::object();
    for (std::size_t a = 0; a < window->steps.size(); ++a) {
        Json steps = Json::array();
        for (const std::size_t step : window->steps[a]) {
            steps.push_back(set.axes[a].labels[step]);
        }
        json["axes"][set.axes[a].name] = steps;
    }
    return json;
}

Json set_json(const twin::SweepSet& set, const std::optional<twin::DriftWindow>& window)
{
    Json json{{"name", set.name}, {"axes", Json::array()}};
    for (const auto& axis : set.axes) {
        Json entry{{"name", axis.name}, {"keys", axis.keys}, {"values", axis.values}, {"labels", axis.labels}};
        if (const auto numbers = axis_numbers(axis); !numbers.values.empty()) {
            entry["unit"] = numbers.unit;
            entry["numbers"] = numbers.values;
        }
        json["axes"].push_back(entry);
    }
    json["window"] = window_json(set, window);
    return json;
}

Json figures_json(const SweepResult& result, const SweepFigures& figures)
{
    Json json = Json::object();
    if (figures.drift) {
        const auto& d = *figures.drift;
        json["E_SW"] = {
            {"largest_um", micrometre * d.largest}, {"largest_at_s", d.largest_time}, {"end_um", micrometre * d.final}};
        if (d.gap) {
            json["E_SW"]["first_hour_change_um"] = micrometre * d.gap->first_hour_change;
            json["E_SW"]["range_um"] = micrometre * d.gap->range;
            json["E_SW"]["steady_from_s"] = optional(d.gap->steady_from, 1);
        }
    }
    json["rises_at_end_K"] = figures.rises;
    json["joint_heat_at_end_W"] = optional(figures.joint_heat, 1);
    if (!figures.bearing_forces.empty()) {
        json["bearing_peak_forces_N"] = figures.bearing_forces;
    }
    if (limited(result.study.limits)) {
        json["keeps_limits"] = keeps_limits(result, figures);
    }
    return json;
}

Json point_json(const SweepResult& result, const Figures& figures, std::size_t p)
{
    const auto& point = result.points[p];
    const auto& outcome = result.outcomes[p];
    Json json{{"name", point.name}, {"state", state_name(outcome.state)}, {"seconds", outcome.seconds}};
    if (!outcome.reason.empty()) {
        json["reason"] = outcome.reason;
    }
    json["overrides"] = point.overrides;
    json["places"] = Json::array();
    for (const auto& place : point.places) {
        const auto& set = result.study.sets[place.set];
        Json steps = Json::object();
        for (std::size_t a = 0; a < place.steps.size(); ++a) {
            steps[set.axes[a].name] = set.axes[a].labels[place.steps[a]];
        }
        json["places"].push_back({{"set", set.name}, {"steps", steps}});
    }
    if (result.records[p]) {
        json["case_hash"] = result.records[p]->hash;
        json["interrupted"] = result.records[p]->interrupted;
    }
    json["figures"] = figures[p] ? figures_json(result, *figures[p]) : Json(nullptr);
    return json;
}

Json sweep_json(const SweepResult& result, const Figures& figures, const Windows& windows,
                const std::vector<std::string>& warnings)
{
    Json json;
    json["version"] = version;
    json["study"] = {{"name", result.study.name},
                     {"note", result.study.note},
                     {"base", result.study.base},
                     {"overrides", result.study.overrides}};
    if (!result.reduced_model.empty()) {
        json["reduced_model"] = result.reduced_model;
    }
    json["warnings"] = warnings;
    json["limits"] = {{"largest_um", optional(result.study.limits.largest, micrometre)},
                      {"end_um", optional(result.study.limits.final, micrometre)}};
    json["sets"] = Json::array();
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        json["sets"].push_back(set_json(result.study.sets[s], windows[s]));
    }
    json["points"] = Json::array();
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        json["points"].push_back(point_json(result, figures, p));
    }
    return json;
}

std::vector<std::string> head(const SweepResult& result, const std::vector<std::string>& warnings)
{
    std::vector<std::string> lines{fmt::format("deadpoint {}", version),
                                   fmt::format("study {}, base case {}", result.study.name, result.study.base)};
    for (const auto& record : result.records) {
        if (record && lines.size() == 2) {
            lines.push_back(fmt::format("machine {}", record->machine));
        }
    }
    for (const auto& warning : warnings) {
        lines.push_back("warning: " + warning);
    }
    return lines;
}

}  // namespace

void write_sweep_files(const std::filesystem::path& folder, const SweepResult& result,
                       const std::vector<std::string>& warnings)
{
    const auto figures = sweep_figures(result);
    const auto windows = sweep_windows(result);
    const auto comments = head(result, warnings);
    write_table(folder / "sweep.csv", comments, TableWriter(result, figures, windows).run());
    write_json(folder / "sweep.json", sweep_json(result, figures, windows, warnings));
    write_sweep_charts(folder, result, comments);
    write_manifest(folder);
}

}  // namespace deadpoint::report
