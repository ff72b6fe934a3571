#include "deadpoint/report/tables/csv.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <stdexcept>

namespace deadpoint::report {
namespace {

std::size_t length(const CsvColumn& column)
{
    return std::visit([](const auto& v) { return v.size(); }, column.values);
}

/// Whether a spreadsheet would compute the cell: it begins like a formula and is not merely a number with a unit.
bool is_formula(std::string_view text)
{
    if (text.empty() || std::string_view("=+-@").find(text[0]) == std::string_view::npos) {
        return false;
    }
    const bool is_signed = (text[0] == '+' || text[0] == '-') && text.size() > 1 &&
                           std::string_view("0123456789.").find(text[1]) != std::string_view::npos;
    return !is_signed || text.find_first_of("()|!@=&'\"") != std::string_view::npos;
}

std::string quoted(const std::string& given)
{
    const std::string text = (is_formula(given) ? "'" : "") + one_line(given);
    if (text.find_first_of(",\"") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + '"';
}

std::string cell(const CsvColumn& column, std::size_t row)
{
    if (const auto* numbers = std::get_if<std::vector<double>>(&column.values)) {
        const double value = (*numbers)[row];
        return std::isfinite(value) ? fmt::format("{:.9g}", value) : std::string{};
    }
    return quoted(std::get<std::vector<std::string>>(column.values)[row]);
}

/// "columns: time, joint_heat"
std::string kinds_comment(const schema::File& file, std::span<const CsvColumn> columns)
{
    std::string text = "columns:";
    for (const auto& column : columns) {
        if (file.column(column.kind) == nullptr) {
            throw std::logic_error(
                fmt::format("the schema knows no column '{}' ({}) of '{}'", column.kind, column.name, file.name));
        }
        text += (&column == columns.data() ? " " : ", ") + column.kind;
    }
    return text;
}

}  // namespace

CsvColumn csv_column(const schema::Column& column, std::vector<double> values, const std::string& name,
                     const std::string& unit)
{
    return {schema::filled(column.heading, name), schema::filled(column.unit, unit), std::move(values),
            std::string(column.kind)};
}

CsvColumn csv_column(const schema::Column& column, std::vector<std::string> values, const std::string& name)
{
    return {schema::filled(column.heading, name), std::string(column.unit), std::move(values),
            std::string(column.kind)};
}

void write_table(const std::filesystem::path& path, std::span<const std::string> comments,
                 std::span<const CsvColumn> columns)
{
    std::vector<std::string> lines(comments.begin(), comments.end());
    lines.push_back(kinds_comment(schema::file(path.filename().string()), columns));
    write_csv(path, lines, columns);
}

std::string csv_rows(std::span<const CsvColumn> columns)
{
    std::string text;
    const std::size_t rows = columns.empty() ? 0 : length(columns.front());
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            text += i == 0 ? "" : ",";
            text += cell(columns[i], row);
        }
        text += '\n';
    }
    return text;
}

std::string csv_text(std::span<const std::string> comments, std::span<const CsvColumn> columns)
{
    const std::size_t rows = columns.empty() ? 0 : length(columns.front());
    for (const auto& column : columns) {
        if (length(column) != rows) {
            throw InputError(
                fmt::format("column '{}' has {} rows, the first one {}", column.name, length(column), rows));
        }
    }
    std::string text;
    for (const auto& comment : comments) {
        text += "# " + one_line(comment) + '\n';
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto& column = columns[i];
        text += i == 0 ? "" : ",";
        text += quoted(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
    }
    text += '\n';
    return text + csv_rows(columns);
}

void write_csv(const std::filesystem::path& path, std::span<const std::string> comments,
               std::span<const CsvColumn> columns)
{
    try {
        write_file(path, csv_text(comments, columns));
    } catch (const InputError& error) {
        throw InputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
}

}  // namespace deadpoint::report
