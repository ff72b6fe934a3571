#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint {

/// A CSV file as text: the first line that is neither empty nor a comment ("# ...") names the columns, with the unit in
/// brackets behind the name ("top [degC]"). Cells are divided by commas, or by semicolons if that gives the heading
/// more cells, and may be quoted as RFC 4180 says. Between semicolons, all numbers of a file may have decimal commas;
/// no number has marks between thousands. A line break inside a cell is not read.
struct CsvTable {
    struct Column {
        std::string name;
        std::string unit;  ///< empty if the heading has none
    };
    std::string file;  ///< for messages
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<int> lines;   ///< of each row in the file, from 1
    bool semicolons = false;  ///< between the cells
    std::string
        two_marks;  ///< why its numbers cannot be read: some have decimal commas, others points; empty: they can

    /// A cell without a value: empty, "nan" or "na".
    enum class Gaps { refuse, as_nan };

    /// Index of a column.
    /// @throws InputError if there is none of that name, or more than one
    [[nodiscard]] std::size_t column(std::string_view name) const;
    /// The numbers of a column; all are finite, but for NaN at the gaps that are wanted.
    /// @throws InputError with file and line if a cell is not a finite number, or if the file has decimal commas as
    /// well
    ///         as decimal points
    [[nodiscard]] std::vector<double> numbers(std::size_t column, Gaps gaps = Gaps::refuse) const;
    /// Checks that times increase from row to row.
    /// @param times  of the first rows, in any unit
    /// @throws InputError with both rows where a time stands twice or runs backward
    void require_increasing(const std::vector<double>& times) const;
};

/// The table in a text.
/// @param file  its name in messages
/// @throws InputError if it has no heading, or a row with more or fewer cells than the heading
CsvTable parse_csv(const std::string& text, const std::string& file);

/// The table in a file.
/// @throws IoError if the file cannot be read
/// @throws InputError as parse_csv()
CsvTable read_csv(const std::filesystem::path& path);

}  // namespace deadpoint
