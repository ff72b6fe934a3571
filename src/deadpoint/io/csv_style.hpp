#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Forms of a table: as the program writes it, and as spreadsheets and other programs want it.
namespace deadpoint {

enum class CsvStyle {
    comments,  ///< comment lines ("# ..."), then the table with commas and decimal points
    plain,     ///< the table alone
    comma,     ///< the table alone, with semicolons between the cells and decimal commas
};

/// @throws InputError if a text is not "comments", "plain" or "comma"
CsvStyle csv_style(std::string_view name);

/// The comment lines at the head of a table, without "# ".
std::vector<std::string> csv_comments(std::string_view table);

/// A table with comment lines in another style.
std::string csv_in_style(const std::string& table, CsvStyle style);

/// The other way: a table of that style with its comment lines. csv_with_comments(csv_in_style(t, s), s,
/// csv_comments(t)) == t for every table t that the program writes.
std::string csv_with_comments(const std::string& table, CsvStyle style, const std::vector<std::string>& comments);

}  // namespace deadpoint
