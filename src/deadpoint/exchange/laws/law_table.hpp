#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <concepts>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace deadpoint {

/// Range and tolerance of a table.
struct LawTableRange {
    double from = 213.15;      ///< -60 degC [K]
    double to = 573.15;        ///< 300 degC [K]
    double tolerance = 1e-10;  ///< largest error of the table between its points, of the law's value there
};

/// A law of one variable as data: values and slopes at points, cubic between them, linear beyond
/// them.
///
/// Any law becomes a table to a stated tolerance: intervals are halved until the cubic through
/// value and slope of both ends meets the law at three places between them. A linear law has two
/// points. An interval at a kink or a jump is halved down to 1e-9 of the range; there the table is
/// steep and continuous, and misses the tolerance. A law that is not finite at an end of the range
/// is tabulated as far as it is finite.
///
/// Unlike a function, a table can be printed, stored, compared, and passed to another program.
class LawTable {
public:
    /// No law.
    LawTable() = default;
    template <std::invocable<double> Law>
    LawTable(const Law& law, const LawTableRange& range = {})
    {
        if constexpr (std::is_class_v<Law> && std::constructible_from<bool, const Law&>) {
            if (!static_cast<bool>(law))
                return;
        }
        tabulate([&law](double at) { return LawValue(law(at)); }, range);
    }

    [[nodiscard]] explicit operator bool() const { return !at_.empty(); }
    /// Flagged as out of range beyond the table, and where the law was out of range.
    [[nodiscard]] LawValue operator()(double at) const;
    /// The table of offset + factor times this law, at the same points.
    [[nodiscard]] LawTable affine(double factor, double offset) const;

    /// Ascending.
    [[nodiscard]] const std::vector<double>& points() const { return at_; }
    [[nodiscard]] const std::vector<double>& values() const { return value_; }
    [[nodiscard]] const std::vector<double>& slopes() const { return slope_; }
    [[nodiscard]] bool operator==(const LawTable&) const = default;
    friend constexpr auto members(const LawTable*)
    {
        return std::tuple{&LawTable::at_, &LawTable::value_, &LawTable::slope_, &LawTable::tested_from_,
                          &LawTable::tested_to_};
    }

private:
    using Law = std::function<LawValue(double)>;
    void tabulate(const Law& law, const LawTableRange& range);

    std::vector<double> at_, value_, slope_;
    double tested_from_ = 0, tested_to_ = 0;  ///< where the law was in its tested range
};

/// A line for each point: variable, value, slope.
std::string text_of(const LawTable& table);
/// Hash of all numbers of a table: equal tables have equal hashes on every machine, others most likely not.
std::string hash_of(const LawTable& table);

}  // namespace deadpoint
