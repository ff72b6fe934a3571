#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/kind_of_file.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/casefile/syntax/reader.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/io/csv_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <set>
#include <utility>

namespace deadpoint::casefile {
namespace {

Dimension measured_dimension(ReferenceCurve::Measures measures)
{
    using enum ReferenceCurve::Measures;
    if (measures == temperature) {
        return Dimension::temperature;
    }
    return measures == rise ? Dimension::temperature_difference : Dimension::length;
}

/// Checks what spans several values of the file, reads its curves, and holds it against a result.
class ReferenceChecker {
public:
    ReferenceChecker(ReferenceFile& file, const Document& document, Diagnostics& diagnostics,
                     const ResultContents* result)
        : file_(file), document_(document), diagnostics_(diagnostics), result_(result)
    {}

    void run(const std::string& wanted)
    {
        each("rises", file_.rises, wanted, [&](auto& r, const auto& at) { check(r, at); });
        each("curves", file_.curves, wanted, [&](auto& c, const auto& at) { check(c, at); });
        each("chain", file_.chain, wanted, [&](auto& c, const auto& at) { check(c, at); });
        each("times", file_.times, wanted, [&](auto& t, const auto& at) { check(t, at); });
        each("loads", file_.loads, wanted, [&](auto& l, const auto& at) { check(l, at); });
        each("claims", file_.claims, wanted, [&](auto& c, const auto& at) { check(c, at); });
    }

private:
    void report(std::string code, std::string path, std::string message, std::string help)
    {
        const Place place = place_of(document_.root, path);
        diagnostics_.add({Severity::error, std::move(code), place, std::move(path), std::move(message), std::move(help),
                          std::nullopt, ""});
    }

    /// Checks every item of a list, and items of the wanted point also against the result; drops items of other points.
    template <class T, class Check>
    void each(const std::string& list, std::vector<T>& items, const std::string& wanted, Check&& check)
    {
        std::vector<T> kept;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const std::string at = fmt::format("{}.{}", list, i);
            if (!items[i].point.empty() && !file_.points.contains(items[i].point)) {
                unknown(at + ".point", "operating point", items[i].point, names_of(file_.points), "the file");
            }
            against_result_ = result_ != nullptr && items[i].point == wanted;
            check(items[i], at);
            if (items[i].point == wanted) {
                kept.push_back(std::move(items[i]));
            }
        }
        items = std::move(kept);
    }

    void unknown(const std::string& path, std::string_view kind, const std::string& name,
                 const std::vector<std::string>& names, std::string_view owner)
    {
        const std::string near = closest_name(name, names);
        const std::string known = names.size() > 20 ? "" : fmt::format("; it has: {}", fmt::join(names, ", "));
        report("unknown-name", path, fmt::format("there is no {} '{}'", kind, name),
               !near.empty()   ? fmt::format("did you mean '{}'?", near)
               : names.empty() ? fmt::format("{} has no {} at all", owner, kind)
                               : fmt::format("name one that {} has{}", owner, known));
    }

    void check_probe(const std::string& path, const std::string& name)
    {
        if (against_result_ && !name.empty() && std::ranges::find(result_->probes, name) == result_->probes.end()) {
            unknown(path, "probe", name, result_->probes, "the result");
        }
    }

    void check_dimension(const std::string& path)
    {
        if (against_result_ && result_->dimensions.empty()) {
            report("no-drift", path, "the result has no dimension chain",
                   "compute a case with [chain], or remove this value");
        }
    }

    void check_time(const std::string& path, double time)
    {
        if (against_result_ && time > result_->end * (1 + same_time)) {
            report("beyond-the-run", path,
                   fmt::format("the time {} lies beyond the {}, which ends after {}",
                               format_quantity(time, Dimension::time), result_->interrupted ? "interrupted run" : "run",
                               format_quantity(result_->end, Dimension::time)),
                   "compute a longer run, or leave the value out; check the unit of the times");
        }
    }

    void check(const ReferenceRises& r, const std::string& at)
    {
        check_time(at + ".time", r.time);
        for (const auto& [probe, rise] : r.values) {
            check_probe(at + ".values." + probe, probe);
        }
    }

    void check(const ReferenceChain& c, const std::string& at)
    {
        check_dimension(at + ".dimension");
        if (c.time) {
            check_time(at + ".time", *c.time);
        }
    }

    void check(const ReferenceTime& t, const std::string& at)
    {
        if (t.of == ReferenceTime::Of::largest_E_SW) {
            check_dimension(at + ".of");
        }
        check_probe(at + ".probe", t.probe);
    }

