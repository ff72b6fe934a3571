#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Line charts as SVG, for reports and papers: light grid, colours that colour-blind readers can tell apart (Okabe and
/// Ito), each line named at its right end instead of in a box.
namespace deadpoint::report {

inline constexpr double letter_width = 6.6;  ///< mean, at 12 px

struct ChartPoint {
    double x = 0;
    double y = 0;
};

struct ChartSeries {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;            ///< a value that is not finite interrupts the line
    std::vector<ChartPoint> markers;  ///< hollow circles in the line's colour, e.g. measured values
    bool dashed = false;
    bool emphasised = false;  ///< drawn thicker
    bool joined = true;       ///< false: markers only, for a horizontal axis without order
    int colour = -1;          ///< index into the palette; -1: by the place in the list
};

/// A tick of the horizontal axis with a text of its own.
struct ChartTick {
    double x = 0;
    std::string text;
};

struct Chart {
    std::string title;
    std::string subtitle;  ///< grey, below the title; may be empty
    std::string x_label;   ///< with unit, e.g. "time [h]"
    std::string y_label;
    std::vector<ChartSeries> series;
    std::string marker_note;         ///< what the hollow circles are; may be empty
    bool include_zero = true;        ///< the vertical axis reaches 0
    std::vector<ChartTick> x_ticks;  ///< in place of numbers; a text without room is left out
    double x_margin = 0;             ///< room left and right of x_ticks, in their unit
    double x_step = 0;               ///< between the ticks of the horizontal axis; 0: chosen
    int name_letters = 0;            ///< room for the names of the lines, to align charts; 0: as the longest needs
    double width = 860;              ///< [px]
    double height = 480;
};

/// The chart as an SVG document.
std::string svg_chart(const Chart& chart);

/// The beginning of such a document, for drawings with the same fonts and the same place of title and subtitle: the
/// classes are title, sub, tick, label and name. "</svg>" ends it.
std::string svg_head(double width, double height, const std::string& title, const std::string& subtitle);

/// A line of text; `anchor` is "start", "middle" or "end", `style` more attributes.
std::string svg_text(double x, double y, const std::string& anchor, const std::string& style, const std::string& text);

/// Lines as XML comments for the head of an SVG document.
std::string svg_comments(const std::vector<std::string>& comments);

/// Writes svg_chart(chart), with `comments` (version, case hash) as XML comments; complete or absent.
/// @throws IoError if the file cannot be written
void write_svg_chart(const std::filesystem::path& path, const Chart& chart,
                     const std::vector<std::string>& comments = {});

/// Round positions (1, 2 or 5 times a power of ten apart) that cover low..high with about `wanted` steps.
std::vector<double> nice_ticks(double low, double high, int wanted);

}  // namespace deadpoint::report
