#include "deadpoint/core/linear_curve.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

using deadpoint::LinearCurve;
using doctest::Approx;

TEST_CASE("a linear curve: values, slopes and areas under a trapezoid of known corners")
{
    const LinearCurve curve({1, 3, 4}, {2, 6, 5});
    CHECK(curve.value(0) == 2);
    CHECK(curve.value(2) == Approx(4));
    CHECK(curve.value(3) == Approx(6));
    CHECK(curve.value(3.5) == Approx(5.5));
    CHECK(curve.value(9) == 5);
    CHECK(curve.slope(0.5) == 0);
    CHECK(curve.slope(2) == Approx(2));
    CHECK(curve.slope(3.2) == Approx(-1));
    CHECK(curve.slope(4) == 0);
    // From x = 1: two units at -1, the half strip 2..4 of width 1, the whole first strip, both strips, and 5 per unit
    // on.
    CHECK(curve.integral(0) == Approx(-2));
    CHECK(curve.integral(2) == Approx(3));
    CHECK(curve.integral(3) == Approx(8));
    CHECK(curve.integral(4) == Approx(13.5));
    CHECK(curve.integral(6) == Approx(23.5));
    CHECK(curve.outside(0.9));
    CHECK_FALSE(curve.outside(1));
    CHECK_FALSE(curve.outside(4));
    CHECK(curve.outside(4.1));
    CHECK(LinearCurve().empty());
}

TEST_CASE("a linear curve of one point is a constant")
{
    const LinearCurve curve({300}, {7});
    CHECK(curve.value(0) == 7);
    CHECK(curve.value(300) == 7);
    CHECK(curve.integral(310) == Approx(70));
    CHECK(curve.integral(290) == Approx(-70));
    CHECK(curve.slope(300) == 0);
}

TEST_CASE("what is no curve is refused")
{
    CHECK_THROWS_AS(LinearCurve({}, {}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({1, 2}, {1}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({2, 1}, {1, 1}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({1, 2}, {1, std::numeric_limits<double>::quiet_NaN()}), deadpoint::DomainError);
}
