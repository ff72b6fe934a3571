#include "deadpoint/core/linear_curve.hpp"

#include "deadpoint/core/table.hpp"

#include <algorithm>

namespace deadpoint {

LinearCurve::LinearCurve(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y))
{
    (void)interpolate_linear(x_, y_, 0);  // refuses values that are not a curve
    sum_.assign(x_.size(), 0.0);
    for (std::size_t i = 1; i < x_.size(); ++i)
        sum_[i] = sum_[i - 1] + 0.5 * (y_[i] + y_[i - 1]) * (x_[i] - x_[i - 1]);
}

std::size_t LinearCurve::stretch(double at) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(x_, at) - x_.begin()) - 1;
}

double LinearCurve::slope(double at) const
{
    if (at < x_.front() || at >= x_.back())
        return 0;
    const auto i = stretch(at);
    return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
}

double LinearCurve::value(double at) const
{
    if (at < x_.front())
        return y_.front();
    if (at >= x_.back())
        return y_.back();
    const auto i = stretch(at);
    return y_[i] + (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]) * (at - x_[i]);
}

double LinearCurve::integral(double to) const
{
    if (to < x_.front())
        return y_.front() * (to - x_.front());
    if (to >= x_.back())
        return sum_.back() + y_.back() * (to - x_.back());
    const auto i = stretch(to);
    return sum_[i] + 0.5 * (y_[i] + value(to)) * (to - x_[i]);
}

}  // namespace deadpoint
