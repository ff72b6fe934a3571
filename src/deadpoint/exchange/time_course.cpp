#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint {
namespace {

constexpr double rounding = 1e-12;

// Moves the two points of a jump apart, not beyond half the way to their neighbours.
void make_ramps(std::vector<double>& times)
{
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] != times[i - 1])
            continue;
        const double at = times[i];
        const double before = i > 1 ? at - times[i - 2] : TimeCourse::jump;
        const double after = i + 1 < times.size() ? times[i + 1] - at : TimeCourse::jump;
        const double half = 0.5 * std::min({TimeCourse::jump, before, after});
        times[i - 1] = at - half;
        times[i] = at + half;
    }
}

}  // namespace

TimeCourse::TimeCourse(std::vector<double> times, std::vector<double> values)
    : times_(std::move(times)), values_(std::move(values))
{
    if (times_.empty() || times_.size() != values_.size())
        throw DomainError(fmt::format("a course over time has {} times and {} values\n  help: give one value per time",
                                      times_.size(), values_.size()));
    make_ramps(times_);
    const auto wrong = std::ranges::adjacent_find(times_, [](double a, double b) { return !(a < b); });
    if (wrong != times_.end())
        throw DomainError(
            fmt::format("the times of a course must increase, but {} s is followed by {} s", *wrong, wrong[1]));
}

double TimeCourse::operator()(double time) const
{
    return (times_.empty() ? 0 : table(time)) + (function_ ? function_(time) : 0);
}

bool TimeCourse::is_linear(double from, double to) const
{
    const auto [first, last] = between(from, to);
    return !function_ && first == last;
}

double TimeCourse::table(double time) const
{
    if (time <= times_.front())
        return values_.front();
    if (time >= times_.back())
        return values_.back();
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(times_, time) - times_.begin()) - 1;
    const double slope = (values_[i + 1] - values_[i]) / (times_[i + 1] - times_[i]);
    return values_[i] + slope * (time - times_[i]);
}

// Indices of the first point behind `from`, and of the first that is not before `to`.
std::pair<std::size_t, std::size_t> TimeCourse::between(double from, double to) const
{
    const auto first = std::ranges::upper_bound(times_, from), last = std::ranges::lower_bound(times_, to);
    const auto index = [&](auto at) { return static_cast<std::size_t>(at - times_.begin()); };
    return {index(first), std::max(index(first), index(last))};
}

double TimeCourse::table_integral(double from, double to) const
{
    const auto [first, last] = between(from, to);
    double sum = 0, time = from, value = table(from);
    const auto go = [&](double next, double then) {
        sum += 0.5 * (next - time) * (value + then);
        time = next;
        value = then;
    };
    for (std::size_t i = first; i < last; ++i)
        go(times_[i], values_[i]);
    go(to, table(to));
    return sum;
}

double TimeCourse::function_integral(double from, double to) const
{
    const double places = std::sqrt(0.6), pieces = std::max(1.0, std::ceil((to - from) / width_ - 1e-9));
    const double half = 0.5 * (to - from) / pieces;
    double sum = 0;
    for (double k = 0; k < pieces; ++k) {
        const double middle = from + (2 * k + 1) * half;
        sum += half / 9 *
               (5 * function_(middle - places * half) + 8 * function_(middle) + 5 * function_(middle + places * half));
    }
    return sum;
}

double TimeCourse::mean(double from, double to) const
{
    return ((times_.empty() ? 0 : table_integral(from, to)) + (function_ ? function_integral(from, to) : 0)) /
           (to - from);
}

std::vector<double> TimeCourse::points(double from, double to) const
{
    const auto [first, last] = between(from, to);
    const auto at = [&](std::size_t i) { return times_.begin() + static_cast<std::ptrdiff_t>(i); };
    return {at(first), at(last)};
}

std::vector<double> TimeCourse::looked_at(double from, double to) const
{
    auto result = points(from, to);
    if (!function_)
        return result;
    for (double k = std::floor(from / width_) + 1; k * width_ < to; ++k)
        result.push_back(k * width_);
    std::ranges::sort(result);
    return result;
}

Unseen TimeCourse::unseen(double from, double to) const
{
    auto places = looked_at(from, to);
    if (places.empty())
        return {};
    places.push_back(to);
    const double length = to - from, start = (*this)(from), change = (*this)(to)-start;
    const double bulge = 6 * (mean(from, to) - start - 0.5 * change);
    Unseen result;
    double sum = 0, before = from, largest = std::max(std::abs(start), std::abs((*this)(to)));
    for (const double time : places) {
        const double s = (time - from) / length;
        sum += (time - before) * mean(before, time);
        const double seen = length * s * (start + s * (change / 2 + bulge * (0.5 - s / 3)));
        result.integral = std::max(result.integral, std::abs(sum - seen));
        const double value = (*this)(time);
        result.value = std::max(result.value, std::abs(value - start - s * (change + bulge * (1 - s))));
        largest = std::max(largest, std::abs(value));
        before = time;
    }
    return result.value > rounding * largest ? result : Unseen{};
}

TimeCourse TimeCourse::times(double factor) const
{
    auto result = *this;
    for (double& value : result.values_)
        value *= factor;
    if (function_)
        result.function_ = [function = function_, factor](double time) { return factor * function(time); };
    return result;
}

TimeCourse TimeCourse::plus(const std::function<double(double)>& function, double width) const
{
    auto result = *this;
    result.function_ =
        function_ ? [first = function_, function](double time) { return first(time) + function(time); } : function;
    result.width_ = function_ ? std::min(width, width_) : width;
    return result;
}

}  // namespace deadpoint
