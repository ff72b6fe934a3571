#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/sweep/sweep_charts.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::report {
namespace {

constexpr double cell_height = 34;
constexpr double narrowest_cell = 58;
constexpr double top = 112;
constexpr double gap = 46;

/// The steps of an axis in the order in which they are drawn.
std::vector<std::size_t> drawn_order(const twin::SweepAxis& axis)
{
    std::vector<std::size_t> order(axis.values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!axis.numbers.empty()) {
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return axis.numbers[i]; });
    }
    return order;
}

std::size_t longest(const std::vector<std::string>& texts)
{
    std::size_t most = 0;
    for (const auto& text : texts) {
        most = std::max(most, display_width(text));
    }
    return most;
}

/// White to a dark blue whose lightness falls evenly, so that a grey print keeps the order.
std::string colour(double share)
{
    constexpr std::array<double, 3> light{247, 251, 255};
    constexpr std::array<double, 3> dark{8, 48, 107};
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        rgb.at(i) = static_cast<int>(std::lround(light.at(i) + share * (dark.at(i) - light.at(i))));
    }
    return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

/// Both axes of the set, and where each place is drawn.
struct Grid {
    const twin::SweepSet& set;
    std::vector<std::size_t> columns, rows;  ///< steps of the first and the second axis; rows start at the bottom
    std::vector<std::size_t> points;
    double cell_width = narrowest_cell;
    double row_labels = 0;  ///< width of the row labels
    [[nodiscard]] std::size_t point(std::size_t column, std::size_t row) const
    {
        return points[twin::grid_index(set, {columns[column], rows[row]})];
    }
    [[nodiscard]] double height() const { return cell_height * static_cast<double>(rows.size()); }
    [[nodiscard]] double width() const { return cell_width * static_cast<double>(columns.size()); }
    [[nodiscard]] double y(std::size_t row) const
    {
        return top + height() - cell_height * static_cast<double>(row + 1);
    }
};

Grid make_grid(const SweepResult& result, std::size_t set)
{
    const auto& described = result.study.sets[set];
    Grid grid{described, drawn_order(described.axes[0]), drawn_order(described.axes[1]), points_of_set(result, set)};
    grid.cell_width =
        std::max(narrowest_cell, letter_width * static_cast<double>(longest(described.axes[0].labels) + 2));
    grid.row_labels =
        letter_width * static_cast<double>(std::max(longest(described.axes[1].labels) + 1, std::size_t{6}));
    return grid;
}

std::string cell(const Grid& grid, double left, std::size_t column, std::size_t row, const std::optional<double>& value,
                 double largest, const std::string& state)
{
    const double x = left + grid.cell_width * static_cast<double>(column);
    const double share = value && largest > 0 ? *value / largest : 0;
    std::string svg =
        fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
                    "stroke=\"#b0b0b0\" stroke-width=\"0.7\"/>\n",
                    x, grid.y(row), grid.cell_width, cell_height, value ? colour(share) : "url(#missing)");
    const bool on_dark = value && share > 0.5;
    svg += svg_text(x + grid.cell_width / 2, grid.y(row) + cell_height / 2 + 4, "middle",
                    fmt::format("class=\"name\" fill=\"{}\"", on_dark ? "#ffffff" : "#222222"),
                    value ? significant(*value) : state);
    return svg;
}

/// A line around the cells of the window: where a neighbour does not belong to it, the edge is drawn.
std::string outline(const Grid& grid, double left, const twin::DriftWindow& window)
{
    const auto belongs = [&](std::size_t column, std::size_t row) {
        // Indices below zero wrap around and are out of range as well.
        return column < grid.columns.size() && row < grid.rows.size() &&
               std::ranges::find(window.steps[0], grid.columns[column]) != window.steps[0].end() &&
               std::ranges::find(window.steps[1], grid.rows[row]) != window.steps[1].end();
    };
    std::string path;
    for (std::size_t row = 0; row < grid.rows.size(); ++row) {
        for (std::size_t column = 0; column < grid.columns.size(); ++column) {
            if (!belongs(column, row)) {
                continue;
            }
            const double x = left + grid.cell_width * static_cast<double>(column);
            const double y = grid.y(row);
            path += belongs(column - 1, row) ? "" : fmt::format("M{:.1f} {:.1f}v{:.1f}", x, y, cell_height);
            path += belongs(column + 1, row)
                        ? ""
                        : fmt::format("M{:.1f} {:.1f}v{:.1f}", x + grid.cell_width, y, cell_height);
            path += belongs(column, row + 1) ? "" : fmt::format("M{:.1f} {:.1f}h{:.1f}", x, y, grid.cell_width);
            path += belongs(column, row - 1)
                        ? ""
                        : fmt::format("M{:.1f} {:.1f}h{:.1f}", x, y + cell_height, grid.cell_width);
        }
    }
    // White below orange: visible on light and on dark cells, also without colour.
    return fmt::format(
        "<path d=\"{0}\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"6\" stroke-linecap=\"square\"/>\n"
        "<path d=\"{0}\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"3\" stroke-linecap=\"square\"/>\n",
        path);
}

