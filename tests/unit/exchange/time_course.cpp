/// Requirement: a course over time tells its value, its exact mean, its points, and what a step does not see of it.
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "near.hpp"

#include <cmath>
#include <vector>

using deadpoint::TimeCourse;

namespace {

constexpr double exact = 1e-13;  // sums of a few numbers

const TimeCourse pulse{{0, 100, 101, 200, 201}, {0, 0, 500, 500, 0}};

}  // namespace

TEST_CASE("a table is linear between its points and holds its ends")
{
    CHECK(pulse(-5) == 0);
    CHECK(pulse(100.5) == near(250, exact));
    CHECK(pulse(150) == 500);
    CHECK(pulse(1e6) == 0);
    CHECK(TimeCourse::constant(293)(77) == 293);
    CHECK(TimeCourse::constant(293).is_constant());
    CHECK_FALSE(TimeCourse());
}

TEST_CASE("the mean of a table is exact wherever the interval begins and ends")
{
    CHECK(pulse.mean(0, 1000) == near(500 * 100 / 1000.0, exact));
    CHECK(pulse.mean(100.5, 150) == near((0.5 * 375 + 49 * 500) / 49.5, exact));
    CHECK(pulse.mean(120, 180) == near(500, exact));
    CHECK(pulse.mean(-100, 0) == 0);
    CHECK(pulse.times(0.5).mean(0, 1000) == near(25, exact));
}

TEST_CASE("the mean of a function is that of its pieces, and of a sum that of both")
{
    const TimeCourse wave([](double t) { return std::sin(t / 1000); }, 100);
    const double of_wave = 1000 * (std::cos(0.0) - std::cos(2.0)) / 2000;
    CHECK(wave.mean(0, 2000) == near(of_wave, 1e-10));  // Gauss, 3 points on pieces of 0.1 rad: 5e-12
    CHECK(pulse.plus([](double t) { return std::sin(t / 1000); }, 100).mean(0, 2000) == near(25 + of_wave, 1e-10));
}

TEST_CASE("two equal times are a jump: a ramp of a millisecond that keeps the integral")
{
    const TimeCourse step({0, 600, 600, 1200}, {10, 10, 30, 30});
    CHECK(step(599.9994) == 10);
    CHECK(step(600) == near(20, 1e-9));  // the ramp's times round to 1e-13 of 600 s
    CHECK(step(600.0006) == 30);
    CHECK(step.mean(0, 1200) == near(20, 1e-12));
    CHECK(step.points(0, 1200).size() == 2);
    CHECK_THROWS_AS(TimeCourse({0, 1, 1, 1}, {1, 2, 3, 4}), deadpoint::DomainError);
    CHECK_THROWS_AS(TimeCourse({0, 2, 1}, {1, 2, 3}), deadpoint::DomainError);
    CHECK_THROWS_AS(TimeCourse({0, 2}, {1}), deadpoint::DomainError);
}

TEST_CASE("points between two times are without these; a function is looked at every width")
{
    CHECK(pulse.points(100, 201) == std::vector<double>{101, 200});
    CHECK(pulse.points(250, 300).empty());
    const TimeCourse wave([](double t) { return t; }, 10);
    CHECK(wave.points(0, 100).empty());
    CHECK(wave.looked_at(5, 30) == std::vector<double>{10, 20});
    CHECK(wave.looked_at(10, 15).empty());
}

TEST_CASE("a step sees a line and a parabola, and not a pulse in its middle")
{
    CHECK(pulse.unseen(100, 101).integral == 0);
    CHECK(pulse.unseen(120, 180).integral == 0);
    const TimeCourse parabola([](double t) { return 3 + 2 * t - 5 * t * t; }, 0.1);
    CHECK(parabola.unseen(0, 10).integral == 0);
    CHECK(parabola.unseen(0, 10).value == 0);
    // A pulse of 500 for 1 s amid 100 s, against the parabola 6 bulge s (1 - s) with the same integral: before and
    // behind the pulse half of its integral is missing, but for a third of a percent that the parabola has within it.
    const TimeCourse narrow({49, 49.5, 50, 50.5, 51}, {0, 500, 500, 500, 0});
    const auto [integral, value] = narrow.unseen(0, 100);
    CHECK(integral == near(375, 0.05));
    CHECK(value == near(500, 0.03));
}