    /// Returns how far a path leads into loads.json, and how it can continue from there.
    [[nodiscard]] std::string next_steps(const std::string& path) const
    {
        std::set<std::string> steps;
        std::string there = path + ".";
        while (steps.empty() && !there.empty()) {
            there.erase(there.size() - 1);
            there.erase(there.find_last_of('.') == std::string::npos ? 0 : there.find_last_of('.') + 1);
            for (const auto& figure : result_->loads) {
                if (figure.starts_with(there)) {
                    steps.insert(figure.substr(there.size(), figure.find('.', there.size()) - there.size()));
                }
            }
        }
        return fmt::format("after '{}' it has: {}; a figure of another operating point names that with `point`", there,
                           fmt::join(steps, ", "));
    }

    void check(const ReferenceLoad& l, const std::string& at)
    {
        if (against_result_ && result_->has_loads &&
            std::ranges::find(result_->loads, l.quantity) == result_->loads.end()) {
            const std::string near = closest_name(l.quantity, result_->loads);
            report("unknown-name", at + ".quantity", fmt::format("there is no figure of loads.json '{}'", l.quantity),
                   near.empty() ? next_steps(l.quantity) : fmt::format("did you mean '{}'?", near));
            return;
        }
        const auto given = l.force    ? Dimension::force
                           : l.length ? Dimension::length
                           : l.power  ? Dimension::power
                                      : Dimension::none;
        if (const auto unit = load_unit(l.quantity); unit.dimension != given) {
            report("unit-mismatch", at + ".quantity",
                   fmt::format("by its name the figure is {}", unit.dimension == Dimension::none
                                                                   ? "neither a force nor a length nor a power"
                                                                   : dimension_info(unit.dimension).name),
                   unit.dimension == Dimension::none ? "give its value as `number`, in the unit of its name"
                                                     : "give its value under the key that fits");
        }
    }

    void check(const ReferenceClaim& c, const std::string& at)
    {
        for (std::size_t i = 0; i < c.probes.size(); ++i) {
            check_probe(fmt::format("{}.probes.{}", at, i), c.probes[i]);
        }
        for (std::size_t i = 0; i < c.than.size(); ++i) {
            check_probe(fmt::format("{}.than.{}", at, i), c.than[i]);
        }
        using enum ReferenceClaim::Kind;
        constexpr std::array of_the_gap{peak_within, declines, slows, closes, opens};
        if (std::ranges::find(of_the_gap, *c.kind) != of_the_gap.end()) {
            check_dimension(at + ".kind");
        }
        if (c.time) {
            check_time(at + ".time", *c.time);
        }
    }

    void check(ReferenceCurve& c, const std::string& at)
    {
        using enum ReferenceCurve::Measures;
        if (c.measures == temperature || c.measures == rise) {
            check_probe(at + ".probe", c.probe);
        } else {
            check_dimension(at + ".measures");
        }
        try {
            read_curve(c, at);
        } catch (const Error& error) {
            const auto said = split_help(error.what());
            report("curve", at + ".file", said.message, said.help);
        }
    }

    void read_curve(ReferenceCurve& c, const std::string& at)
    {
        const auto table = read_csv(c.file);
        const auto times = table.column(c.time_column);
        const auto values = table.column(c.column);
        c.time = in_si(table, times, c.time_unit, Dimension::time, at, "time_unit");
        c.value = in_si(table, values, c.unit, measured_dimension(*c.measures), at, "unit");
        if (c.name.empty()) {
            c.name = fmt::format("{} of {}", c.column, std::filesystem::path(c.file).filename().string());
        }
        if (c.time.empty() || c.value.empty()) {
            return;
        }
        if (c.opposite_sign) {
            std::ranges::transform(c.value, c.value.begin(), std::negate<>());
        }
        table.require_increasing(c.time);
        if (c.until) {
            const auto end = std::ranges::upper_bound(c.time, *c.until * (1 + same_time));
            c.value.resize(static_cast<std::size_t>(end - c.time.begin()));
            c.time.erase(end, c.time.end());
        }
        if (c.time.empty()) {
            throw InputError(fmt::format("{}: no row is left\n  help: make `until` later", c.file));
        }
        if (c.time.front() < 0) {
            throw InputError(
                fmt::format("{}: the times begin before the run\n  help: count them from its start", c.file));
        }
        check_time(at + ".file", c.time.back());
    }

