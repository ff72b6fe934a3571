#include "deadpoint/machine/foreign/mesh_sections.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <string_view>

namespace deadpoint::machine {
namespace {

/// Lines with their numbers, without carriage returns.
class Lines {
public:
    explicit Lines(std::istream& stream) : stream_(stream) {}
    bool next()
    {
        if (!std::getline(stream_, text_)) {
            return false;
        }
        ++number_;
        if (text_.ends_with('\r')) {
            text_.pop_back();
        }
        return true;
    }
    [[nodiscard]] std::string_view text() const { return text_; }
    [[nodiscard]] std::size_t number() const { return number_; }
    [[nodiscard]] bool blank() const { return text_.find_first_not_of(" \t") == std::string::npos; }

private:
    std::istream& stream_;
    std::string text_;
    std::size_t number_ = 0;
};

/// The first two numbers of a line; the second is 0 where there is only one.
std::optional<std::array<double, 2>> counts_in(std::string_view text)
{
    std::array<double, 2> result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        unsigned long long value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() && (i == 0 || !text.empty())) {
            return std::nullopt;
        }
        result[i] = static_cast<double>(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return result;
}

/// How many lines follow the line of counts.
double lines_of(std::string_view section, const std::array<double, 2>& counts, double version)
{
    if (version < 4 || section == "$PhysicalNames") {
        return counts[0];
    }
    // Each block has one line. In version 4.1 a node has a line with its number and another with its coordinates.
    const double lines_each = section == "$Nodes" && version > 4.05 ? 2 : 1;
    return counts[0] + lines_each * counts[1];
}

bool is_counted(std::string_view section)
{
    return section == "$Nodes" || section == "$Elements" || section == "$PhysicalNames";
}

std::string wrong_count_in(Lines& lines, double version)
{
    const std::string section{lines.text()};
    const auto counts = lines.next() ? counts_in(lines.text()) : std::nullopt;
    if (!counts) {
        return fmt::format("line {}: section {} does not begin with its count", lines.number(), section);
    }
    const std::size_t begin = lines.number();
    const double wanted = lines_of(section, *counts, version);
    double found = 0;
    while (lines.next() && !lines.text().starts_with('$')) {
        found += lines.blank() ? 0 : 1;
    }
    if (found != wanted) {
        return fmt::format("line {}: by its count section {} has {:.0f} lines, but it has {:.0f}", begin, section,
                           wanted, found);
    }
    return {};
}

}  // namespace

std::string wrong_count(std::istream& mesh, double version)
{
    Lines lines(mesh);
    while (lines.next()) {
        if (is_counted(lines.text())) {
            if (auto wrong = wrong_count_in(lines, version); !wrong.empty()) {
                return wrong;
            }
        }
    }
    return {};
}

}  // namespace deadpoint::machine
