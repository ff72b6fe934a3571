#pragma once

#include "deadpoint/io/csv_table.hpp"

#include <string>
#include <vector>

namespace deadpoint::report::schema {
struct Column;
}

namespace deadpoint::report {

/// A table of a result folder, read back. Columns are found by their kind in the schema and the name of the case in
/// them.
class ResultTable {
public:
    /// @param text  of the file
    /// @param path  of it; its last name says which file of the schema it is
    /// @throws InputError as parse_csv(), or if the line that states the kinds of the columns is
    /// missing or does not match
    ResultTable(const std::string& text, const std::string& path);

    [[nodiscard]] const CsvTable& csv() const { return csv_; }
    [[nodiscard]] bool has(const schema::Column& column) const;
    /// Names of the case in all columns of a kind, in the order of the file.
    [[nodiscard]] std::vector<std::string> names(const schema::Column& column) const;
    /// @param name  of the case; empty where the heading has none
    /// @throws InputError if there is no such column, or a cell is not a finite number
    [[nodiscard]] std::vector<double> numbers(const schema::Column& column, const std::string& name = {}) const;

private:
    struct Place {
        std::string kind;
        std::string name;
    };
    CsvTable csv_;
    std::vector<Place> places_;  ///< of every column
};

}  // namespace deadpoint::report
