#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/design/shown_figures.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/explore/optimise.hpp"

#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using twin::DesignFigures;

std::string variables_text(const twin::OptimiseResult& result)
{
    TextTable table({"variable", "before", "optimum", "unit", "range"});
    for (std::size_t v = 0; v < result.ranges.size(); ++v) {
        const auto shown = shown_range(result.ranges[v]);
        const auto at = [&](const design::Point& point) {
            return significant(shown.of(result.ranges[v].value_at(point[v])), 4);
        };
        table.add_row({result.ranges[v].name, at(result.starts.front().start),
                       at(result.starts[result.best].minimum.at), shown.unit, range_text(result.ranges[v])});
    }
    return table.text();
}

std::string warm_text(const DesignFigures& figures)
{
    return figures.warm ? duration_text(*figures.warm) : "not reached";
}

std::string micrometres(double value) { return fmt::format("{:.2f} um", micrometre * value); }

std::string limit_value(const casefile::OptimiseLimit& limit, double value)
{
    const bool length = limit.output.starts_with("E_") || limit.output.starts_with("corner ");
    return length ? micrometres(value) : fmt::format("{:.2f} degC", value - zero_celsius);
}

std::string figures_text(const OptimiseReport& report)
{
    const auto& section = *report.study.optimise;
    const auto& result = report.result;
    std::vector<std::string> titles{"", "before", "promised"};
    if (report.full)
        titles.emplace_back("full run");
    TextTable table(titles);
    const auto row = [&](const std::string& name, auto&& of) {
        std::vector<std::string> cells{name, of(result.before), of(result.after)};
        if (report.full)
            cells.push_back(of(report.full->figures));
        table.add_row(std::move(cells));
    };
    if (section.rate > 0)
        row(fmt::format("warm (below {:.3g} um/h) after", section.rate * micrometre * 3600), warm_text);
    const auto since = section.from > 0 ? fmt::format(" since {}", duration_text(section.from)) : "";
    row("change of E_SW" + since + ", rms", [](const DesignFigures& f) { return micrometres(f.drift); });
    row("change of E_SW" + since + ", largest", [](const DesignFigures& f) { return micrometres(f.largest_change); });
    if (result.after.ambient)
        row("E_SW per kelvin of the room, rms", [](const DesignFigures& f) {
            return f.ambient ? fmt::format("{:.3f} um/K", micrometre * *f.ambient) : "-";
        });
    for (std::size_t l = 0; l < section.limits.size(); ++l) {
        const auto& limit = section.limits[l];
        row(fmt::format("{} ({}{})", limit.output,
                        limit.most.empty() ? "at least " + limit.least : "at most " + limit.most,
                        limit.most.empty() || limit.least.empty() ? "" : ", at least " + limit.least),
            [&](const DesignFigures& f) { return limit_value(limit, f.extremes[l]); });
    }
    return table.text();
}

std::string starts_text(const twin::OptimiseResult& result)
{
    if (result.starts.size() == 1)
        return "  one start only: another one may end elsewhere\n";
    const auto which = result.best == 0 ? std::string("the case itself") : fmt::format("start {}", result.best + 1);
    return fmt::format("  the best of {} starts is {}; {}\n", result.starts.size(), which,
                       result.minima == 1 ? "all starts end at the same minimum"
                                          : fmt::format("they end at {} different minima", result.minima));
}

}  // namespace

std::string optimise_text(const OptimiseReport& report)
{
    std::string text = fmt::format("\n{}\n\n{}\n", report.study.name, variables_text(report.result));
    text += figures_text(report);
    text += starts_text(report.result);
    if (!report.result.feasible)
        text += "  no point keeps all limits; this one exceeds them least\n";
    if (!report.full)
        text += "  the optimum is a promise of the reduced model; run optimum.toml in full to confirm it\n";
    return text + fmt::format("computed in {}\n", duration_text(report.seconds));
}

}  // namespace deadpoint::report
