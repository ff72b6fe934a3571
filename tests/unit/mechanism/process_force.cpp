#include "deadpoint/mechanism/process_force.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::mechanism;
using doctest::Contains;

namespace {
constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
}  // namespace

TEST_CASE("elastic contact pushes only below its first contact")
{
    const auto law = elastic_contact(1e9, 0.3e-3);
    CHECK(law(0, 0, 0) == near(3e5, 1e-5));
    CHECK(law(0, 0.1e-3, 0) == near(2e5, 1e-5));
    CHECK(law(0, 0.3e-3, 0) == 0);
    CHECK(law(0, 0.02, 0) == 0);
    CHECK(elastic_contact_of_peak(2e9, 3e5)(0, 0.05e-3, 0) == near(2e5, 1e-5));
    CHECK(elastic_contact_of_peak(2e9, 0)(0, 0, 0) == 0);
    CHECK(no_force()(1, 2, 3) == 0);
}

TEST_CASE("half-sine over its window, also across top dead point")
{
    const auto law = half_sine(1e5, {-30 * degree, 30 * degree});
    CHECK(law(0, 0, 0) == near(1e5, 1e-5));
    CHECK(law(-15 * degree, 0, 0) == near(1e5 * std::sqrt(0.5), 1e-5));
    CHECK(law(31 * degree, 0, 0) == 0);
    CHECK(law(-30 * degree, 0, 0) == 0);
    const auto across = half_sine(1e5, {170 * degree, 200 * degree});
    CHECK(across(-175 * degree, 0, 0) == near(1e5, 1e-5));
    CHECK(across(0, 0, 0) == 0);
}

TEST_CASE("rectangle: half at the edges keeps the impulse of evenly spaced positions")
{
    const auto impulse = [](const ProcessForceLaw& law) {
        double sum = 0;
        for (int i = -180; i < 180; ++i)
            sum += law(i * degree, 0, 0);
        return sum;
    };
    const AngleWindow window{-15 * degree, 15 * degree};
    CHECK(impulse(rectangle(1e5, window)) == near(30 * 1e5, 1e-5));
    CHECK(impulse(rectangle(1e5, window, 1)) == near(31 * 1e5, 1e-5));
    CHECK(rectangle(1e5, window)(-15 * degree, 0, 0) == 5e4);
    CHECK(rectangle(1e5, window)(15 * degree, 0, 0) == 5e4);
    CHECK(rectangle(1e5, window, 1)(15 * degree, 0, 0) == 1e5);
    CHECK(impulse(rectangle(1e5, {165 * degree, 195 * degree})) == near(30 * 1e5, 1e-5));
    CHECK(impulse(rectangle(1e5, {0, 2 * pi})) == near(360 * 1e5, 1e-5));
}

TEST_CASE("force over the angle is closed over the turn")
{
    const auto law = force_over_angle({-90 * degree, 0, 90 * degree}, {1000, 3000, 2000});
    CHECK(law(-45 * degree, 0, 0) == near(2000, 1e-5));
    CHECK(law(90 * degree, 0, 0) == near(2000, 1e-5));
    CHECK(law(180 * degree, 0, 0) == near(1500, 1e-5));
    CHECK(law(-180 * degree, 0, 0) == near(1500, 1e-5));
    CHECK(law(-90.0001 * degree, 0, 0) == near(1000, 1e-5));
    CHECK(force_over_angle({0.4}, {700})(-2, 0, 0) == 700);
}

TEST_CASE("force over the height acts on the way down, or both ways")
{
    const auto down = force_over_height({0, 0.002, 0.005}, {4e5, 1e5, 0});
    CHECK(down(-0.2, 0.001, -0.1) == near(2.5e5, 1e-5));
    CHECK(down(0.2, 0.001, 0.1) == 0);
    CHECK(down(0, 0, 1e-17) == near(2e5, 1e-5));
    CHECK(down(0, 0, -1e-17) == near(2e5, 1e-5));
    CHECK(down(-1, 0.0051, -0.1) == 0);
    const auto both = force_over_height({0, 0.002, 0.005}, {4e5, 1e5, 5e4}, Strokes::both);
    CHECK(both(0.2, 0.001, 0.1) == near(2.5e5, 1e-5));
    CHECK(both(0, 0, 0) == near(4e5, 1e-5));
    CHECK(both(0, -1e-6, 0) == near(4e5, 1e-5));
    CHECK(both(0, 0.0050001, 0) == 0);
}

TEST_CASE("laws without meaning are refused")
{
    const double inf = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(elastic_contact(0, 1e-3), Contains("the stiffness is 0"), InputError);
    CHECK_THROWS_WITH_AS(elastic_contact(1e9, -1e-3), Contains("the interference is -0.001"), InputError);
    CHECK_THROWS_WITH_AS(elastic_contact_of_peak(0, 1), Contains("the stiffness is 0"), InputError);
    CHECK_THROWS_WITH_AS(elastic_contact_of_peak(1e9, -1), Contains("the peak is -1"), InputError);
    CHECK_THROWS_WITH_AS(half_sine(1, {1, 1}), Contains("the end of the window in degrees is 57.2958"), InputError);
    CHECK_THROWS_WITH_AS(half_sine(1, {0, 7}), Contains("the length of the window in degrees is 401.07"), InputError);
    CHECK_THROWS_WITH_AS(half_sine(inf, {0, 1}), Contains("the peak is inf"), InputError);
    CHECK_THROWS_WITH_AS(rectangle(1, {inf, 1}), Contains("the start of the window in degrees is inf"), InputError);
    CHECK_THROWS_WITH_AS(rectangle(1, {0, 1}, 2), Contains("the share at the edges is 2"), InputError);
    CHECK_THROWS_WITH_AS(force_over_angle({}, {}), Contains("0 angles but 0 forces"), InputError);
    CHECK_THROWS_WITH_AS(force_over_angle({0, 1}, {1}), Contains("2 angles but 1 forces"), InputError);
    CHECK_THROWS_WITH_AS(force_over_angle({0, 7}, {1, 2}), Contains("the angles span 7 rad"), InputError);
    CHECK_THROWS_WITH_AS(force_over_height({0, 0}, {1, 2}), Contains("point 2 of the table"), InputError);
    CHECK_THROWS_WITH_AS(force_over_height({0, 1}, {1, inf}), Contains("point 2 of the table"), InputError);
}
