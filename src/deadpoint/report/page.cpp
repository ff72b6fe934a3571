#include "deadpoint/report/page.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/core/write_file.hpp"
#include "deadpoint/report/page_parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_times = 1000;
constexpr std::size_t most_angles = 361;

std::optional<std::string> content(const fs::path& path)
{
    if (!fs::exists(path))
        return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        throw IoError(fmt::format("cannot read '{}'\n  help: check that you may read it", path.string()));
    return std::move(text).str();
}

Json parsed(const fs::path& path, const std::string& text)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error&) {
        throw InputError(fmt::format(
            "'{}' is not the JSON that deadpoint wrote\n  help: compute the case again, or leave this folder out",
            path.string()));
    }
}

Json source_json(const ReportSource& source)
{
    Json json{{"name", source.name}};
    for (const auto& [file, key] : {std::pair{"summary.json", "summary"},
                                    {"loads.json", "loads"},
                                    {"view.json", "view"},
                                    {"motion.json", "motion"}})
        if (const auto text = content(source.folder / file))
            json[key] = parsed(source.folder / file, *text);
    for (const auto& [file, key, rows] : {std::tuple{"history.csv", "history", most_times},
                                          {"contributions.csv", "contributions", most_times},
                                          {"joints.csv", "joints", most_angles},
                                          {"bearings.csv", "bearings", most_angles}})
        if (const auto text = content(source.folder / file))
            json[key] = thinned_csv(*text, rows);
    if (const auto text = content(source.folder / "case.toml"))
        json["case_file"] = *text;
    if (!json.contains("summary") && !json.contains("loads"))
        throw InputError(fmt::format("'{}' holds no results\n  help: give a folder that 'deadpoint run' or "
                                     "'deadpoint loads' wrote",
                                     source.folder.string()));
    return json;
}

// JSON that may stand in a script element whatever its strings say.
std::string embedded(const Json& json)
{
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    }
    return result;
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
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

constexpr std::string_view policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

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

void write_report(const fs::path& file, std::span<const ReportSource> sources)
{
    Json data{{"version", version}, {"runs", Json::array()}};
    for (const auto& source : sources)
        data["runs"].push_back(source_json(source));
    const auto title = escaped(title_of(data["runs"]));
    write_file(file, [&](std::ostream& out) {
        out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            << "<meta http-equiv=\"Content-Security-Policy\" content=\"" << policy << "\">\n"
            << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            << "<meta name=\"generator\" content=\"deadpoint " << version << "\">\n"
            << "<title>" << title << " - deadpoint</title>\n<style>\n"
            << page_style() << "</style>\n</head>\n<body>\n<main id=\"page\">\n<h1>" << title << "</h1>\n"
            << "<noscript><p>This page draws its figures with scripts, which are switched off here. The same results "
               "stand as tables and charts in the folder it was made from.</p></noscript>\n</main>\n"
            << "<script type=\"application/json\" id=\"data\">" << embedded(data) << "</script>\n"
            << "<script>\n/*\n"
            << page_licences() << "*/\n"
            << page_libraries() << "\n</script>\n<script>\n\"use strict\";\n";
        for (const auto part : {page_data_script(), page_charts_script(), page_view_script(), page_stage_script(),
                                page_linkage_script(), page_flow_script(), page_sections_script(), page_main_script()})
            out << part;
        out << "</script>\n</body>\n</html>\n";
    });
}

}  // namespace deadpoint::report
