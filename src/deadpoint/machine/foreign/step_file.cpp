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

unsigned char byte_at(std::string_view text, std::size_t i)
{
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

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

std::size_t line_of(std::string_view text, std::size_t at)
{
    return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// The line of the first number with an exponent of three digits from 300 on; 0 if there is none.
std::size_t line_of_overflow(std::string_view text)
{
    for (auto at = text.find_first_of("eE"); at != std::string_view::npos; at = text.find_first_of("eE", at + 1)) {
        const bool of_number = at > 0 && (std::isdigit(byte_at(text, at - 1)) != 0 || text[at - 1] == '.');
        const auto from = at + (byte_at(text, at + 1) == '+' ? 2 : 1);
        std::size_t digits = 0;
        while (std::isdigit(byte_at(text, from + digits)) != 0) {
            ++digits;
        }
        if (of_number && (digits > 3 || (digits == 3 && text[from] >= '3'))) {
            return line_of(text, at);
        }
    }
    return 0;
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

/// Bytes of the UTF-8 character that begins at a place; 0 where none does.
std::size_t utf8_length(std::string_view text, std::size_t at)
{
    const unsigned char first = byte_at(text, at);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte_at(text, at + i) & 0xc0U) != 0x80) {
            return 0;
        }
    }
    return length;
}

/// A name that was cut in the middle of a character must not spoil all others.
bool is_utf8(std::string_view text)
{
    std::size_t sound = 0;
    std::size_t stray = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        sound += length > 1 ? 1 : 0;
        stray += length == 0 ? 1 : 0;
        at += std::max<std::size_t>(length, 1);
    }
    return stray == 0 || sound > 2 * stray;
}

bool is_gbk(std::string_view text)
{
    std::size_t all = 0;
    std::size_t common = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const unsigned char first = byte_at(text, at);
        if (first < 0x80) {
            continue;
        }
        const unsigned char second = byte_at(text, at + 1);
        if (first < 0x81 || first > 0xfe || second < 0x40 || second == 0x7f || second > 0xfe) {
            return false;
        }
        const bool inside_word = at > 0 && is_letter(text[at - 1]) && at + 2 < text.size() && is_letter(text[at + 2]);
        all += 1;
        common += first >= 0xb0 && first <= 0xd7 && second >= 0xa1 && !inside_word ? 1 : 0;
        ++at;
    }
    return all > 0 && 3 * common >= 2 * all;
}

bool is_cyrillic(std::string_view text)
{
    std::size_t all = 0;
    std::size_t in_words = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t run = 0;
        while (byte_at(text, at + run) >= 0x80) {
            ++run;
        }
        all += run;
        in_words += run >= 3 ? run : 0;
        at += run + 1;
    }
    return all > 0 && 2 * in_words > all;
}

}  // namespace

StepLetters letters_of(std::string_view text)
{
    if (is_utf8(text)) {
        return StepLetters::utf8;
    }
    if (is_gbk(text)) {
        return StepLetters::gbk;
    }
    return is_cyrillic(text) ? StepLetters::cyrillic : StepLetters::latin;
}

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
        throw InputError(fmt::format(
            "part '{}': '{}', line {}: a word is found where a value is expected\n  help: export the part again", part,
            path, line_of(text, at)));
    }
    return {text.find("LENGTH_UNIT") != std::string::npos, letters_of(text), line_of_overflow(text)};
}

}  // namespace deadpoint::machine
