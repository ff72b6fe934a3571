#include "deadpoint/report/tables/svg_chart.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace deadpoint::report {
namespace {

// Okabe and Ito, "Color Universal Design", without yellow, which is too faint for lines on white.
constexpr std::array<const char*, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#56b4e9", "#e69f00", "#222222"};
constexpr const char* ink = "#222222";
constexpr const char* grey = "#6b6b6b";
constexpr const char* grid = "#e3e3e3";
constexpr double label_pitch = 15;

struct AxisRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value)
    {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    [[nodiscard]] bool empty() const { return !(low <= high); }
};

/// Maps data to places on the page.
struct Frame {
    double left = 0, right = 0, top = 0, bottom = 0;
    AxisRange x, y;
    double y_step = 1;  ///< between the ticks of the vertical axis
    [[nodiscard]] double at_x(double value) const { return left + (value - x.low) / (x.high - x.low) * (right - left); }
    [[nodiscard]] double at_y(double value) const
    {
        return bottom - (value - y.low) / (y.high - y.low) * (bottom - top);
    }
};

/// A tick's number with as many decimals as its step needs, and a true minus sign.
std::string tick_text(double value, double step)
{
    if (std::abs(value) < 1e-9 * step) {
        return "0";
    }
    const double size = std::abs(value);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    std::string text = size < 1e6 && decimals <= 5 ? fmt::format("{:.{}f}", size, decimals) : fmt::format("{:g}", size);
    return value < 0 ? "\u2212" + text : text;
}

void pad(AxisRange& range, bool include_zero)
{
    if (range.empty()) {
        range = {0, 1};
    }
    if (include_zero) {
        range.add(0);
        // A curve that falls below zero by less than its line width needs no space there.
        if (range.low > -0.005 * range.high) {
            range.low = 0;
        }
    }
    if (range.high - range.low <= 1e-12 * std::max(std::abs(range.low), std::abs(range.high))) {
        range = {range.low - 0.5, range.high + 0.5};
    }
}

Frame make_frame(const Chart& chart)
{
    Frame frame;
    std::size_t longest = static_cast<std::size_t>(std::max(4, chart.name_letters));
    for (const auto& series : chart.series) {
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            if (std::isfinite(series.y[i])) {
                frame.x.add(series.x[i]);
                frame.y.add(series.y[i]);
            }
        }
        for (const auto& point : series.markers) {
            frame.x.add(point.x);
            frame.y.add(point.y);
        }
        longest = std::max(longest, display_width(series.name));
    }
    for (const auto& tick : chart.x_ticks) {
        frame.x.add(tick.x - chart.x_margin);
        frame.x.add(tick.x + chart.x_margin);
    }
    pad(frame.x, false);
    pad(frame.y, chart.include_zero);
    const auto ticks = nice_ticks(frame.y.low, frame.y.high, 6);
    frame.y = {ticks.front(), ticks.back()};
    frame.y_step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
    frame.left = 62;
    frame.right = chart.width - 46 - letter_width * static_cast<double>(longest);
    frame.top = chart.subtitle.empty() ? (chart.title.empty() ? 34 : 74) : 92;
    frame.bottom = chart.height - 56;
    return frame;
}

/// Multiples of `step` that cover low..high.
std::vector<double> steps_of(double low, double high, double step)
{
    std::vector<double> ticks;
    const double first = std::floor(low / step + 1e-9);
    const double last = std::ceil(high / step - 1e-9);
    const long count = std::lround(last - first);
    for (long i = 0; i <= count; ++i) {
        ticks.push_back((first + static_cast<double>(i)) * step);
    }
    return ticks;
}

/// The given ticks, or round numbers.
std::vector<ChartTick> ticks_of_x(const Chart& chart, const Frame& frame)
{
    if (!chart.x_ticks.empty()) {
        return chart.x_ticks;
    }
    const auto places =
        chart.x_step > 0 ? steps_of(frame.x.low, frame.x.high, chart.x_step) : nice_ticks(frame.x.low, frame.x.high, 6);
    const double step = places.size() > 1 ? places[1] - places[0] : 1;
    const double margin = 1e-9 * step;
    std::vector<ChartTick> ticks;
    for (const double place : places) {
        if (place >= frame.x.low - margin && place <= frame.x.high + margin) {
            ticks.push_back({place, tick_text(place, step)});
        }
    }
    return ticks;
}

std::string axes(const Chart& chart, const Frame& frame)
{
    std::string svg;
    const double y_step = frame.y_step;
    const auto y_ticks = steps_of(frame.y.low, frame.y.high, y_step);
    for (const double tick : y_ticks) {
        const double y = frame.at_y(tick);
        const bool zero = std::abs(tick) < 1e-9 * y_step;
        svg += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n",
                           frame.left, y, frame.right, y, zero ? "#8a8a8a" : grid);
        svg += svg_text(frame.left - 8, y + 4, "end", "class=\"tick\"", tick_text(tick, y_step));
    }
    double free_from = -std::numeric_limits<double>::infinity();
    for (const auto& [place, text] : ticks_of_x(chart, frame)) {
        const double x = frame.at_x(place);
        svg += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#8a8a8a\"/>\n", x,
                           frame.bottom, x, frame.bottom + 5);
        const double half = letter_width * static_cast<double>(display_width(text)) / 2;
        if (x - half >= free_from) {
            svg += svg_text(x, frame.bottom + 20, "middle", "class=\"tick\"", text);
            free_from = x + half + letter_width;
        }
    }
    svg += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#8a8a8a\"/>\n",
                       frame.left, frame.bottom, frame.right, frame.bottom);
    svg += svg_text((frame.left + frame.right) / 2, frame.bottom + 42, "middle", "class=\"label\"", chart.x_label);
    svg += svg_text(20, frame.top - 14, "start", "class=\"label\"", chart.y_label);
    return svg;
}

