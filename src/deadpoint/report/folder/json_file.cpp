#include "deadpoint/report/folder/json_file.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

constexpr int deepest = 32;  // our files are eight levels deep; code that walks over values recurses at each level

/// Levels of brackets outside of strings.
int depth_of(const std::string& text)
{
    int depth = 0;
    int most = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\') {
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == '[' || c == '{')) {
            most = std::max(most, ++depth);
        } else if (!quoted && (c == ']' || c == '}')) {
            --depth;
        }
    }
    return most;
}

}  // namespace

nlohmann::ordered_json parse_json(const std::string& text, const std::filesystem::path& name)
{
    auto json = depth_of(text) > deepest ? nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded)
                                         : nlohmann::ordered_json::parse(text, nullptr, false);
    if (json.is_discarded()) {
        throw InputError(fmt::format(
            "'{}' is not the JSON that deadpoint wrote\n  help: compute the case again, or leave this folder out",
            name.string()));
    }
    return json;
}

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& document, IfThere if_there)
{
    // A name from a file need not be valid UTF-8. Replace invalid bytes instead of losing the whole summary.
    write_file(path, document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n', if_there);
}

std::optional<nlohmann::ordered_json> read_json(const std::filesystem::path& path)
{
    const auto text = read_file(path, largest_result);
    return text ? std::optional(parse_json(*text, path)) : std::nullopt;
}

}  // namespace deadpoint::report
