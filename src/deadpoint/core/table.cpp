#include "deadpoint/core/table.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint {
namespace {

void check_curve(std::span<const double> x, std::span<const double> y, double at)
{
    if (x.empty() || x.size() != y.size()) {
        throw DomainError(fmt::format("a curve needs as many values as places, at least one; it has {} places and {} "
                                      "values",
                                      x.size(), y.size()));
    }
    const auto finite = [](double v) { return std::isfinite(v); };
    if (!std::ranges::all_of(x, finite) || !std::ranges::all_of(y, finite) || !std::isfinite(at)) {
        throw DomainError("a curve was given or asked at a number that is not finite");
    }
    const auto wrong = std::ranges::adjacent_find(x, [](double a, double b) { return !(a < b); });
    if (wrong != x.end()) {
        throw DomainError(
            fmt::format("the places of a curve must increase, but {} is followed by {}", *wrong, wrong[1]));
    }
}

}  // namespace

CurvePoint interpolate_linear(std::span<const double> x, std::span<const double> y, double at)
{
    check_curve(x, y, at);
    if (at < x.front()) {
        return {y.front(), 0, true};
    }
    if (at >= x.back()) {
        return {y.back(), 0, at > x.back()};
    }
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin()) - 1;
    const double slope = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    return {y[i] + slope * (at - x[i]), slope, false};
}

}  // namespace deadpoint
