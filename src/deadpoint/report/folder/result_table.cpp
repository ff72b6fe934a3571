#include "deadpoint/report/folder/result_table.hpp"

#include "deadpoint/casefile/syntax/diagnostics.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

/// The last comment before the heading that states kinds.
std::vector<std::string> kinds_in(const std::string& text)
{
    constexpr std::string_view mark = "# columns: ";
    std::vector<std::string> kinds;
    for (std::size_t at = 0; at < text.size() && text[at] == '#';) {
        const auto end = std::min(text.find('\n', at), text.size());
        const std::string_view line = std::string_view(text).substr(at, end - at);
        at = end + 1;
        if (!line.starts_with(mark)) {
            continue;
        }
        kinds.clear();
        for (std::size_t from = mark.size(); from <= line.size();) {
            const auto comma = std::min(line.find(", ", from), line.size());
            kinds.emplace_back(line.substr(from, comma - from));
            from = comma + 2;
        }
    }
    return kinds;
}

/// A heading without the leading mark that keeps spreadsheets from computing it.
std::string unmarked(const std::string& heading)
{
    const bool marked =
        heading.size() > 1 && heading[0] == '\'' && std::string_view("=+-@").find(heading[1]) != std::string_view::npos;
    return marked ? heading.substr(1) : heading;
}

}  // namespace

ResultTable::ResultTable(const std::string& text, const std::string& path) : csv_(parse_csv(text, path))
{
    const auto& file = schema::file(std::filesystem::path(path).filename().string());
    const auto kinds = kinds_in(text);
    const bool known = std::ranges::all_of(kinds, [&](const auto& kind) { return file.column(kind) != nullptr; });
    if (kinds.size() != csv_.columns.size() || !known) {
        throw InputError(
            fmt::format("{}: its line '# columns: ...' does not fit its heading\n  help: it is from another "
                        "version of the program; compute the case again",
                        path));
    }
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        places_.push_back({kinds[i], schema::name_in(file.column(kinds[i])->heading, unmarked(csv_.columns[i].name))});
    }
}

bool ResultTable::has(const schema::Column& column) const
{
    return std::ranges::find(places_, column.kind, &Place::kind) != places_.end();
}

std::vector<std::string> ResultTable::names(const schema::Column& column) const
{
    std::vector<std::string> names;
    for (const auto& place : places_) {
        if (place.kind == column.kind) {
            names.push_back(place.name);
        }
    }
    return names;
}

std::vector<double> ResultTable::numbers(const schema::Column& column, const std::string& name) const
{
    const auto found = std::ranges::find_if(
        places_, [&](const Place& place) { return place.kind == column.kind && place.name == name; });
    if (found == places_.end()) {
        throw InputError(fmt::format("{}: there is no column '{}'\n  help: compute the case again", csv_.file,
                                     schema::filled(column.heading, name)));
    }
    return csv_.numbers(static_cast<std::size_t>(found - places_.begin()));
}

}  // namespace deadpoint::report
