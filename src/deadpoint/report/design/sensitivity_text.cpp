#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/design/shown_figures.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/explore/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::report {
namespace {

using twin::FigureSensitivity;

constexpr std::size_t most_parameters = 8;  // of a figure on the terminal

double size_of(const FigureSensitivity& figure, std::size_t k)
{
    return figure.morris.empty() ? figure.sobol.inputs[k].total.value : figure.morris[k].strength.value;
}

std::vector<std::size_t> strongest(const FigureSensitivity& figure, std::size_t parameters)
{
    std::vector<std::size_t> order(parameters);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t k) {
        const double size = size_of(figure, k);
        return std::isfinite(size) ? size : -1;
    });
    return order;
}

std::string share(const design::Band& band)
{
    return fmt::format("{:.2f}  ({:.2f} to {:.2f})", band.value, band.low, band.high);
}

std::string name_of(const twin::SensitivityResult& result, const twin::Figure& figure)
{
    const auto& name = result.outputs[figure.output].name;
    switch (figure.kind) {
    case twin::Figure::Kind::warm:
        return fmt::format("{}, time to warm (95 %)", name);
    case twin::Figure::Kind::end:
        return fmt::format("{} at the end", name);
    default:
        return fmt::format("{} after {}", name, figure_name(figure));
    }
}

std::string title_of(const SensitivityReport& report, const FigureSensitivity& figure)
{
    const auto title = name_of(report.result, figure.figure);
    if (!figure.morris.empty())
        return title;
    const auto value = shown_figure(figure.figure, report.result.outputs);
    const auto difference = shown_difference(figure.figure, report.result.outputs);
    return fmt::format("{}: {} {} on average, standard deviation {} {}", title,
                       significant(value.of(figure.sobol.mean), 4), value.unit,
                       significant(difference.factor * std::sqrt(figure.sobol.variance), 3), difference.unit);
}

std::string figure_text(const SensitivityReport& report, const FigureSensitivity& figure)
{
    std::string text = fmt::format("\n{}\n", title_of(report, figure));
    const auto count = report.result.ranges.size();
    const auto order = strongest(figure, count);
    if (!std::isfinite(size_of(figure, order.front())))
        return text + "  it does not vary within the ranges\n";
    const bool screening = !figure.morris.empty();
    const auto unit = shown_difference(figure.figure, report.result.outputs);
    TextTable table(screening ? std::vector<std::string>{"parameter", fmt::format("mu* [{}]", unit.unit), "mu", "sigma"}
                              : std::vector<std::string>{"parameter", "first", "total"});
    for (std::size_t place = 0; place < std::min(count, most_parameters); ++place) {
        const auto k = order[place];
        const auto& name = report.result.ranges[k].name;
        if (screening) {
            const auto& effect = figure.morris[k];
            table.add_row({name, significant(unit.factor * effect.strength.value),
                           significant(unit.factor * effect.mean), significant(unit.factor * effect.deviation)});
        } else {
            table.add_row({name, share(figure.sobol.inputs[k].first), share(figure.sobol.inputs[k].total)});
        }
    }
    text += table.text();
    if (count > most_parameters)
        text += fmt::format("  and {} weaker parameters\n", count - most_parameters);
    return text;
}

}  // namespace

std::vector<std::string> vague_figures(const twin::SensitivityResult& result)
{
    std::vector<std::string> texts;
    for (const auto& figure : result.figures) {
        const auto vague = std::ranges::find_if(figure.sobol.inputs, [](const design::SobolIndex& index) {
            return index.total.high - index.total.low > 1;
        });
        if (vague == figure.sobol.inputs.end())
            continue;
        const auto place = static_cast<std::size_t>(vague - figure.sobol.inputs.begin());
        texts.push_back(fmt::format(
            "{}: the points do not tell the indices well (total index of {}: {:.1f} to {:.1f}); "
            "take more points, or narrower ranges where single points lie far off",
            name_of(result, figure.figure), result.ranges[place].name, vague->total.low, vague->total.high));
    }
    return texts;
}

std::string sensitivity_text(const SensitivityReport& report)
{
    std::string text;
    for (const auto& figure : report.result.figures)
        text += figure_text(report, figure);
    text += report.result.figures.front().morris.empty()
                ? "\n  first: share of the variance that a parameter explains alone; total: with its interactions;\n"
                  "  in brackets the band of 90 %\n"
                : "\n  mu*: mean size of the effect over the whole range of a parameter; sigma: its scatter\n";
    text += fmt::format("{} runs in {}\n", report.result.runs, duration_text(report.seconds));
    return text;
}

}  // namespace deadpoint::report
