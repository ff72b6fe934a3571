#pragma once

#include "deadpoint/core/quantity.hpp"

#include <string>
#include <vector>

namespace deadpoint::twin {
struct Figure;
struct ForwardOutput;
struct VariedRange;
}  // namespace deadpoint::twin

/// Internal to report/design: names and units of figures and ranges.
namespace deadpoint::report {

/// From SI units to those that are shown: factor * value + offset.
struct Shown {
    std::string unit;
    double factor = 1;
    double offset = 0;
    [[nodiscard]] double of(double value) const { return factor * value + offset; }
};

/// "end", "30 min" or "time to warm".
std::string figure_name(const twin::Figure& figure);
/// Unit of a figure's values: um, degC, or h for times.
Shown shown_figure(const twin::Figure& figure, const std::vector<twin::ForwardOutput>& outputs);
/// Unit of a figure's differences: um, K or h.
Shown shown_difference(const twin::Figure& figure, const std::vector<twin::ForwardOutput>& outputs);
/// Unit of a range's values: the preferred one, none for factors.
Shown shown_range(const twin::VariedRange& range);
/// Both ends: "x 0.5 to 2", "200 to 400 rpm".
std::string range_text(const twin::VariedRange& range);

}  // namespace deadpoint::report