/// The path of a line. Points that coincide with the previous one are left out; gaps interrupt the path.
std::string path_of(const ChartSeries& series, const Frame& frame)
{
    std::string path;
    bool down = false;
    double last_x = 0;
    double last_y = 0;
    const std::size_t count = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
            down = false;
            continue;
        }
        const double x = frame.at_x(series.x[i]);
        const double y = frame.at_y(series.y[i]);
        if (down && i + 1 < count && std::abs(x - last_x) < 0.5 && std::abs(y - last_y) < 0.5) {
            continue;
        }
        path += fmt::format("{}{:.1f} {:.1f}", down ? "L" : "M", x, y);
        down = true;
        last_x = x;
        last_y = y;
    }
    return path;
}

/// Heights of labels near those wanted, `label_pitch` apart, moved as little as a sweep down and one up can do.
std::vector<double> spread(const std::vector<double>& wanted, double top, double bottom)
{
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
    std::vector<double> result = wanted;
    double least = top;
    for (const std::size_t i : order) {
        result[i] = std::max(result[i], least);
        least = result[i] + label_pitch;
    }
    double most = bottom;
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
        result[*it] = std::min(result[*it], most);
        most = result[*it] - label_pitch;
    }
    return result;
}

std::string lines(const Chart& chart, const Frame& frame)
{
    std::string svg;
    std::vector<double> wanted;
    for (const auto& series : chart.series) {
        double end = frame.bottom;
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
            if (std::isfinite(series.y[i])) {
                end = frame.at_y(series.y[i]);
            }
        }
        wanted.push_back(end);
    }
    const auto label_y = spread(wanted, frame.top, frame.bottom);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const auto& series = chart.series[i];
        const std::size_t place = series.colour < 0 ? i : static_cast<std::size_t>(series.colour);
        const char* colour = palette[place % palette.size()];
        const bool dashed = series.dashed || i / palette.size() % 2 == 1;
        if (series.joined) {
            svg +=
                fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" "
                            "stroke-linecap=\"round\"{}/>\n",
                            path_of(series, frame), colour, series.emphasised ? 3.2 : 1.9,
                            dashed ? " stroke-dasharray=\"6 4\"" : "");
        }
        for (const auto& point : series.markers) {
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#ffffff\" stroke=\"{}\" "
                               "stroke-width=\"1.6\"/>\n",
                               frame.at_x(point.x), frame.at_y(point.y), colour);
        }
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\" "
                           "opacity=\"0.6\"/>\n",
                           frame.right + 7, wanted[i], frame.right + 20, label_y[i], colour);
        svg += svg_text(
            frame.right + 24, label_y[i] + 4, "start",
            fmt::format("class=\"name\" fill=\"{}\"{}", colour, series.emphasised ? " font-weight=\"bold\"" : ""),
            series.name);
    }
    return svg;
}

}  // namespace

std::vector<double> nice_ticks(double low, double high, int wanted)
{
    const double span = high - low;
    if (!(span > 0) || !std::isfinite(span)) {
        return {low};
    }
    const double raw = span / std::max(1, wanted);
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double lead = raw / power;
    const double step = power * (lead <= 1.001 ? 1 : lead <= 2.001 ? 2 : lead <= 5.001 ? 5 : 10);
    return steps_of(low, high, step);
}

std::string svg_text(double x, double y, const std::string& anchor, const std::string& style, const std::string& text)
{
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, style,
                       xml_text(text));
}

std::string svg_head(double width, double height, const std::string& title, const std::string& subtitle)
{
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
        "font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
        "sans-serif\">\n<style>.title{{font-size:17px;"
        "font-weight:bold;fill:{2}}}.sub{{font-size:12.5px;fill:{3}}}.tick{{font-size:12px;fill:{3}}}"
        ".label{{font-size:12.5px;fill:{2}}}.name{{font-size:12.5px}}</style>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        width, height, ink, grey);
    svg += svg_text(20, 30, "start", "class=\"title\"", title);
    if (!subtitle.empty()) {
        svg += svg_text(20, 50, "start", "class=\"sub\"", subtitle);
    }
    return svg;
}

std::string svg_chart(const Chart& chart)
{
    const Frame frame = make_frame(chart);
    std::string svg = svg_head(chart.width, chart.height, chart.title, chart.subtitle);
    svg += axes(chart, frame) + lines(chart, frame);
    if (!chart.marker_note.empty()) {
        const double x = frame.right - 6 - letter_width * static_cast<double>(display_width(chart.marker_note));
        svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#ffffff\" stroke=\"{}\" "
                           "stroke-width=\"1.6\"/>\n",
                           x - 10, frame.top - 18, grey);
        svg += svg_text(x, frame.top - 14, "start", "class=\"tick\"", chart.marker_note);
    }
    return svg + "</svg>\n";
}

std::string svg_comments(const std::vector<std::string>& comments)
{
    std::string head;
    for (const auto& text : comments) {
        head += xml_comment(text);
    }
    return head;
}

void write_svg_chart(const std::filesystem::path& path, const Chart& chart, const std::vector<std::string>& comments)
{
    write_file(path, svg_comments(comments) + svg_chart(chart));
}

}  // namespace deadpoint::report
