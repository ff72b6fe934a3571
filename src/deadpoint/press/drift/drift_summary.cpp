#include "deadpoint/press/drift/drift_summary.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::press {
namespace {

constexpr double sampling = 10;         ///< [s]
constexpr double most_samples = 20000;  ///< with more samples the sampling becomes coarser

/// The steps and a regular grid, without repetition.
std::vector<double> sample_times(const std::vector<double>& time)
{
    const double length = time.back() - time.front();
    const double spacing = std::max(sampling, length / most_samples);
    std::vector<double> samples = time;
    const int count = static_cast<int>(std::ceil(length / spacing));
    for (int i = 0; i < count; ++i) {
        samples.push_back(time.front() + i * spacing);
    }
    std::ranges::sort(samples);
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    return samples;
}

class Course {
public:
    Course(const std::vector<double>& time, const Series& series)
        : time_(time), series_(series), samples_(sample_times(time))
    {}

    [[nodiscard]] double at(double time) const { return interpolate(time_, series_, time); }
    [[nodiscard]] double length() const { return time_.back() - time_.front(); }

    [[nodiscard]] StretchSummary stretch(double wanted) const
    {
        StretchSummary result;
        result.cut_short = length() < wanted * (1 - 1e-9);
        result.span = std::min(wanted, length());
        const double start = time_.front();
        const double end = start + result.span;
        const double first = at(start), last = at(end);
        double low = std::min(first, last), high = std::max(first, last);
        for (const double t : samples_) {
            if (t > end) {
                break;
            }
            low = std::min(low, at(t));
            high = std::max(high, at(t));
        }
        result.change = last - first;
        result.range = high - low;
        return result;
    }

    void largest_rate(CourseSummary& summary) const
    {
        summary.window = std::min(rate_window, length());
        summary.largest_rate_from = time_.front();
        if (summary.window <= 0) {
            return;
        }
        const auto consider = [&](double from) {
            const double rate = (at(from + summary.window) - at(from)) / summary.window;
            if (std::abs(rate) > std::abs(summary.largest_rate)) {
                summary.largest_rate = rate;
                summary.largest_rate_from = from;
            }
        };
        for (const double t : samples_) {
            if (t + summary.window <= time_.back()) {
                consider(t);
            }
        }
        consider(time_.back() - summary.window);
    }

private:
    const std::vector<double>& time_;
    const Series& series_;
    std::vector<double> samples_;
};

/// Rate within a step [per second] over its share s: the derivative of the cubic that `interpolate` evaluates,
/// a + b s + c s^2.
class StepRate {
public:
    StepRate(const std::vector<double>& time, const Series& series, std::size_t k) : a_(series.rate[k])
    {
        const double mean = (series.value[k + 1] - series.value[k]) / (time[k + 1] - time[k]);
        b_ = 6 * mean - 4 * series.rate[k] - 2 * series.rate[k + 1];
        c_ = 3 * (series.rate[k] + series.rate[k + 1] - 2 * mean);
    }
    /// Share of the step behind which the magnitude stays at or below a limit, if it is above it before.
    [[nodiscard]] std::optional<double> last_above(double limit) const
    {
        std::optional<double> last;
        for (const double level : {limit, -limit}) {
            for (const double s : roots(level)) {
                if (s > 0 && s <= 1 && std::abs(at(std::max(0.0, s - probe))) > limit && s > last.value_or(0)) {
                    last = s;
                }
            }
        }
        return last;
    }

private:
    static constexpr double probe = 1e-6;  // share of the step
    [[nodiscard]] double at(double s) const { return a_ + s * (b_ + s * c_); }
    [[nodiscard]] std::vector<double> roots(double level) const
    {
        const double a = a_ - level;
        const double inside = b_ * b_ - 4 * a * c_;
        if (inside < 0) {
            return {};
        }
        const double q = -0.5 * (b_ + std::copysign(std::sqrt(inside), b_));
        std::vector<double> found;
        if (c_ != 0) {
            found.push_back(q / c_);
        }
        if (q != 0) {
            found.push_back(a / q);
        }
        return found;
    }
    double a_;
    double b_ = 0;
    double c_ = 0;
};

}  // namespace

CourseSummary summarise_course(const std::vector<double>& time, const Series& series)
{
    if (time.empty() || series.value.size() != time.size() || series.rate.size() != time.size()) {
        throw DomainError("a course needs one value and one rate for each of its steps, and one step at least");
    }
    const Course course(time, series);
    CourseSummary summary;
    summary.first_hour = course.stretch(first_hour);
    summary.four_hours = course.stretch(four_hours);
    summary.range = course.stretch(course.length()).range;
    course.largest_rate(summary);
    return summary;
}

std::optional<double> steady_from(const std::vector<double>& time, const Series& series, double rate_limit)
{
    if (std::abs(series.rate.back()) > rate_limit) {
        return std::nullopt;
    }
    for (std::size_t k = time.size() - 1; k > 0; --k) {
        const StepRate rate(time, series, k - 1);
        if (const auto share = rate.last_above(rate_limit)) {
            return time[k - 1] + *share * (time[k] - time[k - 1]);
        }
    }
    return time.front();
}

double time_to_share(std::span<const double> time, std::span<const double> value, double share)
{
    double since = time.front();
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (std::abs(value[k] - value.back()) > (1 - share) * std::abs(value.back() - value.front())) {
            since = time[std::min(k + 1, time.size() - 1)];
        }
    }
    return since;
}

}  // namespace deadpoint::press
