#pragma once

#include <vector>

namespace deadpoint {

/// A curve that is linear between its points and constant beyond them, with its exact integral.
class LinearCurve {
public:
    LinearCurve() = default;
    /// @param x  places, strictly increasing
    /// @param y  as many values
    /// @throws DomainError if there are none, their numbers differ, x does not increase, or one is not finite
    LinearCurve(std::vector<double> x, std::vector<double> y);

    [[nodiscard]] bool empty() const { return x_.empty(); }
    [[nodiscard]] const std::vector<double>& x() const { return x_; }
    [[nodiscard]] const std::vector<double>& y() const { return y_; }
    [[nodiscard]] double value(double at) const;
    /// 0 beyond the points; at an inner point, the slope on the right side.
    [[nodiscard]] double slope(double at) const;
    /// Integral from the first point; beyond the ends it uses the constant values.
    [[nodiscard]] double integral(double to) const;
    /// True if `at` lies beyond the points.
    [[nodiscard]] bool outside(double at) const { return at < x_.front() || at > x_.back(); }

private:
    /// Index of the interval that contains an inner position.
    [[nodiscard]] std::size_t stretch(double at) const;

    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> sum_;  ///< the integral at the points
};

}  // namespace deadpoint
