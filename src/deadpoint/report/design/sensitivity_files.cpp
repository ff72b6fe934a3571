#include "deadpoint/report/design/sensitivity_files.hpp"

#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/report/design/shown_figures.hpp"
#include "deadpoint/report/design/studied_json.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/twin/explore/sensitivity.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;
using twin::FigureSensitivity;
namespace index_table = schema::indices;

bool is_screening(const SensitivityReport& report)
{
    return report.study.sensitivity->method() == casefile::SensitivityMethod::morris;
}

/// A row for each figure and parameter.
class IndexTable {
public:
    IndexTable(const SensitivityReport& report, const std::vector<FigureSensitivity>& figures)
        : report_(report), figures_(figures)
    {}

    std::vector<CsvColumn> figures()
    {
        texts(index_table::output,
              [&](const auto& f, std::size_t) { return report_.result.outputs[f.figure.output].name; });
        texts(index_table::figure, [](const auto& f, std::size_t) { return figure_name(f.figure); });
        parameter_and_shares();
        if (!figures_.empty() && !figures_.front().bound.empty())
            numbers(index_table::bound, [](const auto& f, std::size_t k) { return f.bound[k]; });
        return std::move(columns_);
    }

    std::vector<CsvColumn> course()
    {
        texts(index_table::output,
              [&](const auto& f, std::size_t) { return report_.result.outputs[f.figure.output].name; });
        numbers(schema::time, [](const auto& f, std::size_t) { return f.figure.time; });
        parameter_and_shares();
        return std::move(columns_);
    }

private:
    void parameter_and_shares()
    {
        texts(index_table::parameter, [&](const auto&, std::size_t k) { return report_.result.ranges[k].name; });
        if (is_screening(report_))
            return effects();
        using Of = std::function<const design::Band&(const design::SobolIndex&)>;
        const Of first = [](const auto& index) -> const design::Band& { return index.first; };
        const Of total = [](const auto& index) -> const design::Band& { return index.total; };
        for (const auto& [columns, of] :
             {std::pair{&index_table::first, first}, std::pair{&index_table::total, total}}) {
            numbers((*columns)[0], [&](const auto& f, std::size_t k) { return of(f.sobol.inputs[k]).value; });
            numbers((*columns)[1], [&](const auto& f, std::size_t k) { return of(f.sobol.inputs[k]).low; });
            numbers((*columns)[2], [&](const auto& f, std::size_t k) { return of(f.sobol.inputs[k]).high; });
        }
    }

    void effects()
    {
        const auto scaled = [&](const FigureSensitivity& f, double value) {
            return shown_difference(f.figure, report_.result.outputs).factor * value;
        };
        texts(index_table::unit,
              [&](const auto& f, std::size_t) { return shown_difference(f.figure, report_.result.outputs).unit; });
        numbers(index_table::strength[0], [&](const auto& f, auto k) { return scaled(f, f.morris[k].strength.value); });
        numbers(index_table::strength[1], [&](const auto& f, auto k) { return scaled(f, f.morris[k].strength.low); });
        numbers(index_table::strength[2], [&](const auto& f, auto k) { return scaled(f, f.morris[k].strength.high); });
        numbers(index_table::mean, [&](const auto& f, auto k) { return scaled(f, f.morris[k].mean); });
        numbers(index_table::deviation, [&](const auto& f, auto k) { return scaled(f, f.morris[k].deviation); });
    }

    template <class Of>
    void texts(const schema::Column& column, Of&& of)
    {
        std::vector<std::string> values;
        for (const auto& figure : figures_)
            for (std::size_t k = 0; k < report_.result.ranges.size(); ++k)
                values.push_back(of(figure, k));
        columns_.push_back(csv_column(column, std::move(values)));
    }
    template <class Of>
    void numbers(const schema::Column& column, Of&& of)
    {
        std::vector<double> values;
        for (const auto& figure : figures_)
            for (std::size_t k = 0; k < report_.result.ranges.size(); ++k)
                values.push_back(of(figure, k));
        columns_.push_back(csv_column(column, std::move(values)));
    }

    const SensitivityReport& report_;
    const std::vector<FigureSensitivity>& figures_;
    std::vector<CsvColumn> columns_;
};

std::vector<CsvColumn> samples(const twin::SensitivityResult& result)
{
    std::vector<CsvColumn> columns;
    for (std::size_t k = 0; k < result.ranges.size(); ++k) {
        const auto shown = shown_range(result.ranges[k]);
        std::vector<double> values;
        for (const auto& point : result.points)
            values.push_back(shown.of(point[k]));
        columns.push_back(csv_column(schema::samples::parameter, std::move(values), result.ranges[k].name, shown.unit));
    }
    for (std::size_t f = 0; f < result.figures.size(); ++f) {
        const auto& figure = result.figures[f].figure;
        const auto shown = shown_figure(figure, result.outputs);
        std::vector<double> values;
        for (const auto& point : result.values)
            values.push_back(shown.of(point[f]));
        columns.push_back(csv_column(schema::samples::figure, std::move(values),
                                     fmt::format("{}, {}", result.outputs[figure.output].name, figure_name(figure)),
                                     shown.unit));
    }
    return columns;
}

