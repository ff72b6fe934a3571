#include "deadpoint/report/page/page.hpp"

#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_json.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/page_shell.hpp"
#include "deadpoint/report/page/page_tables.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_times = 1000;
constexpr std::size_t most_angles = 361;

Json source_json(const ReportSource& source)
{
    const ResultFiles files(source.folder);
    Json json{{"name", source.name}};
    for (const auto& [file, key] : {std::pair{"summary.json", "summary"},
                                    {"loads.json", "loads"},
                                    {"view.json", "view"},
                                    {"motion.json", "motion"}})
        if (auto value = read_json(files, file))
            json[key] = std::move(*value);
    for (const auto& [file, key, rows] : {std::tuple{"history.csv", "history", most_times},
                                          {"contributions.csv", "contributions", most_times},
                                          {"gaps.csv", "gaps", most_times},
                                          {"joints.csv", "joints", most_angles},
                                          {"bearings.csv", "bearings", most_angles}})
        if (const auto text = files.read(file))
            json[key] = thinned_csv(*text, rows);
    if (const auto text = files.read("case.toml"))
        json["case_file"] = *text;
    if (!json.contains("summary") && !json.contains("loads"))
        throw InputError(fmt::format("'{}' holds no results\n  help: give a folder that 'deadpoint run' or "
                                     "'deadpoint loads' wrote",
                                     source.folder.string()));
    return json;
}

std::string title_of(const Json& runs)
{
    std::string title;
    for (const auto& run : runs) {
        const auto& facts = run.contains("summary") ? run["summary"] : run["loads"];
        const auto name = facts.contains("case") ? facts["case"].value("name", "") : std::string();
        const auto shown = name.empty() ? run.value("name", "") : name;
        if (title.find(shown) == std::string::npos)
            title += (title.empty() ? "" : ", ") + shown;
    }
    return title;
}

std::string tables_of(const Json& run, const fs::path& folder)
{
    try {
        return run_tables(run);
    } catch (const Json::exception&) {
        throw InputError(fmt::format("{}: a figure is missing or of another kind\n  help: it is from another version "
                                     "of the program; compute the case again",
                                     folder.string()));
    }
}

}  // namespace

std::string thinned_csv(std::string_view text, std::size_t most_rows)
{
    std::vector<std::string_view> head, rows;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find('\n', at), text.size());
        const auto line = text.substr(at, end - at);
        at = end + 1;
        if (line.empty())
            continue;
        const bool header = head.empty() || head.back().starts_with('#');
        (line.starts_with('#') || header ? head : rows).push_back(line);
    }
    std::string result;
    for (const auto line : head)
        result.append(line).push_back('\n');
    const std::size_t wanted = std::min(rows.size(), std::max<std::size_t>(2, most_rows));
    for (std::size_t i = 0; i < wanted; ++i)
        result.append(rows[wanted > 1 ? i * (rows.size() - 1) / (wanted - 1) : 0]).push_back('\n');
    return result;
}

std::vector<ReportSource> report_sources(std::span<const fs::path> folders)
{
    std::vector<ReportSource> sources;
    for (const auto& folder : folders) {
        auto whole = fs::absolute(folder).lexically_normal();
        if (!whole.has_filename())
            whole = whole.parent_path();
        sources.push_back({folder, whole.filename().string()});
    }
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (sources[i].name == sources[k].name) {
                sources[i].name = sources[i].folder.string();
                sources[k].name = sources[k].folder.string();
            }
    return sources;
}

void write_report(const fs::path& file, std::span<const ReportSource> sources, IfThere if_there)
{
    Json data{{"version", version}, {"schema", Json::parse(schema::script_json())}, {"runs", Json::array()}};
    for (const auto& source : sources)
        data["runs"].push_back(source_json(source));
    std::string tables =
        "<p>This page draws its charts and the view in three dimensions with scripts, which are switched off here; "
        "they "
        "are missing below. The folder of the results holds all charts and numbers as files.</p>\n";
    for (std::size_t i = 0; i < sources.size(); ++i)
        tables += tables_of(data["runs"][i], sources[i].folder);
    const auto title = title_of(data["runs"]);
    const std::array scripts{page_data_script(),     page_charts_script(),  page_shape_script(), page_view_script(),
                             page_stage_script(),    page_linkage_script(), page_flow_script(),  page_gaps_script(),
                             page_sections_script(), page_main_script()};
    write_page(file, {title, std::move(data), std::move(tables)}, scripts, if_there);
}

}  // namespace deadpoint::report
