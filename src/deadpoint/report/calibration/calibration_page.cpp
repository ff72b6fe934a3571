#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/report/calibration/calibration_files.hpp"
#include "deadpoint/report/calibration/calibration_json.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/page_shell.hpp"
#include "deadpoint/report/schema/schema.hpp"
#include "deadpoint/twin/calibrate/calibration_result.hpp"

#include <algorithm>
#include <array>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;
using twin::Calibration;

constexpr std::size_t most_curve_rows = 400;

Json numbers(const std::vector<double>& values, const std::vector<std::size_t>& rows, double factor, double offset)
{
    Json json = Json::array();
    for (const auto row : rows)
        json.push_back(factor * values[row] + offset);
    return json;
}

std::vector<std::size_t> few_rows(std::size_t count)
{
    std::vector<std::size_t> rows;
    const std::size_t step = std::max<std::size_t>(1, count / most_curve_rows);
    for (std::size_t row = 0; row < count; row += step)
        rows.push_back(row);
    if (count > 0 && rows.back() != count - 1)
        rows.push_back(count - 1);
    return rows;
}

// Measured values of a run's output, in the units of the predictions; rises count from the start.
Json marks_of(const Calibration& result, const twin::PredictedRun& run, const twin::PredictedCurve& curve)
{
    Json marks = Json::array();
    for (const auto& measured : result.curves) {
        if (measured.run != run.name || measured.output != curve.output)
            continue;
        const bool rise =
            !measured.of_gap && !measured.measured.empty() && measured.predicted.front() < 0.5 * zero_celsius;
        const double start = rise ? curve.value.front() : 0;
        for (std::size_t k = 0; k < measured.time.size(); ++k)
            marks.push_back({{"x", measured.time[k] / hour},
                             {"y", curve.of_gap ? micrometre * measured.measured[k]
                                                : measured.measured[k] + start - zero_celsius}});
    }
    return marks;
}

Json courses(const Calibration& result)
{
    Json json = Json::array();
    for (const auto& run : result.predictions) {
        const auto rows = few_rows(run.time.size());
        Json entry{{"run", run.name}, {"held_out", run.hold_out}, {"hours", numbers(run.time, rows, 1 / hour, 0)}};
        entry["curves"] = Json::array();
        for (const auto& curve : run.curves) {
            const double factor = curve.of_gap ? micrometre : 1, offset = curve.of_gap ? 0 : -zero_celsius;
            entry["curves"].push_back({{"quantity", curve.output},
                                       {"unit", curve.of_gap ? "µm" : "°C"},
                                       {"before", numbers(curve.before, rows, factor, offset)},
                                       {"value", numbers(curve.value, rows, factor, offset)},
                                       {"lower", numbers(curve.lower, rows, factor, offset)},
                                       {"upper", numbers(curve.upper, rows, factor, offset)},
                                       {"measured", marks_of(result, run, curve)}});
        }
        json.push_back(std::move(entry));
    }
    return json;
}

/// A page of results with what every such page has.
void write(const std::filesystem::path& file, const std::string& title, Json results, const std::string& text,
           std::string_view script)
{
    PageContent content;
    content.title = title;
    content.data = {{"version", version}, {"schema", Json::parse(schema::script_json())}, {"runs", Json::array()}};
    content.data.update(results);
    content.without_scripts = "<p>This page draws its charts with scripts, which are switched off here.</p>\n<pre>" +
                              xml_text(text) + "</pre>\n";
    const std::array scripts{page_data_script(), page_charts_script(), script};
    write_page(file, content, scripts, IfThere::replace);
}

}  // namespace

void write_calibration_page(const std::filesystem::path& file, const Calibration& result)
{
    write(file, result.name, {{"calibration", calibration_json(result)}, {"courses", courses(result)}},
          calibration_text(result), page_calibration_script());
}

void write_plan_page(const std::filesystem::path& file, const twin::CalibrationPlan& plan)
{
    write(file, plan.name, {{"plan", plan_json(plan)}}, calibration_text(plan), page_plan_script());
}

}  // namespace deadpoint::report
