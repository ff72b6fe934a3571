#include "deadpoint/report/compare/compare_files.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/press/compare/compare.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <utility>

namespace deadpoint::report {
namespace {

using press::ComparedCurve;
using press::ComparedGroup;
using press::ComparedValue;
using press::Comparison;
using press::ErrorFigures;
using press::Verdict;
using Json = nlohmann::ordered_json;

/// Units in which values are shown; temperatures in kelvin, so that their errors are in kelvin too.
struct Shown {
    const char* unit;
    double factor;
};
Shown shown(Dimension dimension)
{
    switch (dimension) {
    case Dimension::temperature:
    case Dimension::temperature_difference:
        return {"K", 1};
    case Dimension::length:
        return {"um", micrometre};
    case Dimension::time:
        return {"s", 1};
    case Dimension::force:
        return {"N", 1};
    case Dimension::power:
        return {"W", 1};
    default:
        return {"", 1};
    }
}
/// Lengths among the loads are strokes and the like.
Shown shown(press::ValueKind kind, Dimension dimension)
{
    const bool of_loads = kind == press::ValueKind::loads && dimension == Dimension::length;
    return of_loads ? Shown{"mm", 1e3} : shown(dimension);
}

std::string number(double value) { return significant(value, 4); }
std::string signed_number(double value) { return fmt::format("{}{}", value > 0 ? "+" : "", number(value)); }

std::string percent(const std::optional<double>& share)
{
    return share ? fmt::format("{:+.1f} %", 100 * *share) : std::string("-");
}

const char* status(bool calibrated) { return calibrated ? "calibrated" : "predicted"; }

const char* outcome(Verdict::Outcome o)
{
    switch (o) {
    case Verdict::Outcome::holds:
        return "holds";
    case Verdict::Outcome::fails:
        return "does not hold";
    default:
        return "not checked";
    }
}

struct Sheet {
    std::vector<std::string> titles;
    std::vector<std::vector<std::string>> rows;
    std::size_t left = 1;  ///< number of left-aligned columns
};

std::string full_name(const ComparedValue& v)
{
    return v.group == name_of(v.kind) ? v.name : fmt::format("{} ({})", v.name, v.group);
}

Sheet value_sheet(const Comparison& c)
{
    Sheet sheet{{"value", "unit", "reference", "computed", "error", "relative"}, {}, 2};
    const bool with_baseline = !c.baseline.empty();
    if (with_baseline)
        sheet.titles.emplace_back("baseline");
    sheet.titles.emplace_back();
    for (const auto& v : c.values) {
        const auto [unit, factor] = shown(v.kind, v.dimension);
        sheet.rows.push_back({full_name(v), unit, number(factor * v.reference), number(factor * v.computed),
                              signed_number(factor * v.error()), percent(v.relative_error())});
        if (with_baseline)
            sheet.rows.back().push_back(v.baseline ? number(factor * *v.baseline) : "-");
        sheet.rows.back().emplace_back(status(v.calibrated));
    }
    return sheet;
}

std::vector<std::string> figure_row(const std::string& name, const ErrorFigures& f, Shown s,
                                    const std::string& largest_at)
{
    const auto baseline = [&](const std::optional<double>& rms) { return rms ? number(s.factor * *rms) : "-"; };
    return {name,
            s.unit,
            std::to_string(f.count),
            number(s.factor * f.rms),
            signed_number(s.factor * f.bias),
            fmt::format("{} ({})", signed_number(s.factor * f.largest), largest_at),
            baseline(f.rms_nothing),
            baseline(f.rms_mean),
            baseline(f.rms_baseline)};
}

std::string set_name(const ComparedGroup& g)
{
    return g.group == name_of(g.kind) ? g.group : fmt::format("{}: {}", name_of(g.kind), g.group);
}

Sheet figure_sheet(const Comparison& c)
{
    Sheet sheet{
        {"set", "unit", "values", "rms", "bias", "largest", "rms: no change", "rms: mean", "rms: baseline"}, {}, 2};
    const auto add = [&](std::vector<std::string> row, bool calibrated) {
        if (c.baseline.empty())
            row.pop_back();
        row.emplace_back(status(calibrated));
        sheet.rows.push_back(std::move(row));
    };
    if (c.baseline.empty())
        sheet.titles.pop_back();
    sheet.titles.emplace_back();
    for (const auto& g : c.groups)
        add(figure_row(set_name(g), g.figures, shown(g.kind, g.dimension), g.largest_name), g.calibrated);
    for (const auto& curve : c.curves)
        add(figure_row(curve.name, curve.figures, shown(curve.dimension),
                       duration_text(curve.time[curve.figures.largest_at])),
            curve.calibrated);
    return sheet;
}

std::string table_text(const Sheet& sheet)
{
    TextTable table(sheet.titles);
    for (std::size_t i = 0; i < sheet.left; ++i)
        table.align_left(i);
    table.align_left(sheet.titles.size() - 1);
    for (const auto& row : sheet.rows)
        table.add_row(row);
    return table.text();
}

/// Text of a page that is Markdown, where '<' would begin HTML.
std::string markdown_text(const std::string& text)
{
    std::string result;
    for (const char c : one_line(text))
        result += c == '<' ? std::string("&lt;") : std::string(1, c);
    return result;
}

/// A bar would end the cell of a table.
std::string markdown_cell(const std::string& text)
{
    std::string result;
    for (const char c : markdown_text(text))
        result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

std::string table_markdown(const Sheet& sheet)
{
    const auto line = [](const std::vector<std::string>& cells) {
        std::string text = "|";
        for (const auto& cell : cells)
            text += fmt::format(" {} |", markdown_cell(cell));
        return text + "\n";
    };
    std::string text = line(sheet.titles) + "|";
    for (std::size_t i = 0; i < sheet.titles.size(); ++i)
        text += i < sheet.left || i + 1 == sheet.titles.size() ? "---|" : "--:|";
    text += "\n";
    for (const auto& row : sheet.rows)
        text += line(row);
    return text;
}

std::string title(const press::RunRecord& run, const Comparison& c)
{
    return fmt::format("{} against {}{}", run.machine, c.reference,
                       c.point.empty() ? "" : fmt::format(" at {}", c.point));
}

std::string how_to_read(const press::RunRecord& run, const Comparison& c)
{
    std::string text =
        "Errors are computed less reference; E_SW > 0 opens the gap. Beside the rms stand two baselines: predicting no "
        "change at all, and predicting the mean of the references.";
    if (!c.baseline.empty())
        text += fmt::format(" Baseline: the result in `{}`.", c.baseline);
    if (!run.calibrated_on.empty())
        text +=
            fmt::format(" The case was fitted to the rises marked as calibrated ({} keys); they are not predictions.",
                        run.calibrated_on.size());
    return text;
}

/// Notes of values and curves, each once, with what they belong to.
std::vector<std::string> notes(const Comparison& c)
{
    std::vector<std::pair<std::string, std::string>> found;  // note, names
    const auto add = [&](const std::string& note, const std::string& name) {
        if (note.empty())
            return;
        const auto at = std::ranges::find(found, note, [](const auto& f) { return f.first; });
        if (at == found.end())
            found.emplace_back(note, name);
        else
            at->second += ", " + name;
    };
    for (const auto& v : c.values)
        add(v.note, full_name(v));
    for (const auto& curve : c.curves)
        add(curve.note, curve.name);
    std::vector<std::string> lines;
    for (const auto& [note, names] : found)
        lines.push_back(fmt::format("{}: {}", names, note));
    return lines;
}

Json figures_json(const ErrorFigures& f, Shown s)
{
    const auto optional = [&](const std::optional<double>& v) { return v ? Json(s.factor * *v) : Json(nullptr); };
    return {{"unit", s.unit},
            {"values", f.count},
            {"rms", s.factor * f.rms},
            {"bias", s.factor * f.bias},
            {"largest_error", s.factor * f.largest},
            {"rms_of_no_change", optional(f.rms_nothing)},
            {"rms_of_mean", optional(f.rms_mean)},
            {"rms_of_baseline", optional(f.rms_baseline)}};
}

Json curve_json(const ComparedCurve& curve)
{
    const auto s = shown(curve.dimension);
    Json json{{"name", curve.name}, {"measures", curve.measures}, {"calibrated", curve.calibrated}};
    json["figures"] = figures_json(curve.figures, s);
    json["largest_error_at_s"] = curve.time[curve.figures.largest_at];
    if (!curve.note.empty())
        json["note"] = curve.note;
    json["time_s"] = curve.time;
    const auto column = [&](const std::vector<double>& values) {
        Json list = Json::array();
        for (const double value : values)
            list.push_back(s.factor * value);
        return list;
    };
    json["reference"] = column(curve.reference);
    json["computed"] = column(curve.computed);
    if (!curve.baseline.empty())
        json["baseline"] = column(curve.baseline);
    return json;
}

/// "agreement 83 % (...)"; empty if there is none.
std::string agreement_text(const Comparison& c)
{
    const auto found = press::agreement(c);
    if (!found)
        return {};
    return fmt::format("agreement {:.0f} % over {} {}{}: 100 % is as measured, 0 % as far off as predicting no change",
                       100 * found->value, found->sets, found->sets == 1 ? "set" : "sets",
                       found->calibrated ? " to which the case was fitted" : "");
}

bool is_temperature(Dimension dimension)
{
    return dimension == Dimension::temperature || dimension == Dimension::temperature_difference;
}

/// The values of a chart of computed over measured: rises of temperature or the dimension chain.
std::vector<ChartSeries> compared_points(const press::RunRecord& run, const Comparison& c, bool of_chain)
{
    std::map<std::string, ChartSeries> sets;
    const auto add = [&](const std::string& name, double factor, double reference, double computed) {
        auto& series = sets[name];
        series.name = name;
        series.joined = false;
        series.markers.push_back({factor * reference, factor * computed});
    };
    for (const auto& v : c.values)
        if (v.kind == (of_chain ? press::ValueKind::chain : press::ValueKind::rises))
            add(v.group, shown(v.dimension).factor, v.reference, v.computed);
    for (const auto& curve : c.curves) {
        const double start = curve.dimension == Dimension::temperature ? run.initial_temperature : 0;
        for (std::size_t k = 0; k < curve.time.size() && is_temperature(curve.dimension) != of_chain; ++k)
            add(curve.name, shown(curve.dimension).factor, curve.reference[k] - start, curve.computed[k] - start);
    }
    std::vector<ChartSeries> result;
    for (auto& [name, series] : sets)
        result.push_back(std::move(series));
    return result;
}

/// Computed over measured with the line on which they are equal; none without values.
std::optional<Chart> agreement_chart(const press::RunRecord& run, const Comparison& c, bool of_chain)
{
    Chart chart;
    chart.series = compared_points(run, c, of_chain);
    if (chart.series.empty())
        return std::nullopt;
    double low = chart.series[0].markers[0].x, high = low;
    for (const auto& series : chart.series)
        for (const auto& [x, y] : series.markers) {
            low = std::min({low, x, y});
            high = std::max({high, x, y});
        }
    ChartSeries equal{"as measured", {low, high}, {low, high}, {}};
    equal.dashed = true;
    chart.series.push_back(std::move(equal));
    chart.title = title(run, c);
    chart.subtitle = agreement_text(c);
    chart.x_label = of_chain ? "measured [um]" : "measured rise [K]";
    chart.y_label = of_chain ? "computed [um]" : "computed rise [K]";
    chart.include_zero = false;
    return chart;
}

Json compare_json(const press::RunRecord& run, const Comparison& c)
{
    Json json;
    json["version"] = version;
    json["case"] = {{"name", run.machine}, {"hash", run.hash}};
    json["result"] = run.folder;
    json["reference"] = {{"name", c.reference}, {"source", c.source}, {"point", c.point}};
    json["baseline"] = c.baseline.empty() ? Json(nullptr) : Json(c.baseline);
    json["warnings"] = c.warnings;
    json["calibrated_on"] = run.calibrated_on;
    const auto agreed = press::agreement(c);
    json["agreement"] = agreed ? Json(agreed->value) : Json(nullptr);
    json["agreement_sets"] = agreed ? agreed->sets : 0;
    json["sets"] = Json::array();
    for (const auto& g : c.groups) {
        Json set{{"kind", name_of(g.kind)}, {"group", g.group}, {"calibrated", g.calibrated}};
        set.update(figures_json(g.figures, shown(g.kind, g.dimension)));
        set["largest_error_of"] = g.largest_name;
        json["sets"].push_back(set);
    }
    json["values"] = Json::array();
    for (const auto& v : c.values) {
        const auto s = shown(v.kind, v.dimension);
        Json value{{"kind", name_of(v.kind)},
                   {"group", v.group},
                   {"name", v.name},
                   {"unit", s.unit},
                   {"reference", s.factor * v.reference},
                   {"computed", s.factor * v.computed},
                   {"error", s.factor * v.error()},
                   {"baseline", v.baseline ? Json(s.factor * *v.baseline) : Json(nullptr)},
                   {"relative_error", v.relative_error() ? Json(*v.relative_error()) : Json(nullptr)},
                   {"calibrated", v.calibrated}};
        if (!v.note.empty())
            value["note"] = v.note;
        json["values"].push_back(value);
    }
    json["curves"] = Json::array();
    for (const auto& curve : c.curves)
        json["curves"].push_back(curve_json(curve));
    json["claims"] = Json::array();
    for (const auto& v : c.verdicts) {
        Json claim{{"text", v.text}, {"kind", v.kind}, {"verdict", outcome(v.outcome)}, {"evidence", v.evidence}};
        if (!v.note.empty())
            claim["note"] = v.note;
        json["claims"].push_back(claim);
    }
    return json;
}

}  // namespace

std::string compare_text(const press::RunRecord& run, const Comparison& c)
{
    std::string text = fmt::format("\n{}\n", title(run, c));
    if (const auto values = value_sheet(c); !values.rows.empty())
        text += fmt::format("\n{}", table_text(values));
    if (const auto figures = figure_sheet(c); !figures.rows.empty())
        text += fmt::format("\n{}  errors are computed less reference; E_SW > 0 opens the gap\n", table_text(figures));
    if (const auto agreed = agreement_text(c); !agreed.empty())
        text += fmt::format("  {}\n", agreed);
    if (!run.calibrated_on.empty() &&
        std::ranges::any_of(c.groups, [](const ComparedGroup& g) { return g.calibrated; }))
        text += "  the case was fitted to the rises marked as calibrated: they are no prediction\n";
    if (!c.verdicts.empty())
        text += "\n  claims\n";
    for (const auto& v : c.verdicts)
        text += fmt::format("  {:<14}{}\n  {:<14}  {}\n", outcome(v.outcome), v.text, "", v.evidence);
    return text;
}

std::string compare_page(const press::RunRecord& run, const Comparison& c, const std::vector<std::string>& charts)
{
    std::string text = xml_comment(fmt::format("deadpoint {}, case {}, hash {}", version, run.machine, run.hash));
    text += fmt::format("# {}\n\nReference: {}\n", markdown_text(title(run, c)), markdown_text(c.source));
    if (!c.note.empty())
        text += fmt::format("\n{}\n", markdown_text(c.note));
    for (const auto& warning : c.warnings)
        text += fmt::format("\n**Warning:** {}\n", markdown_text(warning));
    text += fmt::format("\n{}\n", markdown_text(how_to_read(run, c)));
    if (const auto figures = figure_sheet(c); !figures.rows.empty())
        text += fmt::format("\n## Errors\n{}", table_markdown(figures));
    if (const auto agreed = agreement_text(c); !agreed.empty())
        text +=
            fmt::format("\n**{}.** The share is 1 - sqrt(mean over the sets of (rms / rms of no change)^2).\n", agreed);
    for (const auto& name : charts)
        text += fmt::format("\n![Computed over measured]({})\n", name);
    if (const auto values = value_sheet(c); !values.rows.empty())
        text += fmt::format("\n## Values\n{}", table_markdown(values));
    if (!c.verdicts.empty()) {
        Sheet claims{{"claim", "verdict", "what the result shows", "note"}, {}, 3};
        for (const auto& v : c.verdicts)
            claims.rows.push_back({v.text, outcome(v.outcome), v.evidence, v.note});
        text += fmt::format("\n## Claims\n{}", table_markdown(claims));
    }
    if (const auto lines = notes(c); !lines.empty()) {
        text += "\n## Notes\n";
        for (const auto& line : lines)
            text += fmt::format("- {}\n", markdown_text(line));
    }
    return text;
}

void write_compare_files(const std::filesystem::path& stem, const press::RunRecord& run, const Comparison& c,
                         IfThere if_there)
{
    const auto with = [&](const char* extension) {
        std::filesystem::path path = stem;
        return path += extension;
    };
    std::vector<std::string> drawn;
    for (const bool of_chain : {false, true}) {
        const auto* ending = compare_endings[of_chain ? 3 : 2];
        const auto chart = agreement_chart(run, c, of_chain);
        if (!chart) {
            continue;
        }
        write_file(with(ending), svg_chart(*chart), if_there);
        record_file(with(ending));
        drawn.push_back(with(ending).filename().string());
    }
    write_json(with(".json"), compare_json(run, c), if_there);
    write_file(with(".md"), compare_page(run, c, drawn), if_there);
    record_file(with(".json"));
    record_file(with(".md"));
}

}  // namespace deadpoint::report
