#include "deadpoint/press/drift/drift_summary.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::press;

namespace {

/// value = a (1 - exp(-t / tau)), every `step` up to `end`.
void exponential(double a, double tau, double step, double end, std::vector<double>& time, Series& series)
{
    for (double t = 0; t < end + step / 2; t += step) {
        time.push_back(t);
        series.value.push_back(a * (1 - std::exp(-t / tau)));
        series.rate.push_back(a / tau * std::exp(-t / tau));
    }
}

}  // namespace

TEST_CASE("an exponential course has the changes, range and largest rate of its formula")
{
    std::vector<double> time;
    Series series;
    exponential(-10, 3600, 60, 5 * 3600, time, series);
    const auto s = summarise_course(time, series);
    // All four times are steps, so that only rounding is left.
    CHECK(s.first_hour.change == near(-10 * (1 - std::exp(-1.0)), 1e-12));
    CHECK(s.first_hour.range == near(10 * (1 - std::exp(-1.0)), 1e-12));
    CHECK_FALSE(s.first_hour.cut_short);
    CHECK(s.four_hours.change == near(-10 * (1 - std::exp(-4.0)), 1e-12));
    CHECK(s.four_hours.span == 4 * 3600);
    CHECK(s.range == near(10 * (1 - std::exp(-5.0)), 1e-12));
    // The first ten minutes are the fastest: -10 (1 - exp(-1/6)) in 600 s.
    CHECK(s.window == 600);
    CHECK(s.largest_rate == near(-10 * (1 - std::exp(-1.0 / 6)) / 600, 1e-12));
    CHECK(s.largest_rate_from == 0);
}

TEST_CASE("the fastest window need not begin at the start, nor at a step; the range counts what lies between")
{
    // Still, then 6 um up within 10 min from 1900 s on, then 4 um down: a trapezoid with steps every 100 s.
    std::vector<double> time;
    Series series;
    for (int k = 0; k <= 90; ++k) {
        const double t = 100.0 * k;
        const double up = std::min(std::max(t - 1900, 0.0), 600.0) / 600;
        const double down = std::min(std::max(t - 6000, 0.0), 2000.0) / 2000;
        time.push_back(t);
        series.value.push_back(6 * up - 4 * down);
        series.rate.push_back(t > 1900 && t < 2500 ? 0.01 : t > 6000 && t < 8000 ? -0.002 : 0);
    }
    const auto s = summarise_course(time, series);
    CHECK(s.largest_rate == near(0.01, 1e-9));
    CHECK(s.largest_rate_from == near(1900, 1e-5));
    CHECK(s.first_hour.change == near(6, 1e-5));
    CHECK(s.four_hours.change == near(2, 1e-5));
    CHECK(s.four_hours.cut_short);
    CHECK(s.four_hours.span == 9000);
    CHECK(s.range == near(6, 1e-5));
}

TEST_CASE("the last window is looked at although it begins beside the samples")
{
    // t^2, which the cubic between the steps meets exactly: fastest from 403 s to 1003 s, by 1003 + 403 per second.
    const auto s = summarise_course({0, 1003}, {{0, 1003.0 * 1003.0}, {0, 2006}});
    CHECK(s.largest_rate_from == 403);
    CHECK(s.largest_rate == near(1406, 1e-12));
}

TEST_CASE("a run shorter than the stretches and the window is summarised over its length")
{
    const auto s = summarise_course({0, 300}, {{20, 23}, {0.01, 0.01}});  // a straight line
    CHECK(s.first_hour.cut_short);
    CHECK(s.first_hour.span == 300);
    CHECK(s.first_hour.change == near(3, 1e-5));
    CHECK(s.window == 300);
    CHECK(s.largest_rate == near(0.01, 1e-5));
    const auto nothing = summarise_course({0}, {{5}, {1}});  // interrupted before the first step
    CHECK(nothing.range == 0);
    CHECK(nothing.largest_rate == 0);
    CHECK_THROWS_AS((void)summarise_course({}, {}), DomainError);
    CHECK_THROWS_AS((void)summarise_course({0, 1}, {{0, 1}, {0}}), DomainError);
}

TEST_CASE("steady from the last time at which the rate, also between the steps, is too high")
{
    // t - t^2/40 is a cubic of the steps: its rate, 1 - t/20, is 0.3 at t = 14.
    CHECK(*steady_from({0, 20}, {{0, 10}, {1, 0}}, 0.3) == near(14, 1e-12));
    CHECK(*steady_from({0, 20}, {{0, -10}, {-1, 0}}, 0.3) == near(14, 1e-12));
    CHECK(*steady_from({0, 20, 50}, {{0, 10, 10}, {1, 0, 0}}, 0.3) == near(14, 1e-12));
    // 3 s^2 - 2 s^3 stands at both ends of a step of 10 and moves at 0.15 in its middle, above 0.1 until
    // 6 s (1 - s) = 1, s = (1 + sqrt(1/3)) / 2.
    CHECK(*steady_from({0, 10}, {{0, 1}, {0, 0}}, 0.1) == near(5 * (1 + std::sqrt(1.0 / 3)), 1e-12));
    CHECK(*steady_from({0, 10}, {{0, 1}, {0, 0}}, 0.2) == 0);
    CHECK(*steady_from({0, 10, 20}, {{0, 10, 20}, {1, 1, 1}}, 1) == 0);  // at the limit
    CHECK_FALSE(steady_from({0, 10}, {{0, -20}, {-2, -2}}, 1));
}

TEST_CASE("the time to a share of the change is that of the last leave")
{
    const std::vector<double> time{0, 1, 2, 3, 4};
    CHECK(time_to_share(time, std::vector<double>{0, 9.6, 8, 9.6, 10}, 0.95) == 3);  // leaves again at 2
    CHECK(time_to_share(time, std::vector<double>{0, 5, 5.1, 9, 10}, 0.5) == 1);
    CHECK(time_to_share(time, std::vector<double>{10, 10, 10, 10, 10}, 0.95) == 0);
    CHECK(time_to_share(time, std::vector<double>{20, 20, 24, 25, 25}, 0.95) == 3);  // starts warm, changes by 5
}
