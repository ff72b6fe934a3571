#pragma once

#include <filesystem>
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

/// Writes columns side by side, complete or absent (core/write_file.hpp).
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