    /// Reads a column in SI units; its unit comes from the key or else from its heading.
    std::vector<double> in_si(const CsvTable& table, std::size_t column, const std::string& stated, Dimension dimension,
                              const std::string& at, const std::string& key)
    {
        const std::string unit = stated.empty() ? table.columns[column].unit : stated;
        const auto zero = try_parse_quantity("0 " + unit, dimension);
        const auto one = try_parse_quantity("1 " + unit, dimension);
        if (const auto* problem = std::get_if<QuantityProblem>(&one)) {
            report(problem->code, stated.empty() ? at + ".file" : at + "." + key,
                   unit.empty()
                       ? fmt::format("the column '{}' of '{}' states no unit", table.columns[column].name, table.file)
                       : problem->message,
                   unit.empty() ? fmt::format("add it to the heading, like \"{} [{}]\", or give `{}`",
                                              table.columns[column].name, dimension_info(dimension).preferred, key)
                                : problem->help);
            return {};
        }
        if (table.rows.empty()) {
            throw InputError(
                fmt::format("{}: there are no rows below the headings\n  help: add the values", table.file));
        }
        auto values = table.numbers(column);
        const double offset = std::get<double>(zero);
        const double factor = std::get<double>(one) - offset;
        for (double& value : values) {
            value = offset + factor * value;
        }
        return values;
    }

    ReferenceFile& file_;
    const Document& document_;
    Diagnostics& diagnostics_;
    const ResultContents* result_;
    bool against_result_ = false;
};

void require_point(const ReferenceFile& file, const std::string& path, const std::string& point)
{
    if (point.empty() || file.points.contains(point)) {
        return;
    }
    const auto names = names_of(file.points);
    const std::string near = closest_name(point, names);
    throw InputError(fmt::format("{}: there is no operating point '{}'\n  help: {}", path, point,
                                 !near.empty()   ? fmt::format("did you mean '{}'?", near)
                                 : names.empty() ? "the file has no [points]; leave --point out"
                                                 : fmt::format("it has: {}", fmt::join(names, ", "))));
}

/// Everything the file says, not yet held against a result; its curves are not read yet.
ReferenceFile parse_reference(const std::filesystem::path& path, Document& document, Diagnostics& diagnostics)
{
    document = load_document(path, {}, diagnostics, FileAccess::anywhere);
    if (diagnostics.error_count() == 0) {
        require_kind(document, KindOfFile::reference, diagnostics);
    }
    stop_at_errors(diagnostics, "the reference file; nothing was compared");
    ReferenceFile file;
    Reader(document, diagnostics, nullptr).read(file);
    stop_at_errors(diagnostics, "the reference file; nothing was compared");
    return file;
}

bool is_empty(const ReferenceFile& f)
{
    return f.rises.empty() && f.curves.empty() && f.chain.empty() && f.times.empty() && f.loads.empty() &&
           f.claims.empty();
}

}  // namespace

LoadUnit load_unit(std::string_view path)
{
    // Components of a pair end in their index: "mean_N.0".
    if (const auto index = path.find_last_not_of("0123456789"); index != std::string_view::npos && path[index] == '.') {
        path = path.substr(0, index);
    }
    constexpr std::array<std::pair<std::string_view, LoadUnit>, 4> units{{{"_N", {Dimension::force, 1}},
                                                                          {"_mm", {Dimension::length, 1e-3}},
                                                                          {"_um", {Dimension::length, 1e-6}},
                                                                          {"_W", {Dimension::power, 1}}}};
    for (const auto& [ending, unit] : units) {
        if (path.ends_with(ending)) {
            return unit;
        }
    }
    return {};
}

ReferenceFile read_reference(const std::filesystem::path& path, const std::string& point, const ResultContents* result)
{
    Diagnostics diagnostics;
    Document document;
    ReferenceFile file = parse_reference(path, document, diagnostics);
    require_point(file, path.string(), point);
    ReferenceChecker(file, document, diagnostics, result).run(point);
    stop_at_errors(diagnostics, "the reference file; nothing was compared");
    if (is_empty(file)) {
        const auto names = names_of(file.points);
        throw InputError(point.empty() ? fmt::format("{}: all values belong to operating points\n  help: name one with "
                                                     "--point: {}",
                                                     path.string(), fmt::join(names, ", "))
                                       : fmt::format("{}: no value belongs to the operating point '{}'\n  help: name "
                                                     "it in the `point` of a value",
                                                     path.string(), point));
    }
    return file;
}

std::map<std::string, ReferencePoint> reference_points(const std::filesystem::path& path)
{
    Diagnostics diagnostics;
    Document document;
    return parse_reference(path, document, diagnostics).points;
}

}  // namespace deadpoint::casefile
