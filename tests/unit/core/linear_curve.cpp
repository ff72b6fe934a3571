#include "deadpoint/core/linear_curve.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

using deadpoint::LinearCurve;

TEST_CASE("a linear curve: values, slopes and areas under a trapezoid of known corners")
{
    const LinearCurve curve({1, 3, 4}, {2, 6, 5});
    CHECK(curve.value(0) == 2);
    CHECK(curve.value(2) == near(4, 1e-5));
    CHECK(curve.value(3) == near(6, 1e-5));
    CHECK(curve.value(3.5) == near(5.5, 1e-5));
    CHECK(curve.value(9) == 5);
    CHECK(curve.slope(0.5) == 0);
    CHECK(curve.slope(2) == near(2, 1e-5));
    CHECK(curve.slope(3.2) == near(-1, 1e-5));
    CHECK(curve.slope(4) == 0);
    // From x = 1: two units at -1, the half strip 2..4 of width 1, the whole first strip, both strips, and 5 per unit
    // on.
    CHECK(curve.integral(0) == near(-2, 1e-5));
    CHECK(curve.integral(2) == near(3, 1e-5));
    CHECK(curve.integral(3) == near(8, 1e-5));
    CHECK(curve.integral(4) == near(13.5, 1e-5));
    CHECK(curve.integral(6) == near(23.5, 1e-5));
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
    CHECK(curve.integral(310) == near(70, 1e-5));
    CHECK(curve.integral(290) == near(-70, 1e-5));
    CHECK(curve.slope(300) == 0);
}

TEST_CASE("what is no curve is refused")
{
    CHECK_THROWS_AS(LinearCurve({}, {}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({1, 2}, {1}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({2, 1}, {1, 1}), deadpoint::DomainError);
    CHECK_THROWS_AS(LinearCurve({1, 2}, {1, std::numeric_limits<double>::quiet_NaN()}), deadpoint::DomainError);
}
