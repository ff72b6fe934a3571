#include "deadpoint/casefile/studies/measured_curves.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/csv_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace deadpoint::casefile {
namespace {

constexpr std::array<std::string_view, 5> dimensions{"E_SW", "E_BG", "E_WG", "E_CS", "E_BC"};
constexpr double planned_interval = 600;  // [s]

double end_of(const Case& input)
{
    double sum = 0;
    for (const auto& segment : input.operation)
        sum += segment.duration;
    return sum;
}

/// Reads one run.
class CurveReader {
public:
    CurveReader(const CalibrationRun& run, const std::vector<CalibrationSensor>& sensors, const RunReport& report,
                std::vector<std::string>& notes)
        : run_(run), sensors_(sensors), report_(report), notes_(notes), outputs_(outputs_of(*run.input)),
          end_(end_of(*run.input))
    {}

    std::vector<MeasuredCurve> read()
    {
        if (!run_.reference.empty())
            attempt("reference", [&] { read_reference_values(); });
        if (!run_.data.empty())
            attempt("data", [&] { read_data(); });
        for (auto& curve : curves_)
            thin(curve);
        return std::move(curves_);
    }

private:
    template <class Action>
    void attempt(const std::string& key, const Action& action)
    {
        try {
            action();
        } catch (const CaseError&) {
            throw;  // lists the mistakes of a reference file with their places
        } catch (const Error& error) {
            const auto said = split_help(error.what());
            report_(key, "data", said.message, said.help);
        }
    }

    /// The curve of a column, with its sensor. @return nothing, and says so, if there is none
    std::optional<MeasuredCurve> curve_of(const std::string& key, const std::string& file, const std::string& column)
    {
        const auto matched = sensor_of(sensors_, column);
        const std::string output = matched ? matched->output : column;
        if (std::ranges::find(outputs_, output) == outputs_.end()) {
            const auto near = closest_name(output, outputs_);
            report_(key, "unknown-name",
                    fmt::format("the case has no probe and no dimension '{}'{}", output,
                                output == column ? "" : fmt::format(" (column '{}')", column)),
                    !near.empty() ? fmt::format("did you mean '{}'? A sensor's `probe` names what a column of another "
                                                "name measures, the run's `ignore` what is not used",
                                                near)
                                  : fmt::format("it has: {}. A sensor's `probe` names what a column of another name "
                                                "measures, the run's `ignore` what is not used",
                                                fmt::join(outputs_, ", ")));
            return std::nullopt;
        }
        if (!matched) {
            report_(key, "no-sensor", fmt::format("no sensor says how exact '{}' is", column),
                    fmt::format("add [[sensors]] with columns = [\"{}\"] and its noise", column));
            return std::nullopt;
        }
        MeasuredCurve curve;
        curve.column = column;
        curve.output = output;
        curve.of_gap = is_dimension(output);
        curve.sensor = matched->sensor;
        curve.file = file;
        return curve;
    }

    bool ignored(const std::string& column) const
    {
        return std::ranges::any_of(run_.ignore, [&](const auto& pattern) { return matches(pattern, column); });
    }

    // ---------------------------------------------------------------- reference files

    void read_reference_values()
    {
        const ResultContents contents{outputs_of_probes(), outputs_of_chain(), {}, false, end_, false};
        const auto file = read_reference(run_.reference, run_.point, &contents);
        std::map<std::pair<std::string, bool>, std::vector<std::pair<double, double>>> values;  // by output, rise
        for (const auto& rises : file.rises)
            for (const auto& [probe, rise] : rises.values)
                values[{probe, true}].emplace_back(rises.time, rise);
        std::size_t unused = file.times.size() + file.claims.size() + file.loads.size();
        for (const auto& c : file.chain) {
            if (c.at == ReferenceChain::At::largest) {
                ++unused;
                continue;
            }
            values[{c.dimension, false}].emplace_back(c.at == ReferenceChain::At::end ? end_ : *c.time,
                                                      c.opposite_sign ? -c.value : c.value);
        }
        for (auto& [of, points] : values)
            add_points(of.first, of.second, std::move(points));
        for (const auto& curve : file.curves)
            add_curve(curve);
        if (unused > 0)
            notes_.push_back(
                fmt::format("run '{}': {} value{} of '{}' not used (largest changes of the chain, times of "
                            "events, loads and claims are not fitted)",
                            run_.name, unused, unused == 1 ? "" : "s", run_.reference));
    }

    std::vector<std::string> outputs_of_probes() const
    {
        return {outputs_.begin(), std::ranges::find(outputs_, "E_SW")};
    }
    std::vector<std::string> outputs_of_chain() const { return {std::ranges::find(outputs_, "E_SW"), outputs_.end()}; }

