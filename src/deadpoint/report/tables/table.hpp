#pragma once

#include <string>
#include <vector>

namespace deadpoint::report {

/// An aligned table for the terminal: titles over a rule, first column to the left, the others to the right.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> titles) : titles_(std::move(titles)) {}

    /// Appends a row; missing cells are empty, cells beyond the titles are dropped.
    void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    /// Aligns a column to the left.
    void align_left(std::size_t column) { left_.push_back(column); }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    /// The whole table. Each line begins with `indent` blanks and ends with a line break, without
    /// trailing blanks.
    [[nodiscard]] std::string text(std::size_t indent = 2) const;

private:
    std::vector<std::string> titles_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> left_{0};
};

/// Number of columns a text takes on a terminal, for UTF-8 without wide or combining characters.
std::size_t display_width(const std::string& text);

/// A number with so many significant digits, never in exponential form between 1e-3 and 1e7: 12.3, 0.0123, 12300.
/// One that is not finite becomes "-".
std::string significant(double value, int digits = 3);

/// A duration as text: "42 s", "5 min 03 s", "1 h 12 min".
std::string duration_text(double seconds);

}  // namespace deadpoint::report
