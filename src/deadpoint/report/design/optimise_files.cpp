#include "deadpoint/report/design/optimise_files.hpp"

#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/design/shown_figures.hpp"
#include "deadpoint/report/design/studied_json.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/explore/optimise.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;
using casefile::Objective;
using twin::DesignFigures;

// Objectives in the units of files: um, h or um/K.
double shown_objective(const OptimiseReport& report, double value)
{
    return value * (report.study.optimise->objective() == Objective::warm_up ? hours : micrometre);
}

std::string objective_unit(const OptimiseReport& report)
{
    switch (report.study.optimise->objective()) {
    case Objective::warm_up:
        return "h";
    case Objective::ambient:
        return "um/K";
    default:
        return "um";
    }
}

// ---------------------------------------------------------------- tables

std::vector<CsvColumn> search_table(const OptimiseReport& report)
{
    namespace table = schema::search;
    const auto& result = report.result;
    std::vector<double> start, value, exceeded;
    std::vector<std::string> stage;
    std::vector<std::vector<double>> variables(result.ranges.size());
    for (std::size_t s = 0; s < result.starts.size(); ++s)
        for (std::size_t k = 0; k < result.starts[s].minimum.steps.size(); ++k) {
            const auto& step = result.starts[s].minimum.steps[k];
            const bool own = result.starts[s].stages[k] == "objective";
            start.push_back(static_cast<double>(s + 1));
            stage.push_back(result.starts[s].stages[k]);
            value.push_back(own ? shown_objective(report, step.value) : step.value);
            exceeded.push_back(step.exceeded);
            for (std::size_t v = 0; v < variables.size(); ++v)
                variables[v].push_back(shown_range(result.ranges[v]).of(result.ranges[v].value_at(step.at[v])));
        }
    std::vector<CsvColumn> columns{
        csv_column(table::start, std::move(start)), csv_column(table::stage, std::move(stage)),
        csv_column(table::value, std::move(value)), csv_column(table::exceeded, std::move(exceeded))};
    for (std::size_t v = 0; v < variables.size(); ++v)
        columns.push_back(csv_column(table::variable, std::move(variables[v]), result.ranges[v].name,
                                     shown_range(result.ranges[v]).unit));
    return columns;
}

std::vector<double> course_values(const twin::DesignCourse& course, const std::vector<double>& times)
{
    std::vector<double> values;
    std::size_t row = 0;
    for (const double time : times) {
        while (row + 2 < course.time.size() && course.time[row + 1] < time)
            ++row;
        const double share = (time - course.time[row]) / (course.time[row + 1] - course.time[row]);
        values.push_back(micrometre * (course.gap[row] + share * (course.gap[row + 1] - course.gap[row])));
    }
    return values;
}

// The rates between neighbouring rows, at the second of them [um/h]; the first row has that of the second.
std::vector<double> rates_of(const std::vector<double>& times, const std::vector<double>& gap)
{
    std::vector<double> rates(times.size(), 0.0);
    for (std::size_t k = 1; k < times.size(); ++k)
        rates[k] = (gap[k] - gap[k - 1]) / (times[k] - times[k - 1]) / hours;
    rates[0] = rates.size() > 1 ? rates[1] : 0;
    return rates;
}

std::vector<CsvColumn> course_table(const OptimiseReport& report)
{
    namespace table = schema::courses;
    const auto& times = report.result.course_after.time;
    std::vector<CsvColumn> columns{csv_column(schema::time, times)};
    const auto add = [&](const twin::DesignCourse& course, const std::string& name) {
        auto gap = course_values(course, times);
        columns.push_back(csv_column(table::rate, rates_of(times, gap), name));
        columns.push_back(csv_column(table::gap, std::move(gap), name));
    };
    add(report.result.course_before, "before");
    add(report.result.course_after, "optimum");
    if (report.full)
        add(report.full->course, "full run");
    return columns;
}

// ---------------------------------------------------------------- JSON

