#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace deadpoint::report {

/// A column of numbers or of text.
struct CsvColumn {
    std::string name;
    std::string unit;  ///< shown in brackets behind the name; empty: none
    std::variant<std::vector<double>, std::vector<std::string>> values;
};

/// Brings a series of the steps to the rows of a table: factor * value + offset.
using SeriesSampler = std::function<std::vector<double>(const Series& series, double factor, double offset)>;

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

}  // namespace deadpoint::report
