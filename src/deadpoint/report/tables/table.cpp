#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {

std::size_t display_width(const std::string& text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string TextTable::text(std::size_t indent) const
{
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < titles_.size(); ++i) {
        widths.push_back(display_width(titles_[i]));
        for (const auto& row : rows_) {
            widths[i] = std::max(widths[i], i < row.size() ? display_width(row[i]) : 0);
        }
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string result(indent, ' ');
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const std::string cell = i < cells.size() ? cells[i] : std::string{};
            const std::string blanks(widths[i] - display_width(cell), ' ');
            result += i == 0 ? "" : "  ";
            result += std::ranges::find(left_, i) != left_.end() ? cell + blanks : blanks + cell;
        }
        result.erase(result.find_last_not_of(' ') + 1);
        return result + '\n';
    };
    std::vector<std::string> rules;
    for (const std::size_t width : widths) {
        std::string rule;
        for (std::size_t i = 0; i < width; ++i) {
            rule += "─";
        }
        rules.push_back(rule);
    }
    std::string result = line(titles_) + line(rules);
    for (const auto& row : rows_) {
        result += line(row);
    }
    return result;
}

std::string significant(double value, int digits)
{
    if (!std::isfinite(value)) {
        return "-";
    }
    const double size = std::abs(value);
    if (size == 0) {
        return "0";
    }
    if (size < 1e-3 || size >= 1e7) {
        return fmt::format("{:.{}g}", value, digits);
    }
    const double unit = std::pow(10.0, std::floor(std::log10(size)) - digits + 1);
    const double rounded = std::round(value / unit) * unit;
    const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(rounded)) + 1e-12)));
    return fmt::format("{:.{}f}", rounded, decimals);
}

std::string duration_text(double seconds)
{
    if (!std::isfinite(seconds) || seconds < 0) {
        return "-";
    }
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    if (whole < 3600) {
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    }
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace deadpoint::report