Json band(const design::Band& band, double factor = 1)
{
    return {number_or_null(factor * band.value), number_or_null(factor * band.low), number_or_null(factor * band.high)};
}

Json effects_json(const FigureSensitivity& figure, std::size_t k, double factor)
{
    const auto& effect = figure.morris[k];
    return {{"strength", band(effect.strength, factor)},
            {"mean", number_or_null(factor * effect.mean)},
            {"deviation", number_or_null(factor * effect.deviation)}};
}

Json indices_json(const FigureSensitivity& figure, std::size_t k)
{
    const auto& index = figure.sobol.inputs[k];
    Json json{{"first", band(index.first)}, {"total", band(index.total)}};
    if (!figure.bound.empty())
        json["bound"] = number_or_null(figure.bound[k]);
    return json;
}

Json figure_json(const SensitivityReport& report, const FigureSensitivity& figure)
{
    const auto& outputs = report.result.outputs;
    const auto value = shown_figure(figure.figure, outputs), difference = shown_difference(figure.figure, outputs);
    Json json{{"output", outputs[figure.figure.output].name}, {"figure", figure_name(figure.figure)}};
    json["unit"] = difference.unit;
    if (!is_screening(report)) {
        json["mean_unit"] = value.unit;
        json["mean"] = number_or_null(value.of(figure.sobol.mean));
        json["deviation"] = number_or_null(difference.factor * std::sqrt(figure.sobol.variance));
    }
    json["parameters"] = Json::object();
    for (std::size_t k = 0; k < report.result.ranges.size(); ++k)
        json["parameters"][report.result.ranges[k].name] =
            is_screening(report) ? effects_json(figure, k, difference.factor) : indices_json(figure, k);
    return json;
}

/// An output over time: the value of each index at each time.
Json course_json(const SensitivityReport& report, std::size_t first, std::size_t count)
{
    const auto& course = report.result.course;
    const auto& figure = course[first].figure;
    const auto shown = shown_difference(figure, report.result.outputs);
    Json json{{"output", report.result.outputs[figure.output].name}, {"unit", shown.unit}};
    json["hours"] = Json::array();
    json["deviation"] = Json::array();
    json["parameters"] = Json::object();
    for (std::size_t row = first; row < first + count; ++row) {
        json["hours"].push_back(course[row].figure.time / 3600);
        json["deviation"].push_back(number_or_null(shown.factor * std::sqrt(course[row].sobol.variance)));
        for (std::size_t k = 0; k < report.result.ranges.size(); ++k) {
            auto& list = json["parameters"][report.result.ranges[k].name];
            if (is_screening(report)) {
                list["strength"].push_back(number_or_null(shown.factor * course[row].morris[k].strength.value));
            } else {
                list["first"].push_back(number_or_null(course[row].sobol.inputs[k].first.value));
                list["total"].push_back(number_or_null(course[row].sobol.inputs[k].total.value));
            }
        }
    }
    if (is_screening(report))
        json.erase("deviation");
    return json;
}

Json parameter_json(const SensitivityReport& report, std::size_t k)
{
    return {{"name", report.result.ranges[k].name},
            {"keys", report.study.sensitivity->parameters[k].keys},
            {"range", range_text(report.result.ranges[k])}};
}

Json study_json(const SensitivityReport& report, const std::vector<std::string>& warnings)
{
    const auto& section = *report.study.sensitivity;
    auto json = json_of(report, warnings);
    json["method"] = section.method_name;
    json["rows"] = is_screening(report) ? section.trajectories : section.points;
    json["seed"] = section.seed;
    json["runs"] = report.result.runs;
    json["failed"] = report.result.failed;
    json["parameters"] = Json::array();
    for (std::size_t k = 0; k < report.result.ranges.size(); ++k)
        json["parameters"].push_back(parameter_json(report, k));
    json["figures"] = Json::array();
    for (const auto& figure : report.result.figures)
        json["figures"].push_back(figure_json(report, figure));
    json["course"] = Json::array();
    const auto times = static_cast<std::size_t>(section.course_times);
    for (std::size_t first = 0; times > 0 && first < report.result.course.size(); first += times)
        json["course"].push_back(course_json(report, first, times));
    return json;
}

}  // namespace

void write_sensitivity_files(const std::filesystem::path& folder, const SensitivityReport& report,
                             const std::vector<std::string>& warnings)
{
    const auto comments = comments_of(report, warnings);
    write_table(folder / "indices.csv", comments, IndexTable(report, report.result.figures).figures());
    if (!report.result.course.empty())
        write_table(folder / "indices_over_time.csv", comments, IndexTable(report, report.result.course).course());
    if (!report.result.points.empty())
        write_table(folder / "samples.csv", comments, samples(report.result));
    write_json(folder / "sensitivity.json", study_json(report, warnings));
}

}  // namespace deadpoint::report
