#include "deadpoint/io/csv_style.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace deadpoint {
namespace {

/// The text after the comment lines.
std::string_view after_comments(std::string_view table)
{
    while (table.starts_with('#')) {
        table.remove_prefix(std::min(table.find('\n'), table.size() - 1) + 1);
    }
    return table;
}

bool is_number(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::string replaced(std::string_view text, char from, char to)
{
    std::string result(text);
    std::ranges::replace(result, from, to);
    return result;
}

/// "1.5" as "1,5", text as it is; quotation marks where they are needed between semicolons.
std::string with_comma(std::string_view cell)
{
    if (is_number(cell)) {
        return replaced(cell, '.', ',');
    }
    const bool quotes = !cell.starts_with('"') && cell.find(';') != std::string_view::npos;
    return quotes ? fmt::format("\"{}\"", cell) : std::string(cell);
}

/// The way back. Quotation marks that only a semicolon needed go.
std::string with_point(std::string_view cell)
{
    if (const auto number = replaced(cell, ',', '.'); is_number(number)) {
        return number;
    }
    const bool quotes = cell.starts_with('"') && cell.find_first_of(",\"", 1) == cell.size() - 1;
    return std::string(quotes ? cell.substr(1, cell.size() - 2) : cell);
}

/// A table with other marks between its cells; marks and ends of lines in quotation marks are not such.
template <class Change>
std::string with_marks(std::string_view table, char from, char to, Change change)
{
    std::string result;
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t at = 0; at < table.size(); ++at) {
        quoted = quoted != (table[at] == '"');
        if (!quoted && (table[at] == from || table[at] == '\n')) {
            result += change(table.substr(begin, at - begin));
            result += table[at] == from ? to : '\n';
            begin = at + 1;
        }
    }
    return result + change(table.substr(begin));
}

}  // namespace

CsvStyle csv_style(std::string_view name)
{
    if (name == "comments") {
        return CsvStyle::comments;
    }
    if (name == "plain") {
        return CsvStyle::plain;
    }
    if (name == "comma") {
        return CsvStyle::comma;
    }
    throw InputError(fmt::format("'{}' is no style of tables\n  help: give comments, plain or comma", name));
}

std::vector<std::string> csv_comments(std::string_view table)
{
    std::vector<std::string> comments;
    while (table.starts_with('#')) {
        const auto end = std::min(table.find('\n'), table.size());
        comments.emplace_back(table.substr(std::min<std::size_t>(2, end), end - std::min<std::size_t>(2, end)));
        table.remove_prefix(std::min(end + 1, table.size()));
    }
    return comments;
}

std::string csv_in_style(const std::string& table, CsvStyle style)
{
    if (style == CsvStyle::comments) {
        return table;
    }
    const auto rows = after_comments(table);
    return style == CsvStyle::plain ? std::string(rows) : with_marks(rows, ',', ';', with_comma);
}

std::string csv_with_comments(const std::string& table, CsvStyle style, const std::vector<std::string>& comments)
{
    if (style == CsvStyle::comments) {
        return table;
    }
    std::string text;
    for (const auto& comment : comments) {
        text += "# " + comment + '\n';
    }
    return text + (style == CsvStyle::plain ? table : with_marks(table, ';', ',', with_point));
}

}  // namespace deadpoint
