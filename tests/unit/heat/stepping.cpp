/// Requirement: the constants of TR-BDF2 make it second order and L-stable, its companion is of third order, and step
/// sizes move by powers of two without slivers.
#include "deadpoint/heat/tr_bdf2.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <doctest/doctest.h>

using namespace deadpoint::heat;

namespace {

using Complex = std::complex<double>;

/// What a step makes of y' = z y with dt = 1.
Complex growth(Complex z)
{
    const Complex middle = (1.0 + diagonal * z) / (1.0 - diagonal * z);
    return (bdf_middle * middle - bdf_now) / (1.0 - diagonal * z);
}

/// The step's own quadrature of slopes f(t), t = 0..1.
template <class Slope>
double quadrature(const Slope& f)
{
    return outer_weight * (f(0) + f(gamma_stage)) + diagonal * f(1);
}

template <class Slope>
double companion(const Slope& f)
{
    return quadrature(f) + step_error(1, f(0), f(gamma_stage), f(1));
}

}  // namespace

TEST_CASE("both stages of a step solve with one matrix, and keep a constant")
{
    CHECK(diagonal == near(gamma_stage / 2, 1e-15));
    CHECK(bdf_middle - bdf_now == near(1, 1e-15));
    // The second stage's coefficient of BDF2 on the grid 0, gamma, 1: (1 - gamma) / (2 - gamma).
    CHECK(diagonal == near((1 - gamma_stage) / (2 - gamma_stage), 1e-14));
}

TEST_CASE("weights of a step integrate straight slopes exactly, and no parabola; those of the companion do")
{
    const auto power = [](int n) { return [n](double t) { return std::pow(t, n); }; };
    CHECK(quadrature(power(0)) == near(1, 1e-15));
    CHECK(quadrature(power(1)) == near(0.5, 1e-15));
    CHECK(std::abs(quadrature(power(2)) - 1 / 3.0) > 0.01);
    CHECK(companion(power(0)) == near(1, 1e-15));
    CHECK(companion(power(1)) == near(0.5, 1e-15));
    CHECK(companion(power(2)) == near(1 / 3.0, 1e-15));
    CHECK(std::abs(companion(power(3)) - 0.25) > 1e-4);  // third order, not fourth
}

TEST_CASE("the quadrature of a step is what its stages do with a load that has no temperature in it")
{
    const auto f = [](double t) { return 2 - 3 * t + 7 * t * t * t; };
    const double start = 11;
    const double middle = start + diagonal * (f(0) + f(gamma_stage));
    const double end = bdf_middle * middle - bdf_now * start + diagonal * f(1);
    CHECK(end - start == near(quadrature(f), 1e-14));
}

TEST_CASE("a step of y' = z y follows the exponential to third order a step and forgets what is stiff")
{
    double last = 0;
    for (const double z : {-0.04, -0.02, -0.01}) {
        const double error = std::abs(growth(z) - std::exp(z));
        if (last > 0)
            CHECK(last / error == near(8, 0.03));  // next term: a share of z
        last = error;
    }
    CHECK(std::abs(growth(-1e8)) < 1e-7);  // L-stable: falls as 1 / z
    for (int k = 0; k <= 200; ++k)         // A-stable: nowhere above 1 on the imaginary axis
        CHECK(std::abs(growth(Complex(0, 0.1 * k))) <= 1 + 1e-14);
}

TEST_CASE("the slope at a step's end is that of the parabola through its three values")
{
    const double dt = 3.7;
    const auto y = [](double t) { return 4 - 2 * t + 0.3 * t * t; };
    CHECK(end_slope(y(0), y(gamma_stage * dt), y(dt), dt) == near(-2 + 0.6 * dt, 1e-13));
    CHECK(std::abs(end_slope(5, 5, 5, dt)) < 1e-14);
}

TEST_CASE("the error of a step is that of its quadrature, in the unit of the temperature")
{
    const auto slope = [](double t) { return 1 + 2 * t + 5 * t * t; };
    const double dt = 0.25;
    const double error = step_error(dt, slope(0), slope(gamma_stage * dt), slope(dt));
    const double made = dt * (outer_weight * (slope(0) + slope(gamma_stage * dt)) + diagonal * slope(dt));
    const double exact = dt + dt * dt + 5 * dt * dt * dt / 3;
    CHECK(error == near(exact - made, 1e-11));
    CHECK(std::abs(step_error(dt, 2, 2 + 3 * gamma_stage * dt, 2 + 3 * dt)) < 1e-15);  // straight: none
}

TEST_CASE("steps reach a segment's end without a sliver, whatever is left")
{
    for (const double wanted : {0.5, 1.0, 7.0, 1800.0})
        for (double left = 0.01 * wanted; left < 6 * wanted; left *= 1.07) {
            double rest = left, shortest = 1e300;
            int steps = 0;
            while (rest > 1e-9 * left) {
                const double step = fit_step(wanted, rest);
                REQUIRE(step > 0);
                CHECK(step <= wanted * (1 + 1e-9));
                shortest = std::min(shortest, step);
                rest -= step;
                ++steps;
            }
            CHECK(shortest >= 0.5 * std::min(wanted, left) * (1 - 1e-9));  // the two last are equal halves
            CHECK(steps <= std::ceil(left / wanted) + 1);
        }
}

TEST_CASE("a step that is left by rounding only is taken whole")
{
    CHECK(fit_step(10, 10 * (1 + 1e-12)) == 10 * (1 + 1e-12));
    CHECK(fit_step(10, 20) == 10);
    CHECK(fit_step(10, 20 * (1 - 1e-12)) == 10 * (1 - 1e-12));
}

TEST_CASE("the next step is the largest power of two whose error, of third order, keeps to the tolerance")
{
    for (double error = 1e-9; error < 1e3; error *= 1.9) {
        const double factor = step_size_factor(error, 1e-3, -20, 20);
        CHECK(std::log2(factor) == near(std::round(std::log2(factor)), 1e-12));
        const double allowed = 0.9 * 0.9 * 0.9 * 1e-3;
        CHECK(error * factor * factor * factor <= allowed * (1 + 1e-12));
        CHECK(error * std::pow(2 * factor, 3) > allowed * (1 - 1e-12));  // twice as long would be too long
    }
}

TEST_CASE("the step's factor keeps between the powers it is given, for errors of any size")
{
    CHECK(step_size_factor(1e9, 1e-3, -2, 1) == 0.25);
    CHECK(step_size_factor(1e-30, 1e-3, -2, 3) == 8);
    CHECK(step_size_factor(1e-3, 1e-3, -20, -1) == 0.5);  // a rejected step gets shorter even at its tolerance
    CHECK(step_size_factor(1e300, 1e-3, -20, -1) == std::pow(2.0, -20));
}
