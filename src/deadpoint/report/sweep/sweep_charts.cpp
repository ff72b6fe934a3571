#include "deadpoint/report/sweep/sweep_charts.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

namespace deadpoint::report {
namespace {

constexpr std::size_t most_curves = 8;
constexpr double wide_range = 8;  ///< ratio of largest to smallest number above which an axis may be logarithmic

/// The places along the first axis, in the order in which they are drawn.
struct Line {
    std::vector<std::size_t> points;  ///< of the study
    std::vector<std::string> labels;
    std::vector<double> x;
    std::vector<ChartTick> ticks;  ///< empty: numbers
    std::string x_label;
    bool ordered = false;
    /// Steps without order have their own fields instead of lying on the chart's edges.
    [[nodiscard]] double margin() const { return ordered || x.size() < 2 ? 0 : 0.5; }
};

/// Largest over smallest distance of neighbours.
double unevenness(const std::vector<double>& places)
{
    double largest = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < places.size(); ++i) {
        largest = std::max(largest, places[i] - places[i - 1]);
        smallest = std::min(smallest, places[i] - places[i - 1]);
    }
    return largest / smallest;
}

/// "5e7" rather than "5e+07".
std::string short_number(double number)
{
    std::string text = fmt::format("{:g}", number);
    for (const auto& [from, to] : {std::pair{"e+0", "e"}, std::pair{"e+", "e"}, std::pair{"e-0", "e-"}}) {
        if (const auto at = text.find(from); at != std::string::npos) {
            text.replace(at, std::string_view(from).size(), to);
        }
    }
    return text;
}

/// Where the steps of an axis stand: by number, by its logarithm where that spreads a wide range more evenly, or side
/// by side.
void place_steps(const twin::SweepAxis& axis, const std::vector<std::size_t>& order, Line& line)
{
    const auto numbers = axis_numbers(axis);
    line.ordered = !numbers.values.empty();
    line.x_label = numbers.unit.empty() ? axis.name : fmt::format("{} [{}]", axis.name, numbers.unit);
    if (!line.ordered) {
        for (std::size_t i = 0; i < order.size(); ++i) {
            line.x.push_back(static_cast<double>(i));
            line.ticks.push_back({line.x.back(), axis.labels[order[i]]});
        }
        return;
    }
    for (const std::size_t step : order) {
        line.x.push_back(numbers.values[step]);
    }
    if (line.x.front() <= 0 || line.x.back() < wide_range * line.x.front()) {
        return;
    }
    std::vector<double> logarithms;
    for (const double number : line.x) {
        logarithms.push_back(std::log10(number));
    }
    if (unevenness(logarithms) < unevenness(line.x)) {
        for (std::size_t i = 0; i < order.size(); ++i) {
            line.ticks.push_back({logarithms[i], short_number(line.x[i])});
        }
        line.x = std::move(logarithms);
    }
}

Line first_axis(const SweepResult& result, std::size_t set)
{
    const auto& axes = result.study.sets[set].axes;
    const auto points = points_of_set(result, set);
    if (axes.empty()) {
        return {points, {"base case"}, {0}, {{0, "base case"}}, "", false};
    }
    std::vector<std::size_t> order(axes[0].values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!axes[0].numbers.empty()) {
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return axes[0].numbers[i]; });
    }
    Line line;
    place_steps(axes[0], order, line);
    const std::size_t below = points.size() / order.size();  // number of combinations of the other axes
    for (const std::size_t step : order) {
        line.points.push_back(points[step * below]);
        line.labels.push_back(axes[0].labels[step]);
    }
    return line;
}

/// Other axes and the steps at which they are held.
std::string held(const twin::SweepSet& set)
{
    std::string text;
    for (std::size_t a = 1; a < set.axes.size(); ++a) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", set.axes[a].name, set.axes[a].labels.front());
    }
    return text;
}

std::string subtitle(const twin::SweepSet& set, const std::string& text)
{
    const auto others = held(set);
    return others.empty() ? text : fmt::format("{}; at {}", text, others);
}

/// At most so many, evenly spread, the first and the last among them.
std::vector<std::size_t> spread_choice(std::size_t count, std::size_t most)
{
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < std::min(count, most); ++i) {
        chosen.push_back(count <= most ? i : i * (count - 1) / (most - 1));
    }
    return chosen;
}

ChartSeries drift_series(const press::RunRecord& run, const std::string& name)
{
    ChartSeries series;
    series.name = name;
    for (std::size_t k = 0; k < run.time.size(); ++k) {
        series.x.push_back(run.time[k] / hour);
        series.y.push_back(micrometre * run.chain.at("E_SW")[k]);
    }
    return series;
}