    void add_points(const std::string& output, bool rise, std::vector<std::pair<double, double>> points)
    {
        if (ignored(output))
            return;
        auto curve = curve_of("reference", run_.reference, output);
        if (!curve)
            return;
        curve->rise = rise;
        std::ranges::sort(points);
        for (std::size_t k = 0, same = 1; k < points.size(); k += same) {
            const auto [time, value] = points[k];
            double sum = 0;
            for (same = 0; k + same < points.size() && points[k + same].first <= time * (1 + same_time); ++same)
                sum += points[k + same].second;
            if (same > 1)
                notes_.push_back(fmt::format("run '{}': '{}' has {} values at {}; their mean is used", run_.name,
                                             output, same, format_quantity(time, Dimension::time)));
            if (!run_.until || time <= *run_.until * (1 + same_time)) {
                curve->time.push_back(std::min(time, end_));
                curve->value.push_back(sum / static_cast<double>(same));
            }
        }
        keep(std::move(*curve), "reference");
    }

    void add_curve(const ReferenceCurve& from)
    {
        using Measures = ReferenceCurve::Measures;
        const bool of_probe = from.measures == Measures::temperature || from.measures == Measures::rise;
        const std::string output = of_probe ? from.probe : std::string(name_of(*from.measures));
        if (ignored(output) || ignored(from.column))
            return;
        auto curve = curve_of("reference", from.file, output);
        if (!curve)
            return;
        curve->rise = from.measures == Measures::rise;
        for (std::size_t row = 0; row < from.time.size(); ++row)
            if (!run_.until || from.time[row] <= *run_.until * (1 + same_time)) {
                curve->time.push_back(std::min(from.time[row], end_));
                curve->value.push_back(from.value[row]);
            }
        keep(std::move(*curve), "reference");
    }

    // ---------------------------------------------------------------- CSV files

    void read_data()
    {
        const auto table = read_csv(run_.data);
        const auto time_column = table.column(run_.time_column);
        const auto times = in_si(table, time_column, table.numbers(time_column), Dimension::time);
        table.require_increasing(times);
        if (times.empty())
            throw InputError(fmt::format("{}: there are no rows\n  help: add the values", table.file));
        if (times.front() < 0)
            throw InputError(fmt::format("{}:{}: the times begin before the run\n  help: count them from its start",
                                         table.file, table.lines.front()));
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            if (c != time_column && !ignored(table.columns[c].name))
                add_column(table, table.column(table.columns[c].name), times);
    }

    void add_column(const CsvTable& table, std::size_t column, const std::vector<double>& times)
    {
        auto curve = curve_of("data", table.file, table.columns[column].name);
        if (!curve)
            return;
        curve->rise = !curve->of_gap && run_.shows == CalibrationRun::Shows::rise;
        const auto dimension = curve->of_gap ? Dimension::length
                               : curve->rise ? Dimension::temperature_difference
                                             : Dimension::temperature;
        const auto values = in_si(table, column, table.numbers(column, CsvTable::Gaps::as_nan), dimension);
        note_gaps(table, column, values);
        for (std::size_t row = 0; row < values.size(); ++row)
            if (!std::isnan(values[row]) && (!run_.until || times[row] <= *run_.until * (1 + same_time))) {
                if (times[row] > end_ * (1 + same_time))
                    throw InputError(fmt::format("{}:{}: this time lies beyond the run, which ends after {}\n  help: "
                                                 "make operation.*.duration longer, or give `until`",
                                                 table.file, table.lines[row], format_quantity(end_, Dimension::time)));
                curve->time.push_back(std::min(times[row], end_));
                curve->value.push_back(values[row]);
            }
        keep(std::move(*curve), "data");
    }

    /// Says how many values are missing, or where the first one is if none may be.
    void note_gaps(const CsvTable& table, std::size_t column, const std::vector<double>& values)
    {
        const auto first = std::ranges::find_if(values, [](double v) { return std::isnan(v); });
        if (first == values.end())
            return;
        if (run_.gaps == CalibrationRun::Gaps::refuse)
            throw InputError(fmt::format(
                "{}:{}: there is no value in column '{}'\n  help: fill the cell, or give the run gaps = "
                "\"leave_out\"",
                table.file, table.lines[static_cast<std::size_t>(first - values.begin())], table.columns[column].name));
        notes_.push_back(fmt::format("run '{}': {} of {} values of '{}' are missing", run_.name,
                                     std::ranges::count_if(values, [](double v) { return std::isnan(v); }),
                                     values.size(), table.columns[column].name));
    }

    /// @throws InputError if the heading has no unit of this dimension
    static std::vector<double> in_si(const CsvTable& table, std::size_t column, std::vector<double> values,
                                     Dimension dimension)
    {
        const auto& heading = table.columns[column];
        if (heading.unit.empty())
            throw InputError(fmt::format("{}: the column '{}' states no unit\n  help: add it to the heading, like "
                                         "\"{} [{}]\"",
                                         table.file, heading.name, heading.name, dimension_info(dimension).preferred));
        const auto zero = try_parse_quantity("0 " + heading.unit, dimension);
        const auto one = try_parse_quantity("1 " + heading.unit, dimension);
        if (const auto* problem = std::get_if<QuantityProblem>(&one))
            throw InputError(
                fmt::format("{}: column '{}': {}\n  help: {}; a run whose temperatures are rises says shows "
                            "= \"rise\"",
                            table.file, heading.name, problem->message, problem->help));
        const double offset = std::get<double>(zero), factor = std::get<double>(one) - offset;
        for (double& value : values)
            value = offset + factor * value;
        return values;
    }

