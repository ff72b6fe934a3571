#include "deadpoint/twin/explore/objectives.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::twin {
namespace {

constexpr std::size_t samples = 200;  // of a mean over time
constexpr double power = 8;           // of largest_rate()

/// A value between two rows.
struct TimePlace {
    std::size_t row = 0;
    double share = 0;
    [[nodiscard]] double of(const std::vector<double>& values) const
    {
        return (1 - share) * values[row] + share * values[row + 1];
    }
};

TimePlace place_of(const std::vector<double>& time, double at)
{
    const auto above = std::ranges::upper_bound(time, at) - time.begin();
    const auto row = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(time.size()) - 2));
    return {row, (at - time[row]) / (time[row + 1] - time[row])};
}

std::vector<TimePlace> places_from(const std::vector<double>& time, double from)
{
    std::vector<TimePlace> result;
    for (std::size_t k = 0; k < samples; ++k)
        result.push_back(place_of(time, from + (time.back() - from) * static_cast<double>(k) / (samples - 1)));
    return result;
}

// sqrt(mean(y^2)) and its slopes, from y and dy at evenly spread times, by the trapezoidal rule.
struct RootMeanSquare {
    double sum = 0;
    std::vector<double> slopes;

    void add(std::size_t sample, double value, const std::vector<double>& slope)
    {
        const double weight = (sample == 0 || sample + 1 == samples ? 0.5 : 1) / (samples - 1);
        sum += weight * value * value;
        slopes.resize(slope.size());
        for (std::size_t k = 0; k < slope.size(); ++k)
            slopes[k] += weight * value * slope[k];
    }
    [[nodiscard]] Judged result() const
    {
        Judged judged{std::sqrt(sum), slopes};
        for (double& slope : judged.slope)
            slope = judged.value > 0 ? slope / judged.value : 0;
        return judged;
    }
};

/// dE/dt between rows, at their middles.
struct Rates {
    std::vector<double> time, value;
    std::vector<std::vector<double>> derivative;
};

Rates rates_of(const GapCourse& course)
{
    Rates rates;
    rates.derivative.resize(course.derivative.size());
    for (std::size_t row = 0; row + 1 < course.time.size(); ++row) {
        const double step = course.time[row + 1] - course.time[row];
        rates.time.push_back(course.time[row] + 0.5 * step);
        rates.value.push_back((course.value[row + 1] - course.value[row]) / step);
        for (std::size_t k = 0; k < course.derivative.size(); ++k)
            rates.derivative[k].push_back((course.derivative[k][row + 1] - course.derivative[k][row]) / step);
    }
    return rates;
}

Judged never_warm(const Rates& rates, double limit, double end)
{
    const double last = rates.value.back();
    Judged judged{end * (1 + std::log(std::abs(last) / limit)), {}};
    for (const auto& of : rates.derivative)
        judged.slope.push_back(end * of.back() / last);
    return judged;
}

}  // namespace

GapCourse gap_course(const ForwardModel& model, const Forecast& forecast)
{
    const auto found = std::ranges::find(model.outputs(), "E_SW", &ForwardOutput::name);
    if (found == model.outputs().end())
        throw InputError("the case has no dimension chain, so that E_SW is not known\n  help: add [chain] to the case");
    const auto output = static_cast<std::size_t>(found - model.outputs().begin());
    GapCourse course;
    course.derivative.resize(forecast.derivative.size());
    for (std::size_t row = 0; row < forecast.time.size(); ++row) {
        if (!course.time.empty() && forecast.time[row] <= course.time.back())
            continue;  // where segments meet
        course.time.push_back(forecast.time[row]);
        course.value.push_back(forecast.value[output][row]);
        for (std::size_t k = 0; k < course.derivative.size(); ++k)
            course.derivative[k].push_back(forecast.derivative[k][output][row]);
    }
    return course;
}

Judged drift_of(const GapCourse& course, double from)
{
    RootMeanSquare mean;
    const auto places = places_from(course.time, from);
    const auto& start = places.front();
    for (std::size_t s = 0; s < places.size(); ++s) {
        std::vector<double> slope;
        for (const auto& of : course.derivative)
            slope.push_back(places[s].of(of) - start.of(of));
        mean.add(s, places[s].of(course.value) - start.of(course.value), slope);
    }
    return mean.result();
}

Judged ambient_effect(const GapCourse& more, const GapCourse& less, double d, double from)
{
    RootMeanSquare mean;
    const auto at_more = places_from(more.time, from), at_less = places_from(less.time, from);
    for (std::size_t s = 0; s < at_more.size(); ++s) {
        std::vector<double> slope;
        for (std::size_t k = 0; k < more.derivative.size(); ++k)
            slope.push_back((at_more[s].of(more.derivative[k]) - at_less[s].of(less.derivative[k])) / (2 * d));
        mean.add(s, (at_more[s].of(more.value) - at_less[s].of(less.value)) / (2 * d), slope);
    }
    return mean.result();
}

Judged warm_time(const GapCourse& course, double rate)
{
    const auto rates = rates_of(course);
    if (std::abs(rates.value.back()) > rate)
        return never_warm(rates, rate, course.time.back());
    std::size_t row = rates.value.size() - 1;
    while (row > 0 && std::abs(rates.value[row - 1]) <= rate)
        --row;
    if (row == 0)
        return {0, std::vector<double>(course.derivative.size(), 0.0)};
    // The limit with the sign of the rate that exceeds it lies between the middles row - 1 and row.
    const double limit = std::copysign(rate, rates.value[row - 1]);
    const double drop = rates.value[row - 1] - rates.value[row];
    const double share = (rates.value[row - 1] - limit) / drop, width = rates.time[row] - rates.time[row - 1];
    Judged judged{rates.time[row - 1] + share * width, {}};
    for (const auto& of : rates.derivative)
        judged.slope.push_back(width * ((1 - share) * of[row - 1] + share * of[row]) / drop);
    return judged;
}

Judged largest_rate(const GapCourse& course, double rate, double from)
{
    const auto rates = rates_of(course);
    const auto first = static_cast<std::size_t>(std::ranges::lower_bound(rates.time, from) - rates.time.begin());
    const auto count = static_cast<double>(rates.time.size() - first);
    double sum = 0;
    std::vector<double> slopes(rates.derivative.size());
    for (std::size_t row = first; row < rates.time.size(); ++row) {
        const double size = std::abs(rates.value[row]) / rate;
        sum += std::pow(size, power) / count;
        const double slope = std::copysign(std::pow(size, power - 1) / (rate * count), rates.value[row]);
        for (std::size_t k = 0; k < slopes.size(); ++k)
            slopes[k] += slope * rates.derivative[k][row];
    }
    Judged judged{std::pow(sum, 1 / power), std::move(slopes)};
    for (double& slope : judged.slope)
        slope *= sum > 0 ? judged.value / sum : 0;
    return judged;
}

}  // namespace deadpoint::twin
