#include "deadpoint/io/csv_table.hpp"

#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
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

bool is_gap(std::string_view cell)
{
    std::string text(cell);
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text.empty() || text == "nan" || text == "-nan" || text == "na";
}

/// @param cell  with a decimal point @return nothing unless all of it is one finite number
std::optional<double> finite_number(std::string_view cell)
{
    if (cell.starts_with('+') && !cell.starts_with("+-")) {
        cell.remove_prefix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = error == std::errc() && end == cell.data() + cell.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string comma_as_point(std::string cell)
{
    std::ranges::replace(cell, ',', '.');
    return cell;
}

/// Place of a cell.
struct CellPlace {
    std::size_t row = 0, column = 0;
};

/// The first number with this decimal mark.
std::optional<CellPlace> first_with(const CsvTable& table, char mark)
{
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
            const auto& cell = table.rows[row][column];
            if (cell.find(mark) != std::string::npos && finite_number(comma_as_point(cell))) {
                return CellPlace{row, column};
            }
        }
    }
    return std::nullopt;
}

std::string text_of(const CsvTable& table, const CellPlace& place)
{
    return fmt::format("'{}' (line {}, column '{}')", table.rows[place.row][place.column], table.lines[place.row],
                       table.columns[place.column].name);
}

/// Between semicolons a mark is a decimal mark only where no number of the file has the other one, which could divide
/// thousands. @return what contradicts this
std::string find_two_marks(const CsvTable& table)
{
    const auto comma = first_with(table, ',');
    const auto point = comma ? first_with(table, '.') : std::nullopt;
    if (!point) {
        return {};
    }
    return fmt::format("{}:{}: {} has a comma and {} a point, so that one of the marks could divide thousands\n  help: "
                       "write all numbers of the file with the same decimal mark and without marks between thousands",
                       table.file, table.lines[std::max(comma->row, point->row)], text_of(table, *comma),
                       text_of(table, *point));
}

/// Why a cell is no number, as far as its marks tell.
std::string reason_of(const std::string& cell, bool semicolons)
{
    const auto commas = std::ranges::count(cell, ','), points = std::ranges::count(cell, '.');
    auto bare = cell;
    std::erase_if(bare, [](char c) { return c == ',' || c == '.' || c == '\'' || c == ' '; });
    if (commas + points == 0 || !finite_number(bare)) {
        return "is not a finite number\n  help: correct the cell, or remove the row";
    }
    if (!semicolons && commas == 1 && points == 0) {
        return "has a decimal comma\n  help: divide the cells by semicolons, or write decimal points";
    }
    return "has marks between thousands, or two decimal marks\n  help: write it with one decimal mark and none between "
           "thousands";
}

}  // namespace

std::size_t CsvTable::column(std::string_view name) const
{
    std::vector<std::string> names;
    for (const auto& c : columns) {
        names.push_back(c.name);
    }
    if (const auto found = std::ranges::find(names, name); found != names.end()) {
        const auto again = std::find(found + 1, names.end(), name);
        if (again != names.end()) {
            throw InputError(fmt::format("{}: the heading '{}' stands twice, in columns {} and {}\n  help: give each "
                                         "column a name of its own, or remove one",
                                         file, name, found - names.begin() + 1, again - names.begin() + 1));
        }
        return static_cast<std::size_t>(found - names.begin());
    }
    const std::string near = closest_name(std::string(name), names);
    throw InputError(fmt::format("{}: there is no column '{}'\n  help: {}", file, name,
                                 near.empty() ? fmt::format("it has: {}", fmt::join(names, ", "))
                                              : fmt::format("did you mean '{}'?", near)));
}

std::vector<double> CsvTable::numbers(std::size_t column, Gaps gaps) const
{
    if (!two_marks.empty()) {
        throw InputError(two_marks);
    }
    std::vector<double> values;
    values.reserve(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& cell = rows[i].at(column);
        const bool gap = gaps == Gaps::as_nan && is_gap(cell);
        const auto value = gap ? std::optional(std::numeric_limits<double>::quiet_NaN())
                               : finite_number(semicolons ? comma_as_point(cell) : cell);
        if (!value) {
            throw InputError(fmt::format("{}:{}: '{}' in column '{}' {}", file, lines[i], cell, columns.at(column).name,
                                         reason_of(cell, semicolons)));
        }
        values.push_back(*value);
    }
    return values;
}

void CsvTable::require_increasing(const std::vector<double>& times) const
{
    const auto wrong = std::ranges::adjacent_find(times, [](double a, double b) { return !(a < b); });
    if (wrong == times.end()) {
        return;
    }
    const auto row = static_cast<std::size_t>(wrong - times.begin());
    throw InputError(fmt::format(
        "{}:{}: the times do not increase: that of line {} {}\n  help: sort the rows, each time "
        "only once",
        file, lines[row + 1], lines[row], times[row] == times[row + 1] ? "stands there again" : "is later"));
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
        if (std::ranges::count_if(line, [](char c) { return c == ',' || c == ';'; }) >= most_columns ||
            table.rows.size() * table.columns.size() > most_cells) {
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
    if (table.semicolons) {
        table.two_marks = find_two_marks(table);
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
