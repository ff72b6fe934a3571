#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace deadpoint {
struct Series;
}
namespace deadpoint::report::schema {
struct Column;
}

namespace deadpoint::report {

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();  ///< an empty cell

/// A column of numbers or of text.
struct CsvColumn {
    std::string name;
    std::string unit;  ///< shown in brackets behind the name; empty: none
    std::variant<std::vector<double>, std::vector<std::string>> values;
    std::string kind = {};  ///< by the schema; empty in tables that are no results
};

/// A column of the schema.
/// @param name  what stands in the braces of its heading
/// @param unit  where the schema's is "{unit}"
CsvColumn csv_column(const schema::Column& column, std::vector<double> values, const std::string& name = {},
                     const std::string& unit = {});
CsvColumn csv_column(const schema::Column& column, std::vector<std::string> values, const std::string& name = {});

/// Brings a series of the steps to the rows of a table: factor * value + offset.
using SeriesSampler = std::function<std::vector<double>(const Series& series, double factor, double offset)>;

/// The rows of columns side by side, as write_csv() writes them.
std::string csv_rows(std::span<const CsvColumn> columns);

/// The text that write_csv() writes.
/// @throws InputError if the columns differ in length
std::string csv_text(std::span<const std::string> comments, std::span<const CsvColumn> columns);

/// Writes columns side by side, complete or absent (io/write_file.hpp).
///
/// First the comments, one line each behind "# ", then a header line "name [unit],...", then the rows. Numbers have
/// nine significant digits; one that is not finite leaves its cell empty. Text that holds a comma, a quotation mark or
/// a line break is quoted as RFC 4180 says.
///
/// @throws InputError if the columns differ in length
/// @throws IoError    if the file cannot be written
void write_csv(const std::filesystem::path& path, std::span<const std::string> comments,
               std::span<const CsvColumn> columns);

/// The same of a file of the schema, which its name tells; the last comment states the kinds of the columns.
/// @throws std::logic_error if the schema does not know the file or a column of it, and as write_csv()
void write_table(const std::filesystem::path& path, std::span<const std::string> comments,
                 std::span<const CsvColumn> columns);

}  // namespace deadpoint::report
