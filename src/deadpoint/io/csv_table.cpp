#include "deadpoint/io/csv_table.hpp"

#include "deadpoint/core/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace deadpoint {
namespace {

// Every cell takes a multiple of its bytes in memory.
constexpr std::ptrdiff_t most_columns = 10'000;
constexpr std::size_t most_cells = 20'000'000;

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return {};
    }
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::vector<std::string> split(const std::string& line, char separator)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += '"';
            ++i;
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == separator && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    std::ranges::transform(cells, cells.begin(), trimmed);
    return cells;
}

CsvTable::Column heading(const std::string& text)
{
    const auto open = text.rfind('[');
    if (!text.ends_with(']') || open == std::string::npos) {
        return {text, ""};
    }
    return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, text.size() - open - 2))};
}

}  // namespace

std::size_t CsvTable::column(std::string_view name) const
{
    std::vector<std::string> names;
    for (const auto& c : columns) {
        names.push_back(c.name);
    }
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) {
        return static_cast<std::size_t>(found - names.begin());
    }
    const std::string near = closest_name(std::string(name), names);
    throw InputError(fmt::format("{}: there is no column '{}'\n  help: {}", file, name,
                                 near.empty() ? fmt::format("it has: {}", fmt::join(names, ", "))
                                              : fmt::format("did you mean '{}'?", near)));
}

std::vector<double> CsvTable::numbers(std::size_t column) const
{
    std::vector<double> values;
    values.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string cell = rows[i].at(column);
        if (semicolons) {
            std::ranges::replace(cell, ',', '.');
        }
        double value = 0;
        const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
        const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
            throw InputError(
                fmt::format("{}:{}: '{}' in column '{}' is not a finite number\n  help: correct the cell, or "
                            "remove the row",
                            file, lines[i], rows[i][column], columns.at(column).name));
        }
        values.push_back(value);
    }
    return values;
}

CsvTable parse_csv(const std::string& text, const std::string& file)
{
    CsvTable table;
    table.file = file;
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) {
            line.erase(0, 3);  // byte order mark, which spreadsheets write
        }
        if (line.starts_with('#') || trimmed(line).empty()) {
            continue;
        }
        if (std::ranges::count(line, ',') >= most_columns || table.rows.size() * table.columns.size() > most_cells) {
            throw InputError(
                fmt::format("{}:{}: the table is larger than {} columns or {} cells, the most that is read\n"
                            "  help: check that it is the table that is meant",
                            table.file, number, most_columns, most_cells));
        }
        auto cells = split(line, table.semicolons ? ';' : ',');
        if (table.columns.empty()) {
            if (auto others = split(line, ';'); others.size() > cells.size()) {
                table.semicolons = true;
                cells = std::move(others);
            }
            std::ranges::transform(cells, std::back_inserter(table.columns), heading);
            continue;
        }
        if (cells.size() != table.columns.size()) {
            throw InputError(fmt::format(
                "{}:{}: {} cells below {} headings\n  help: give every row one cell per column; divide the cells by "
                "semicolons if decimals have commas",
                table.file, number, cells.size(), table.columns.size()));
        }
        table.rows.push_back(std::move(cells));
        table.lines.push_back(number);
    }
    if (table.columns.empty()) {
        throw InputError(fmt::format("{}: the file is empty\n  help: begin it with the names of its columns, like "
                                     "\"time [s],top [degC]\"",
                                     table.file));
    }
    return table;
}

CsvTable read_csv(const std::filesystem::path& path)
{
    const auto text = read_file(path, largest_result);
    if (!text) {
        throw IoError(fmt::format("cannot read '{}'\n  help: check that the file exists", path.string()));
    }
    return parse_csv(*text, path.string());
}

}  // namespace deadpoint