std::string panel(const SweepResult& result, const Grid& grid, double left, const std::string& title,
                  const std::vector<std::optional<double>>& values, const std::optional<twin::DriftWindow>& window)
{
    std::string svg = svg_text(left, top - 14, "start", "class=\"label\" font-weight=\"bold\"", title);
    double largest = 0;
    for (const std::size_t p : grid.points) {
        largest = std::max(largest, values[p].value_or(0));
    }
    for (std::size_t row = 0; row < grid.rows.size(); ++row) {
        for (std::size_t column = 0; column < grid.columns.size(); ++column) {
            const auto p = grid.point(column, row);
            const auto state = result.outcomes[p].state;
            const bool computed = state == twin::PointOutcome::State::done || state == twin::PointOutcome::State::kept;
            svg += cell(grid, left, column, row, values[p], largest, computed ? "no chain" : state_name(state));
        }
        svg += svg_text(left - 8, grid.y(row) + cell_height / 2 + 4, "end", "class=\"tick\"",
                        grid.set.axes[1].labels[grid.rows[row]]);
    }
    for (std::size_t column = 0; column < grid.columns.size(); ++column) {
        svg += svg_text(left + grid.cell_width * (static_cast<double>(column) + 0.5), top + grid.height() + 18,
                        "middle", "class=\"tick\"", grid.set.axes[0].labels[grid.columns[column]]);
    }
    svg +=
        svg_text(left + grid.width() / 2, top + grid.height() + 40, "middle", "class=\"label\"", grid.set.axes[0].name);
    svg += svg_text(left - 8, top - 14, "end", "class=\"label\"", grid.set.axes[1].name);
    if (window && window->points > 0) {
        svg += outline(grid, left, *window);
    }
    return svg;
}

}  // namespace

std::string sweep_map(const SweepResult& result, std::size_t set, const std::optional<twin::DriftWindow>& window)
{
    if (result.study.sets.at(set).axes.size() != 2) {
        throw DomainError("a map needs a set of two axes");
    }
    const Grid grid = make_grid(result, set);
    std::vector<std::optional<double>> largest, final;
    for (const auto& figures : sweep_figures(result)) {
        const bool known = figures && figures->drift;
        largest.push_back(known ? std::optional(micrometre * std::abs(figures->drift->largest)) : std::nullopt);
        final.push_back(known ? std::optional(micrometre * std::abs(figures->drift->final)) : std::nullopt);
    }
    const auto limits = limits_text(result.study.limits);
    const std::string title = fmt::format("{}: {}", result.study.name, result.study.sets[set].name);
    const std::string subtitle =
        limits.empty() ? "magnitude of the drift E_SW in um"
                       : fmt::format("magnitude of the drift E_SW in um; outlined: {}", window_text(grid.set, window));
    const double row_labels =
        std::max(grid.row_labels, letter_width * static_cast<double>(display_width(grid.set.axes[1].name) + 1));
    const double left = 24 + row_labels;
    const double second = left + grid.width() + gap + row_labels;
    const double wide =
        std::max(second + grid.width() + 24, letter_width * 1.12 * static_cast<double>(display_width(subtitle)) + 40);
    const double title_width = 9.6 * static_cast<double>(display_width(title)) + 40;
    std::string svg =
        svg_head(std::max(wide, title_width), top + grid.height() + (limits.empty() ? 56 : 78), title, subtitle);
    svg += "<defs><pattern id=\"missing\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
           "patternTransform=\"rotate(45)\"><rect width=\"7\" height=\"7\" fill=\"#ffffff\"/><line x1=\"0\" y1=\"0\" "
           "x2=\"0\" y2=\"7\" stroke=\"#d0d0d0\" stroke-width=\"2\"/></pattern></defs>\n";
    svg += panel(result, grid, left, "largest", largest, window);
    svg += panel(result, grid, second, "at the end", final, window);
    if (!limits.empty()) {
        svg += svg_text(20, top + grid.height() + 66, "start", "class=\"sub\"", "limits: " + limits);
    }
    return svg + "</svg>\n";
}

}  // namespace deadpoint::report
