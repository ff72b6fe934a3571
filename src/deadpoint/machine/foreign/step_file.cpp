#include "deadpoint/machine/foreign/step_file.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

namespace deadpoint::machine {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// The place behind a string or a comment that begins at `at`; `at` itself if none does.
std::size_t behind_words(std::string_view text, std::size_t at)
{
    const auto behind = [&](std::string_view end, std::size_t from) {
        const auto found = text.find(end, from);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    if (text[at] == '\'') {
        return behind("'", at + 1);
    }
    return text.substr(at, 2) == "/*" ? behind("*/", at + 2) : at;
}

/// Where a word stands in place of a value: behind a bracket or a comma, and no bracket after it. The end if nowhere.
std::size_t misplaced_word(std::string_view text)
{
    char before = ' ';
    for (std::size_t at = 0; at < text.size();) {
        if (const auto behind = behind_words(text, at); behind != at) {
            before = text[at] == '\'' ? '\'' : before;
            at = behind;
            continue;
        }
        if (is_letter(text[at]) && (before == '(' || before == ',')) {
            auto end = at;
            while (end < text.size() && (is_letter(text[end]) || std::isdigit(text[end]) != 0 || text[end] == '_')) {
                ++end;
            }
            while (end < text.size() && is_space(text[end])) {
                ++end;
            }
            if (end == text.size() || text[end] != '(') {
                return at;
            }
        }
        before = is_space(text[at]) ? before : text[at];
        ++at;
    }
    return text.size();
}

/// What a file without the mark of STEP is instead, and what helps.
std::string what_it_is(std::string_view text)
{
    if (text.empty()) {
        return ": it is empty\n  help: export the part again";
    }
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
        return ": it is text in UTF-16\n  help: export the part again, or save the file as UTF-8";
    }
    if (text.starts_with("solid")) {
        return ": it holds triangles (STL)\n  help: export the part as STEP; triangles do not tell bores from planes";
    }
    if (text.starts_with("PK")) {
        return ": it is a compressed archive\n  help: unpack it, and name the file in it";
    }
    return " (ISO 10303-21)\n  help: export the part as STEP";
}

}  // namespace

StepText check_step_file(const std::string& part, const std::string& path)
{
    constexpr std::uintmax_t largest = 1U << 30U;
    require_readable(part, path);
    const std::string text = read_file(path, largest).value_or("");
    if (text.substr(0, 200).find("ISO-10303-21") == std::string::npos) {
        throw InputError(fmt::format("part '{}': '{}' is not a STEP file{}", part, path, what_it_is(text)));
    }
    if (text.find("END-ISO-10303-21") == std::string::npos) {
        throw InputError(fmt::format(
            "part '{}': '{}' is cut short: its end is missing\n  help: export or copy it again", part, path));
    }
    if (const auto at = misplaced_word(text); at < text.size()) {
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw InputError(fmt::format(
            "part '{}': '{}', line {}: a word is found where a value is expected\n  help: export the part again", part,
            path, line));
    }
    return {text.find("LENGTH_UNIT") != std::string::npos};
}

}  // namespace deadpoint::machine
