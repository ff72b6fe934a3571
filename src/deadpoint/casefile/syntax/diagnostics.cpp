#include "deadpoint/casefile/syntax/diagnostics.hpp"

#include "deadpoint/core/names/plain_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <tuple>
#include <utility>

namespace deadpoint::casefile {
namespace {

constexpr std::size_t most_kept = 200;
constexpr int longest_line = 600;  // number of characters that are quoted

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

int length_of(const std::string& text) { return static_cast<int>(character_count(text)); }

/// Blanks as wide as the first `count` characters of the line; tabs stay tabs so that the caret is in the right column.
std::string blanks(const std::string& line, int count)
{
    std::string result;
    for (const char c : line) {
        if (!begins_character(c)) {
            continue;
        }
        if (count-- <= 0) {
            break;
        }
        result += c == '\t' ? '\t' : ' ';
    }
    if (count > 0) {
        result.append(static_cast<std::size_t>(count), ' ');
    }
    return result;
}

/// Part of a long line around a place, and the number of characters before it.
std::pair<std::string, int> around(const std::string& line, int place)
{
    if (length_of(line) <= longest_line) {
        return {line, 0};
    }
    const int begin = std::max(place - longest_line / 2, 0);
    std::string stretch;
    int count = 0;
    for (const char c : line) {
        count += begins_character(c) ? 1 : 0;
        if (count > begin && count <= begin + longest_line) {
            stretch += c;
        }
    }
    return {stretch, begin};
}

}  // namespace

int Sources::add(const std::string& shown, const std::string& text)
{
    File file{one_line(shown), {}};
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        file.lines.push_back(masked(line));  // keeps the number of characters, so that the caret below fits
    }
    files_.push_back(std::move(file));
    return static_cast<int>(files_.size()) - 1;
}

std::string Sources::line(const Place& place) const
{
    if (place.file < 0 || place.line < 1) {
        return {};
    }
    const auto& lines = files_.at(static_cast<std::size_t>(place.file)).lines;
    const auto index = static_cast<std::size_t>(place.line) - 1;
    return index < lines.size() ? lines[index] : std::string();
}

StableHash Sources::hash(StableHash before) const
{
    for (const auto& file : files_) {
        before.add(file.shown + "\n");
        for (const auto& line : file.lines) {
            before.add(line + "\n");
        }
    }
    return before;
}

void Diagnostics::add(Diagnostic diagnostic)
{
    auto& count = diagnostic.severity == Severity::error ? errors_ : warnings_;
    if (++count <= most_kept) {
        items_.push_back(std::move(diagnostic));
    }
}

std::vector<Diagnostic> Diagnostics::sorted() const
{
    auto items = items_;
    std::ranges::stable_sort(items, [](const Diagnostic& a, const Diagnostic& b) {
        return std::tuple(a.place.file, a.place.line, a.place.column) <
               std::tuple(b.place.file, b.place.line, b.place.column);
    });
    return items;
}

std::string Diagnostics::quote(const Place& place) const
{
    const auto [line, left_out] = around(sources.line(place), place.column - 1);
    if (line.empty()) {
        return {};
    }
    const int before = std::max(place.column - 1 - left_out, 0);
    const int room = std::max(length_of(line) - before, 1);
    const auto carets = static_cast<std::size_t>(std::clamp(place.width, 1, room));
    return fmt::format("{:>6} | {}\n       | {}{}\n", place.line, line, blanks(line, before), std::string(carets, '^'));
}

std::string Diagnostics::render(const Diagnostic& d) const
{
    std::string text;
    if (d.place.file >= 0) {
        text += d.place.line > 0 ? fmt::format("{}:{}:{}: ", sources.name(d.place.file), d.place.line, d.place.column)
                                 : fmt::format("{}: ", sources.name(d.place.file));
    }
    text += fmt::format("{}[{}]", d.severity == Severity::error ? "error" : "warning", d.code);
    if (!d.path.empty()) {
        text += ": " + d.path;
    }
    text += fmt::format("\n  {}\n", d.message);
    text += quote(d.place);
    if (d.other && d.other->file >= 0) {
        text +=
            fmt::format("  {} ({}:{}:{})\n", d.other_note, sources.name(d.other->file), d.other->line, d.other->column);
        text += quote(*d.other);
    }
    if (!d.help.empty()) {
        text += fmt::format("  help: {}\n", d.help);
    }
    return printable(text);
}

std::string Diagnostics::render_errors(std::string_view outcome) const
{
    std::string text;
    for (const auto& diagnostic : sorted()) {
        if (diagnostic.severity == Severity::error) {
            text += render(diagnostic) + "\n";
        }
    }
    const auto count = error_count();
    if (count > most_kept) {
        text += fmt::format("... and {} more\n\n", count - most_kept);
    }
    return text + fmt::format("{} error{} in {}", count, count == 1 ? "" : "s", outcome);
}

std::vector<std::string> Diagnostics::render_warnings() const
{
    std::vector<std::string> texts;
    for (const auto& diagnostic : sorted()) {
        if (diagnostic.severity != Severity::warning) {
            continue;
        }
        texts.push_back(render(diagnostic));
        while (texts.back().ends_with('\n')) {
            texts.back().pop_back();
        }
    }
    return texts;
}

}  // namespace deadpoint::casefile