    // ---------------------------------------------------------------- all of them

    void keep(MeasuredCurve curve, const std::string& key)
    {
        if (curve.time.empty()) {
            report_(key, "no-values", fmt::format("no value of '{}' is left", curve.column),
                    "make `until` later, or name the column in `ignore`");
            return;
        }
        const auto same = std::ranges::adjacent_find(curve.time, [](double a, double b) { return !(a < b); });
        if (same != curve.time.end()) {
            report_(key, "two-values",
                    fmt::format("'{}' has two values at {}", curve.column, format_quantity(*same, Dimension::time)),
                    "keep one of the two");
            return;
        }
        curves_.push_back(std::move(curve));
    }

    void thin(MeasuredCurve& curve)
    {
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < curve.time.size(); ++row)
            if (!run_.interval || rows.empty() ||
                curve.time[row] >= curve.time[rows.back()] + *run_.interval * (1 - same_time))
                rows.push_back(row);
        if (rows.size() > most_values_of_curve) {
            notes_.push_back(fmt::format("run '{}': {} of {} values of '{}' are used, evenly distributed", run_.name,
                                         most_values_of_curve, rows.size(), curve.column));
            std::vector<std::size_t> few;
            for (std::size_t k = 0; k < most_values_of_curve; ++k)
                few.push_back(rows[k * (rows.size() - 1) / (most_values_of_curve - 1)]);
            rows = std::move(few);
        }
        MeasuredCurve result = curve;
        result.time.clear();
        result.value.clear();
        for (const auto row : rows) {
            result.time.push_back(curve.time[row]);
            result.value.push_back(curve.value[row]);
        }
        curve = std::move(result);
    }

    const CalibrationRun& run_;
    const std::vector<CalibrationSensor>& sensors_;
    const RunReport& report_;
    std::vector<std::string>& notes_;
    std::vector<std::string> outputs_;
    double end_ = 0;
    std::vector<MeasuredCurve> curves_;
};

}  // namespace

std::vector<std::string> outputs_of(const Case& input)
{
    std::vector<std::string> result;
    for (const auto& [name, probe] : input.probes)
        result.push_back(name);
    if (input.chain)
        result.insert(result.end(), dimensions.begin(), dimensions.end());
    return result;
}

bool is_dimension(const std::string& output) { return std::ranges::find(dimensions, output) != dimensions.end(); }

std::optional<MatchedSensor> sensor_of(const std::vector<CalibrationSensor>& sensors, const std::string& column)
{
    for (std::size_t s = 0; s < sensors.size(); ++s)
        if (std::ranges::any_of(sensors[s].columns, [&](const auto& pattern) { return matches(pattern, column); }))
            return MatchedSensor{s, sensors[s].probe.empty() ? column : sensors[s].probe};
    return std::nullopt;
}

std::vector<MeasuredCurve> measured_curves(const CalibrationRun& run, const std::vector<CalibrationSensor>& sensors,
                                           const RunReport& report, std::vector<std::string>& notes)
{
    return CurveReader(run, sensors, report, notes).read();
}

std::vector<MeasuredCurve> planned_curves(const std::vector<std::string>& outputs, const CalibrationRun& run,
                                          const std::vector<CalibrationSensor>& sensors, const RunReport& report)
{
    const auto known = outputs_of(*run.input);
    const double end = run.until ? std::min(*run.until, end_of(*run.input)) : end_of(*run.input);
    const double interval = run.interval.value_or(planned_interval);
    std::vector<MeasuredCurve> result;
    for (const auto& output : outputs) {
        if (std::ranges::find(known, output) == known.end()) {
            const auto near = closest_name(output, known);
            report("measure", "unknown-name", fmt::format("the case has no probe and no dimension '{}'", output),
                   near.empty() ? fmt::format("it has: {}", fmt::join(known, ", "))
                                : fmt::format("did you mean '{}'?", near));
            continue;
        }
        const auto matched = sensor_of(sensors, output);
        if (!matched) {
            report("measure", "no-sensor", fmt::format("no sensor says how exact '{}' will be", output),
                   fmt::format("add [[sensors]] with columns = [\"{}\"] and its noise", output));
            continue;
        }
        MeasuredCurve curve{output, output, is_dimension(output), false, matched->sensor, {}, {}, {}};
        const auto count = std::min<std::size_t>(static_cast<std::size_t>(end / interval), most_values_of_curve);
        for (std::size_t k = 1; k <= count; ++k)
            curve.time.push_back(end * static_cast<double>(k) / static_cast<double>(count));
        result.push_back(std::move(curve));
    }
    return result;
}

}  // namespace deadpoint::casefile
