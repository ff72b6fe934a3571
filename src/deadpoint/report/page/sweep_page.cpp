#include "deadpoint/report/page/sweep_page.hpp"

#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_json.hpp"
#include "deadpoint/report/folder/result_table.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/page_shell.hpp"
#include "deadpoint/report/page/page_tables.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_values = 40'000;  ///< values of one curve, over all points
constexpr std::size_t fewest_rows = 40;
constexpr std::size_t most_page_rows = 300;

// Evenly chosen, first and last included, to five digits.
Json thinned(const std::vector<double>& values, std::size_t rows)
{
    const std::size_t count = std::min(values.size(), rows);
    Json result = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        const double value = values[count > 1 ? i * (values.size() - 1) / (count - 1) : 0];
        result.push_back(std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr));
    }
    return result;
}

std::vector<double> shifted_then_scaled(std::vector<double> values, double offset, double factor)
{
    for (double& value : values)
        value = factor * (value + offset);
    return values;
}

Json course_json(const ResultTable& table, const Json& summary, std::size_t rows)
{
    namespace history = schema::history;
    Json json{{"hours", thinned(shifted_then_scaled(table.numbers(schema::time), 0, 1.0 / 3600), rows)}};
    const std::string gap = schema::dimensions().front().name;
    if (std::ranges::count(table.names(history::dimension), gap) > 0)
        json[gap] = thinned(table.numbers(history::dimension, gap), rows);
    json["rises"] = Json::object();
    const double start = summary.value("initial_temperature_degC", 0.0);
    for (const auto& probe : table.names(history::probe))
        json["rises"][probe] = thinned(shifted_then_scaled(table.numbers(history::probe, probe), -start, 1), rows);
    return json;
}

// Folder of a point; uses only the last part of a name, so that it stays within the study.
fs::path point_folder(const fs::path& study, const std::string& name)
{
    return study / "points" / fs::path(name).filename();
}

// The results of a point must be those that the study's table was made from.
void require_same_case(const Json& point, const Json& summary, const fs::path& folder)
{
    const auto hash = summary.value("case", Json::object()).value("hash", "");
    if (hash != point.at("case_hash").get<std::string>())
        throw InputError(
            fmt::format("'{}' holds another case (hash {}) than the study had there (hash {})\n  help: run "
                        "the study again",
                        folder.string(), hash, point.at("case_hash").get<std::string>()));
}

Json point_json(const ResultFiles& files, const Json& summary, std::size_t rows)
{
    Json json = Json::object();
    if (const auto history = files.read("history.csv"))
        json["course"] = course_json(ResultTable(*history, (files.folder() / "history.csv").string()), summary, rows);
    if (summary.contains("gaps"))
        json["gaps"] = summary.at("gaps");
    return json;
}

// Data common to all points, from the first point with results.
void add_common(Json& data, const Json& summary)
{
    if (data.contains("machine"))
        return;
    data["machine"] = summary.value("case", Json::object()).value("name", "");
    data["left_out"] = summary.value("left_out", Json::array());
}

// Course and gaps of a point; nothing if it has no results.
Json read_point(const Json& point, const fs::path& folder, std::size_t rows, Json& data)
{
    if (!point.contains("case_hash"))
        return Json::object();
    const ResultFiles files(folder);
    const auto summary = read_json(files, "summary.json");
    if (!summary)
        throw IoError(fmt::format("there is no '{}'\n  help: run the study again", (folder / "summary.json").string()));
    require_same_case(point, *summary, folder);
    add_common(data, *summary);
    return point_json(files, *summary, rows);
}

}  // namespace

void write_sweep_report(const fs::path& file, const fs::path& folder, IfThere if_there)
{
    const auto source = folder / "sweep.json";
    if (!is_study(folder))
        throw InputError(
            fmt::format("'{}' holds no study\n  help: give a folder that 'deadpoint sweep' wrote", folder.string()));
    const ResultFiles files(folder);
    const auto found = read_json(files, "sweep.json");
    const auto table = files.read("sweep.csv");
    if (!found || !table)
        throw IoError(fmt::format("there is no '{}'\n  help: run the study again", (folder / "sweep.csv").string()));
    PageContent content;
    auto& data = content.data;
    const auto& sweep = *found;
    data = {{"version", version},
            {"schema", Json::parse(schema::script_json())},
            {"runs", Json::array()},
            {"sweep", sweep}};
    try {
        const auto whole = fs::absolute(folder).lexically_normal();
        data["folder"] = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
        const auto& points = sweep.at("points");
        const std::size_t rows =
            std::clamp(most_values / std::max<std::size_t>(1, points.size()), fewest_rows, most_page_rows);
        Json courses = Json::object();
        for (const auto& point : points) {
            const auto name = point.at("name").get<std::string>();
            const bool has_folder = !sweep.contains("reduced_model");
            courses[name] = has_folder ? read_point(point, point_folder(folder, name), rows, data) : Json::object();
        }
        data["points"] = std::move(courses);
        content.title = sweep.at("study").at("name").get<std::string>();
        content.without_scripts =
            "<p>This page draws its charts and maps with scripts, which are switched off here; "
            "they are missing below. The folder of the study holds the charts as SVG files.</p>\n" +
            sweep_tables(sweep, ResultTable(*table, (folder / "sweep.csv").string()).csv());
    } catch (const Json::exception&) {
        throw InputError(fmt::format("{}: a figure is missing or of another kind\n  help: it is from another version "
                                     "of the program; run the study again",
                                     source.string()));
    }
    const std::array scripts{page_data_script(), page_charts_script(), page_sweep_script()};
    write_page(file, content, scripts, if_there);
}

}  // namespace deadpoint::report
