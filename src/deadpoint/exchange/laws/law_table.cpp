#include "deadpoint/exchange/laws/law_table.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace deadpoint {
namespace {

constexpr double smallest_interval = 1e-9;  // relative to the range
constexpr int first_intervals = 8;          // so that no feature hides between the test points of an interval

struct Point {
    double at = 0;
    LawValue law;
};

LawValue cubic(const Point& a, const Point& b, double at)
{
    const double h = b.at - a.at, s = (at - a.at) / h;
    const double from = a.law.value, to = b.law.value, rise = h * a.law.slope, end = h * b.law.slope;
    const double value = from * (1 + 2 * s) * (1 - s) * (1 - s) + rise * s * (1 - s) * (1 - s) +
                         to * s * s * (3 - 2 * s) + end * s * s * (s - 1);
    const double slope = (6 * s * (1 - s) * (to - from) + rise * (1 - s) * (1 - 3 * s) + end * s * (3 * s - 2)) / h;
    return {value, slope, true};
}

// Value of the law, or a non-finite value where the law is not defined.
LawValue value_at(const std::function<LawValue(double)>& law, double at)
{
    try {
        return law(at);
    } catch (const DomainError&) {
        return {NAN, NAN, false};
    }
}

bool is_finite(const LawValue& value) { return std::isfinite(value.value) && std::isfinite(value.slope); }

// The place between `inside`, where a condition holds, and `outside` up to which it does.
template <class Condition>
double edge(double inside, double outside, const Condition& holds)
{
    if (holds(outside))
        return outside;
    for (int i = 0; i < 60; ++i) {
        const double middle = (inside + outside) / 2;
        (holds(middle) ? inside : outside) = middle;
    }
    return inside;
}

class Tabulation {
public:
    Tabulation(const std::function<LawValue(double)>& law, double tolerance, double smallest)
        : law_(law), tolerance_(tolerance), smallest_(smallest)
    {}
    [[nodiscard]] Point point(double at) const { return {at, value_at(law_, at)}; }
    // Appends the points after `a` up to and including `b`.
    void refine(const Point& a, const Point& b, std::vector<Point>& points) const
    {
        if (b.at - a.at > smallest_ && !meets(a, b)) {
            const auto middle = point((a.at + b.at) / 2);
            refine(a, middle, points);
            refine(middle, b, points);
        } else {
            points.push_back(b);
        }
    }

private:
    [[nodiscard]] bool meets(const Point& a, const Point& b) const
    {
        return std::ranges::all_of(std::initializer_list<double>{0.25, 0.5, 0.75}, [&](double share) {
            const double at = a.at + share * (b.at - a.at), exact = value_at(law_, at).value;
            const double size =
                std::max(std::abs(exact), 1e-3 * std::max(std::abs(a.law.value), std::abs(b.law.value)));
            return std::abs(cubic(a, b, at).value - exact) <= tolerance_ * size;
        });
    }

    const std::function<LawValue(double)>& law_;
    double tolerance_;
    double smallest_;
};

// To rounding, at places that no period of a law meets all.
bool is_straight(const std::function<LawValue(double)>& law, const Point& a, const Point& b)
{
    const double size = std::abs(a.law.value) + std::abs(b.law.value);
    for (int i = 1; i < first_intervals; ++i) {
        const double at = a.at + (b.at - a.at) * (i + 0.1 * i / first_intervals) / (first_intervals + 1);
        if (!(std::abs(cubic(a, b, at).value - value_at(law, at).value) <= 1e-14 * size))
            return false;
    }
    return true;
}

}  // namespace

void LawTable::tabulate(const Law& law, const LawTableRange& range)
{
    const double middle = (range.from + range.to) / 2;
    const auto finite = [&](double at) { return is_finite(value_at(law, at)); };
    if (!finite(middle))
        throw DomainError("a heat law is not finite at " + std::to_string(middle) +
                          " K; look for a value of its row that cannot be meant");
    const double from = edge(middle, range.from, finite), to = edge(middle, range.to, finite);
    const Tabulation tabulation(law, range.tolerance, smallest_interval * (to - from));
    std::vector<Point> points{tabulation.point(from)};
    const auto end = tabulation.point(to);
    if (is_straight(law, points.front(), end))
        points.push_back(end);
    else
        for (int i = 1; i <= first_intervals; ++i)
            tabulation.refine(points.back(), tabulation.point(from + (to - from) * i / first_intervals), points);
    for (const auto& point : points) {
        at_.push_back(point.at);
        value_.push_back(point.law.value);
        slope_.push_back(point.law.slope);
    }
    const auto tested = [&](double at) { return value_at(law, at).in_range; };
    const auto sound = std::ranges::find_if(points, [](const Point& point) { return point.law.in_range; });
    tested_from_ = sound == points.end() ? INFINITY : edge(sound->at, from, tested);
    tested_to_ = sound == points.end() ? -INFINITY : edge(sound->at, to, tested);
}

LawTable LawTable::affine(double factor, double offset) const
{
    auto result = *this;
    for (auto& value : result.value_)
        value = offset + factor * value;
    for (auto& slope : result.slope_)
        slope *= factor;
    return result;
}

LawValue LawTable::operator()(double at) const
{
    const bool tested = at >= tested_from_ && at <= tested_to_;
    const auto straight = [&](std::size_t k) {
        return LawValue{value_[k] + slope_[k] * (at - at_[k]), slope_[k], tested};
    };
    if (!(at > at_.front()))
        return straight(0);
    if (at >= at_.back())
        return straight(at_.size() - 1);
    const auto upper = static_cast<std::size_t>(std::ranges::upper_bound(at_, at) - at_.begin());
    auto result = cubic({at_[upper - 1], {value_[upper - 1], slope_[upper - 1], true}},
                        {at_[upper], {value_[upper], slope_[upper], true}}, at);
    result.in_range = tested;
    return result;
}

std::string text_of(const LawTable& table)
{
    std::string text;
    char line[96];
    for (std::size_t i = 0; i < table.points().size(); ++i) {
        std::snprintf(line, sizeof line, "%.10g %.17g %.17g\n", table.points()[i], table.values()[i],
                      table.slopes()[i]);
        text += line;
    }
    return text;
}

std::string hash_of(const LawTable& table)
{
    StableHash hash;
    const auto add = [&](const double& value) {
        hash.add(std::string_view(reinterpret_cast<const char*>(&value), sizeof value));
    };
    for (const auto* column : {&table.points(), &table.values(), &table.slopes()})
        std::ranges::for_each(*column, add);
    char digits[24];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash.value()));
    return digits;
}

}  // namespace deadpoint
