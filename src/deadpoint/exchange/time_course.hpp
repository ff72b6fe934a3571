#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace deadpoint {

/// What a step leaves out of a course that it takes for a parabola with the course's ends and integral.
struct Unseen {
    double integral = 0;  ///< largest integral of the difference since the step's start [unit of the course x s]
    double value = 0;     ///< largest difference [unit of the course]
};

/// A quantity over the time since the run began: a table of points, a function, or their sum. Tables are linear between
/// their points and hold the first and the last value beyond them.
class TimeCourse {
public:
    /// Features of a function that last shorter may be missed [s].
    static constexpr double finest = 1;
    /// A table with two equal times is a jump, which is made a ramp of this length about it, so that courses are
    /// continuous and keep their integral [s].
    static constexpr double jump = 1e-3;

    TimeCourse() = default;
    /// @param function  of the time [s]
    /// @param width     in which the function is smooth [s]
    template <class Function>
    requires(std::is_invocable_r_v<double, const Function&, double> &&
             !std::same_as<std::remove_cvref_t<Function>, TimeCourse>)
        TimeCourse(Function function, double width = finest)
        : function_(std::move(function)), width_(width)
    {}
    /// @param times  increasing, or twice the same at a jump; at least one [s]
    /// @throws DomainError if the sizes differ or times do not increase
    TimeCourse(std::vector<double> times, std::vector<double> values);
    static TimeCourse constant(double value) { return {{0.0}, {value}}; }

    /// False if it was not given.
    explicit operator bool() const { return function_ || !times_.empty(); }
    double operator()(double time) const;
    /// True if it is one value at all times.
    [[nodiscard]] bool is_constant() const { return !function_ && times_.size() < 2; }
    /// True if it has neither a point between two times nor a function.
    [[nodiscard]] bool is_linear(double from, double to) const;
    /// Exact of a table; of a function by Gauss' method on pieces of its width.
    [[nodiscard]] double mean(double from, double to) const;

    /// The table's points between two times, without these.
    [[nodiscard]] std::vector<double> points(double from, double to) const;
    /// The same, and in between times at distances of the function's width.
    [[nodiscard]] std::vector<double> looked_at(double from, double to) const;
    [[nodiscard]] Unseen unseen(double from, double to) const;

    [[nodiscard]] TimeCourse times(double factor) const;
    /// @param width  in which the function is smooth [s]
    [[nodiscard]] TimeCourse plus(const std::function<double(double)>& function, double width) const;

private:
    [[nodiscard]] double table(double time) const;
    [[nodiscard]] double table_integral(double from, double to) const;
    [[nodiscard]] double function_integral(double from, double to) const;
    [[nodiscard]] std::pair<std::size_t, std::size_t> between(double from, double to) const;

    std::vector<double> times_, values_;
    std::function<double(double)> function_;
    double width_ = finest;
};

}  // namespace deadpoint
