#include "deadpoint/report/design/shown_figures.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/explore/figures.hpp"
#include "deadpoint/twin/explore/varied.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

// "30 min", "2 h"; other times as duration_text().
std::string time_text(double seconds)
{
    if (std::fmod(seconds, 3600) == 0)
        return fmt::format("{:.0f} h", seconds * hours);
    return std::fmod(seconds, 60) == 0 && seconds < 3600 ? fmt::format("{:.0f} min", seconds / 60)
                                                         : duration_text(seconds);
}

bool is_probe(const twin::Figure& figure, const std::vector<twin::ForwardOutput>& outputs)
{
    return outputs[figure.output].kind == twin::ForwardOutput::Kind::probe;
}

}  // namespace

std::string figure_name(const twin::Figure& figure)
{
    switch (figure.kind) {
    case twin::Figure::Kind::end:
        return "end";
    case twin::Figure::Kind::warm:
        return "time to warm";
    default:
        return time_text(figure.time);
    }
}

Shown shown_difference(const twin::Figure& figure, const std::vector<twin::ForwardOutput>& outputs)
{
    if (figure.kind == twin::Figure::Kind::warm)
        return {"h", hours, 0};
    return is_probe(figure, outputs) ? Shown{"K", 1, 0} : Shown{"um", micrometre, 0};
}

Shown shown_figure(const twin::Figure& figure, const std::vector<twin::ForwardOutput>& outputs)
{
    if (figure.kind != twin::Figure::Kind::warm && is_probe(figure, outputs))
        return {"degC", 1, -zero_celsius};
    return shown_difference(figure, outputs);
}

Shown shown_range(const twin::VariedRange& range)
{
    if (range.kind == twin::VariedRange::Kind::factor || range.dimension == Dimension::none)
        return {};
    const bool temperature = range.dimension == Dimension::temperature;
    if (temperature && range.kind == twin::VariedRange::Kind::shift)
        return {"K", 1, 0};
    if (temperature)
        return {"degC", 1, -zero_celsius};
    const auto& info = dimension_info(range.dimension);
    const double one = parse_quantity(fmt::format("1 {}", info.preferred), range.dimension);
    return {std::string(info.preferred), 1 / one, 0};
}

std::string range_text(const twin::VariedRange& range)
{
    const auto shown = shown_range(range);
    const auto low = fmt::format("{:.4g}", shown.of(range.low)), high = fmt::format("{:.4g}", shown.of(range.high));
    if (range.kind == twin::VariedRange::Kind::factor)
        return fmt::format("x {} to {}", low, high);
    if (range.kind == twin::VariedRange::Kind::shift)
        return fmt::format("{} to +{} {}", low, high, shown.unit);
    return fmt::format("{} to {} {}", low, high, shown.unit);
}

}  // namespace deadpoint::report