void add_step(ChartSeries& series, double x, std::optional<double> y)
{
    series.x.push_back(x);
    series.y.push_back(y.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (y) {
        series.markers.push_back({x, *y});
    }
}

Chart over_axis(const SweepResult& result, std::size_t set, const Line& line)
{
    Chart chart;
    chart.title = fmt::format("{}: {}", result.study.name, result.study.sets[set].name);
    chart.x_label = line.x_label;
    chart.x_ticks = line.ticks;
    chart.x_margin = line.margin();
    return chart;
}

/// A horizontal line over the whole axis.
ChartSeries limit_series(const Line& line, const std::string& name, double limit, int colour)
{
    ChartSeries series;
    series.name = name;
    series.dashed = true;
    series.colour = colour;
    series.x = {line.x.front() - line.margin(), line.x.back() + line.margin()};
    series.y = {micrometre * limit, micrometre * limit};
    return series;
}

/// Names of the sets in those of their files, each once.
std::vector<std::string> file_stems(const std::vector<twin::SweepSet>& sets)
{
    std::vector<std::string> stems;
    for (const auto& set : sets) {
        std::string stem = twin::folder_safe(set.name);
        if (stem.starts_with('.')) {
            stem = fmt::format("_{}", stem);
        }
        if (std::ranges::find(stems, stem) != stems.end()) {
            stem += fmt::format("-{}", stems.size() + 1);
        }
        stems.push_back(stem);
    }
    return stems;
}

bool has_values(const Chart& chart)
{
    return std::ranges::any_of(chart.series, [](const ChartSeries& s) {
        return !s.dashed && std::ranges::any_of(s.y, [](double y) { return std::isfinite(y); });
    });
}

/// The runs over time: all of a small set, else those along the first axis.
Line lines_over_time(const SweepResult& result, std::size_t set)
{
    const auto& described = result.study.sets[set];
    const auto all = points_of_set(result, set);
    Line line = first_axis(result, set);
    if (all.size() > most_curves || described.axes.size() < 2) {
        return line;
    }
    line.points = all;
    line.labels.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        line.labels.push_back(place_label(described, steps_at(described, i)));
    }
    return line;
}

}  // namespace

std::set<std::size_t> points_over_time(const SweepResult& result)
{
    std::set<std::size_t> points;
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        const Line line = lines_over_time(result, s);
        for (const std::size_t i : spread_choice(line.points.size(), most_curves)) {
            points.insert(line.points[i]);
        }
    }
    return points;
}

Chart sweep_drift_chart(const SweepResult& result, std::size_t set)
{
    const auto& described = result.study.sets[set];
    const Line line = lines_over_time(result, set);
    const bool whole = points_of_set(result, set).size() <= most_curves;
    Chart chart;
    chart.title = fmt::format("{}: {}", result.study.name, described.name);
    const std::string about = "E_SW at bottom dead point, above zero the gap opens";
    chart.subtitle = whole ? about : subtitle(described, about);
    chart.x_label = "time [h]";
    chart.y_label = "E_SW [um]";
    const auto chosen = spread_choice(line.points.size(), most_curves);
    if (chosen.size() < line.points.size()) {
        chart.subtitle += fmt::format("; {} of {} steps", chosen.size(), line.points.size());
    }
    for (const std::size_t i : chosen) {
        const auto& run = result.records[line.points[i]];
        if (run && run->chain.contains("E_SW")) {
            chart.series.push_back(drift_series(*run, line.labels[i]));
        }
    }
    return chart;
}

Chart sweep_rise_chart(const SweepResult& result, std::size_t set)
{
    const Line line = first_axis(result, set);
    Chart chart = over_axis(result, set, line);
    chart.subtitle = subtitle(result.study.sets[set], "rise of the probes at the end");
    chart.y_label = "rise [K]";
    std::vector<std::string> probes;
    for (const std::size_t p : line.points) {
        for (const auto& probe : result.records[p] ? result.records[p]->probes : std::vector<std::string>()) {
            if (std::ranges::find(probes, probe) == probes.end()) {
                probes.push_back(probe);
            }
        }
    }
    for (const auto& probe : probes) {
        ChartSeries series;
        series.name = probe;
        series.joined = line.ordered;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const auto& run = result.records[line.points[i]];
            const bool known = run && run->rises.contains(probe);
            add_step(series, line.x[i], known ? std::optional(run->rises.at(probe).back()) : std::nullopt);
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Chart sweep_limit_chart(const SweepResult& result, std::size_t set)
{
    const Line line = first_axis(result, set);
    Chart chart = over_axis(result, set, line);
    chart.subtitle = subtitle(result.study.sets[set], "magnitude of E_SW: its largest value, and that at the end");
    chart.y_label = "|E_SW| [um]";
    ChartSeries largest, final;
    largest.name = "largest";
    final.name = "at the end";
    largest.joined = final.joined = line.ordered;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const auto& run = result.records[line.points[i]];
        const auto drift = run ? sweep_figures(*run).drift : std::nullopt;
        add_step(largest, line.x[i], drift ? std::optional(micrometre * std::abs(drift->largest)) : std::nullopt);
        add_step(final, line.x[i], drift ? std::optional(micrometre * std::abs(drift->final)) : std::nullopt);
    }
    chart.series = {std::move(largest), std::move(final)};
    const auto& limits = result.study.limits;
    if (limits.largest) {
        chart.series.push_back(limit_series(line, "limit of the largest", *limits.largest, 0));
    }
    if (limits.final) {
        chart.series.push_back(limit_series(line, "limit at the end", *limits.final, 1));
    }
    return chart;
}

void write_sweep_charts(const std::filesystem::path& folder, const SweepResult& result,
                        const std::vector<std::string>& comments)
{
    const auto windows = sweep_windows(result);
    const auto stems = file_stems(result.study.sets);
    for (std::size_t s = 0; s < result.study.sets.size(); ++s) {
        const auto& stem = stems[s];
        const auto write = [&](const char* what, const Chart& chart) {
            if (has_values(chart)) {
                write_svg_chart(folder / fmt::format("{}-{}.svg", stem, what), chart, comments);
            }
        };
        const Chart limits = sweep_limit_chart(result, s);
        write("drift", sweep_drift_chart(result, s));
        write("rises", sweep_rise_chart(result, s));
        write("limits", limits);
        if (result.study.sets[s].axes.size() == 2 && has_values(limits)) {
            write_file(folder / fmt::format("{}-map.svg", stem),
                       svg_comments(comments) + sweep_map(result, s, windows[s]));
        }
    }
}

}  // namespace deadpoint::report
