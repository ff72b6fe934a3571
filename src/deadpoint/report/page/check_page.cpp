#include "deadpoint/report/page/check_page.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/press/check/case_sketch.hpp"
#include "deadpoint/report/page/named_things.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/page_shell.hpp"
#include "deadpoint/report/page/sketch_json.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 6> kinds{"part", "body", "joint", "interface", "surface", "probe"};

std::string place_text(const FilePlace& place)
{
    return place.line > 0 ? fmt::format("{}:{}:{}", place.file, place.line, place.column) : place.file;
}

Json finding_json(const Diagnostic& found, const casefile::Case& input)
{
    Json things = Json::array();
    for (const auto& thing : things_of(found, input))
        things.push_back({{"kind", kinds.at(static_cast<std::size_t>(thing.kind))}, {"name", thing.name}});
    return {{"severity", found.severity == DiagnosticSeverity::error ? "error" : "warning"},
            {"path", found.path},
            {"place", place_text(found.place)},
            {"message", found.message},
            {"help", found.help},
            {"things", things}};
}

bool is_said(const Diagnostic& what, const std::vector<Diagnostic>& found)
{
    return std::ranges::any_of(found,
                               [&](const Diagnostic& d) { return d.path == what.path && d.message == what.message; });
}

/// Why things are not in the picture, as far as no finding says it.
Json missing_json(const std::vector<Diagnostic>& missing, const std::vector<Diagnostic>& found)
{
    Json list = Json::array();
    for (const auto& entry : missing)
        if (!is_said(entry, found))
            list.push_back({{"path", entry.path}, {"message", entry.message}});
    return list;
}

std::string without_scripts(const std::vector<Diagnostic>& found)
{
    std::string text = "<p>This page draws the machine with scripts, which are switched off here.</p>\n<ul>\n";
    for (const auto& entry : found)
        text += fmt::format("<li>{}: {}: {} {}</li>\n", xml_text(place_text(entry.place)), xml_text(entry.path),
                            xml_text(entry.message), xml_text(entry.help));
    return text + "</ul>\n";
}

}  // namespace

void write_check_page(const std::filesystem::path& file, const casefile::Case& input, const press::CaseSketch& sketch,
                      const std::vector<Diagnostic>& found, IfThere if_there)
{
    PageContent content;
    content.title = input.machine.name.empty() ? "Machine" : input.machine.name;
    content.data = {{"version", version},        {"schema", Json::parse(schema::script_json())},
                    {"runs", Json::array()},     {"sketch", sketch_json(input, sketch)},
                    {"findings", Json::array()}, {"missing", missing_json(sketch.missing, found)}};
    for (const auto& entry : found)
        content.data["findings"].push_back(finding_json(entry, input));
    content.without_scripts = without_scripts(found);
    const std::array scripts{page_data_script(), page_shape_script(), page_check_script()};
    write_page(file, content, scripts, if_there);
}

bool is_unchanged_page(const std::filesystem::path& file)
{
    return is_sealed(read_file(file, largest_result).value_or(""));
}

}  // namespace deadpoint::report
