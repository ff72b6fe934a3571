#include "driver_speed.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::mechanism {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Piecewise cubic through points of one turn; the first point is repeated a turn later.
struct PeriodicCubic {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> slope;

    struct Value {
        double value;
        double derivative;
    };
    [[nodiscard]] Value at(double angle) const
    {
        double since = std::fmod(angle - x.front(), turn);
        if (since < 0)
            since += turn;
        const double place = x.front() + since;
        const auto after = std::upper_bound(x.begin() + 1, x.end() - 1, place);
        const auto i = static_cast<std::size_t>(after - x.begin()) - 1;
        // Hermite's basis on [0, 1].
        const double h = x[i + 1] - x[i];
        const double t = (place - x[i]) / h;
        const double rise = (y[i + 1] - y[i]) / h;
        const double c = 3 * rise - 2 * slope[i] - slope[i + 1];
        const double d = slope[i] + slope[i + 1] - 2 * rise;
        return {y[i] + h * t * (slope[i] + t * (c + t * d)), slope[i] + t * (2 * c + 3 * t * d)};
    }
};

/// Slopes of Fritsch and Butland: zero at an extremum, else a weighted harmonic mean of the neighbours'.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y)
{
    const std::size_t n = x.size() - 1;
    std::vector<double> slopes(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = i == 0 ? n - 1 : i - 1;
        const double h0 = x[before + 1] - x[before];
        const double h1 = x[i + 1] - x[i];
        const double d0 = (y[before + 1] - y[before]) / h0;
        const double d1 = (y[i + 1] - y[i]) / h1;
        if (d0 * d1 > 0)
            slopes[i] = 3 * (h0 + h1) / ((2 * h1 + h0) / d0 + (h1 + 2 * h0) / d1);
    }
    slopes[n] = slopes[0];
    return slopes;
}

void check_speed(double speed)
{
    if (!(speed > 0) || !std::isfinite(speed))
        throw InputError(fmt::format("the driver's speed is {} rad/s\n  help: give a speed above zero; for the other "
                                     "sense of rotation mirror the linkage",
                                     speed));
}

}  // namespace

DriverSpeed steady_speed(double speed)
{
    check_speed(speed);
    return {[speed](double) { return speed; }, {}, {}};
}

DriverSpeed tabulated_speed(std::vector<double> past_bottom, std::vector<double> speed)
{
    if (past_bottom.empty() || past_bottom.size() != speed.size())
        throw InputError(fmt::format("the table of the driver's speed has {} angles and {} speeds\n  help: give one "
                                     "speed for each angle, at least one",
                                     past_bottom.size(), speed.size()));
    std::for_each(speed.begin(), speed.end(), check_speed);
    for (std::size_t i = 0; i < past_bottom.size(); ++i)
        if (!std::isfinite(past_bottom[i]) || (i > 0 && !(past_bottom[i] > past_bottom[i - 1])))
            throw InputError(fmt::format("the table of the driver's speed does not increase in angle at its point {} "
                                         "({} rad)\n  help: sort its points by angle, each once",
                                         i + 1, past_bottom[i]));
    if (!(past_bottom.back() - past_bottom.front() < turn))
        throw InputError("the table of the driver's speed spans a whole turn or more\n  help: leave out the point that "
                         "repeats the first; the table is closed over the turn");
    if (past_bottom.size() == 1)
        return steady_speed(speed.front());

    DriverSpeed result;
    result.breaks = past_bottom;
    past_bottom.push_back(past_bottom.front() + turn);
    speed.push_back(speed.front());
    std::vector<double> slopes = monotone_slopes(past_bottom, speed);
    const PeriodicCubic curve{std::move(past_bottom), std::move(speed), std::move(slopes)};
    result.speed = [curve](double angle) { return curve.at(angle).value; };
    result.slope = [curve](double angle) { return curve.at(angle).derivative; };
    return result;
}

}  // namespace deadpoint::mechanism