Json figures_json(const OptimiseReport& report, const DesignFigures& figures)
{
    Json json{{"drift_rms_um", micrometre * figures.drift}, {"largest_change_um", micrometre * figures.largest_change}};
    json["warm_after_h"] = figures.warm ? Json(hours * *figures.warm) : Json(nullptr);
    json["ambient_um_per_K"] = figures.ambient ? Json(micrometre * *figures.ambient) : Json(nullptr);
    json["limits"] = Json::array();
    for (std::size_t l = 0; l < figures.extremes.size(); ++l) {
        const bool length = report.study.optimise->limits[l].output.starts_with("E_") ||
                            report.study.optimise->limits[l].output.starts_with("corner ");
        json["limits"].push_back(
            number_or_null(length ? micrometre * figures.extremes[l] : figures.extremes[l] - zero_celsius));
    }
    return json;
}

Json starts_json(const OptimiseReport& report)
{
    Json list = Json::array();
    const auto& result = report.result;
    for (const auto& start : result.starts) {
        Json json{{"value", shown_objective(report, start.minimum.value)},
                  {"keeps_limits", start.minimum.feasible},
                  {"evaluations", start.minimum.steps.size()},
                  {"end", start.minimum.end}};
        json["from"] = Json::array();
        json["to"] = Json::array();
        for (std::size_t v = 0; v < result.ranges.size(); ++v) {
            const auto shown = shown_range(result.ranges[v]);
            json["from"].push_back(shown.of(result.ranges[v].value_at(start.start[v])));
            json["to"].push_back(shown.of(result.ranges[v].value_at(start.minimum.at[v])));
        }
        list.push_back(std::move(json));
    }
    return list;
}

Json variable_json(const OptimiseReport& report, std::size_t v)
{
    const auto& result = report.result;
    const auto shown = shown_range(result.ranges[v]);
    return {{"name", result.ranges[v].name},
            {"range", range_text(result.ranges[v])},
            {"unit", shown.unit},
            {"before", shown.of(result.ranges[v].value_at(result.starts.front().start[v]))},
            {"optimum", shown.of(result.ranges[v].value_at(result.starts[result.best].minimum.at[v]))}};
}

Json study_json(const OptimiseReport& report, const std::vector<std::string>& warnings)
{
    const auto& section = *report.study.optimise;
    auto json = json_of(report, warnings);
    json["objective"] = section.objective_name;
    json["unit"] = objective_unit(report);
    json["rate_um_per_h"] = section.rate * micrometre / hours;
    json["from_s"] = section.from;
    json["method"] = section.method_name;
    json["keeps_limits"] = report.result.feasible;
    json["best_start"] = report.result.best + 1;
    json["minima"] = report.result.minima;
    json["variables"] = Json::array();
    for (std::size_t v = 0; v < report.result.ranges.size(); ++v)
        json["variables"].push_back(variable_json(report, v));
    if (section.speed_profile)
        json["profile_ends_s"] = section.speed_profile->ends;
    json["limits"] = Json::array();
    for (const auto& limit : section.limits)
        json["limits"].push_back(
            {{"output", limit.output}, {"most", limit.most}, {"least", limit.least}, {"from_s", limit.from}});
    json["starts"] = starts_json(report);
    json["before"] = figures_json(report, report.result.before);
    json["promised"] = figures_json(report, report.result.after);
    json["full_run"] = report.full ? figures_json(report, report.full->figures) : Json(nullptr);
    return json;
}

}  // namespace

void write_optimise_files(const std::filesystem::path& folder, const OptimiseReport& report,
                          const std::vector<std::string>& warnings)
{
    const auto comments = comments_of(report, warnings);
    write_file(folder / "optimum.toml", casefile::write_case(report.result.optimum));
    write_table(folder / "search.csv", comments, search_table(report));
    write_table(folder / "courses.csv", comments, course_table(report));
    write_json(folder / "optimise.json", study_json(report, warnings));
}

}  // namespace deadpoint::report
