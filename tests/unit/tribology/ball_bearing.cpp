#include "deadpoint/tribology/friction/ball_bearing.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/hertz.hpp"
#include "deadpoint/tribology/friction/load_zone.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// Deep groove bearing 209, worked through in Harris, Rolling Bearing Analysis: 9 balls of 12.7 mm on 65 mm.
BallBearing bearing_209()
{
    BallBearing bearing;
    bearing.balls = 9;
    bearing.ball_diameter = 12.7e-3;
    bearing.pitch_diameter = 65e-3;
    return bearing;
}

/// A pair of the size of a press's crankshaft bearing (170 x 260 mm).
BallBearing crank_pair()
{
    BallBearing bearing;
    bearing.balls = 19;
    bearing.rows = 2;
    bearing.ball_diameter = 28e-3;
    bearing.pitch_diameter = 215e-3;
    bearing.contact_angle = 25 * degree;
    return bearing;
}

}  // namespace

TEST_CASE("ball and groove: curvatures of bearing 209 as published")
{
    const ContactCurvature inner = inner_curvature(bearing_209());
    const ContactCurvature outer = outer_curvature(bearing_209());
    CHECK(inner.sum == near(202, 2e-3));  // 0.202 1/mm as printed
    CHECK(inner.difference == near(0.9399, 2e-4));
    CHECK(outer.sum == near(138, 2e-3));
    CHECK(outer.difference == near(0.9120, 2e-4));
}

TEST_CASE("ball and groove: the row's stiffness is that of both contacts, and follows the Hertz law")
{
    const BallBearing bearing = crank_pair();
    const RollingRow row = rolling_row(bearing);
    for (const double load : {10.0, 3000.0}) {
        const double approach = inner_contact(bearing, load).approach + outer_contact(bearing, load).approach;
        CHECK(element_load(row, {approach, 0}, 0) == near(load, 1e-12));
    }
    // Steel, in mm and N: a = 0.0236 a* (Q / sum)^(1/3) (Harris; E 207 GPa).
    BallBearing steel = bearing_209();
    steel.youngs_modulus = 207e9;
    const ContactCurvature curvature = inner_curvature(steel);
    const double published =
        0.0236 * contact_shape(curvature.difference).major * std::cbrt(1000 / (curvature.sum * 1e-3));
    CHECK(inner_contact(steel, 1000).major * 1e3 == near(published, 2e-3));
}

TEST_CASE("spin: the moment is the integral of friction over the ellipse")
{
    constexpr double friction = 0.06;
    constexpr double load = 2000;
    constexpr double a = 2e-3;
    constexpr double b = 0.3e-3;
    // Hertz pressure over ellipses of equal pressure: int sqrt(1 - s^2) s^2 ds = pi/16 times the mean distance around.
    constexpr int count = 100000;
    double around = 0;
    for (int i = 0; i < count; ++i) {
        const double theta = 2 * pi * (i + 0.5) / count;
        around += std::hypot(a * std::cos(theta), b * std::sin(theta)) * 2 * pi / count;
    }
    const double expected = friction * 1.5 * load / pi * around * pi / 16;
    CHECK(spin_moment(friction, load, a, b) == near(expected, 1e-10));
    CHECK(spin_moment(friction, load, a, a) == near(3 * pi * friction * load * a / 16, 1e-13));
    CHECK(spin_moment(friction, 0, 0, 0) == 0.0);
    CHECK_THROWS_AS(spin_moment(friction, load, b, a), InputError);
}

TEST_CASE("spin: equal loads give balls times moment times sin(angle); unequal ones are summed ball by ball")
{
    BallBearing bearing = crank_pair();
    bearing.rows = 1;
    const RollingRow row = rolling_row(bearing);
    const double preload = 5e3;
    const BallLoading loading{preload, 0};
    const double ball = preload / (bearing.balls * std::sin(bearing.contact_angle));
    const ContactEllipse ellipse = inner_contact(bearing, ball);
    const double moment = spin_moment(0.06, ball, ellipse.major, ellipse.minor);
    CHECK(spin_heat(bearing, 0.06, loading, steady_duty(0, 21)) ==
          near(spin_power(moment, bearing.balls, 21, bearing.contact_angle), 1e-10));

    const auto rows = spread_load(bearing, 8e3, loading);
    double sum = 0;
    constexpr int positions = 400;
    for (int i = 0; i < positions; ++i) {
        const double load = element_load(row, rows[0], 2 * pi * i / positions);
        const ContactEllipse at = inner_contact(bearing, load);
        sum += bearing.balls * spin_moment(0.06, load, at.major, at.minor) / positions;
    }
    CHECK(spin_torque(bearing, 0.06, rows) == near(sum * std::sin(bearing.contact_angle), 1e-6));
}

TEST_CASE("spin: heat grows as speed and, without preload, as load to 4/3; none without contact angle")
{
    const BallBearing bearing = crank_pair();
    const double base = spin_heat(bearing, 0.06, {}, steady_duty(9e3, 20));
    CHECK(base > 0);
    CHECK(spin_heat(bearing, 0.06, {}, steady_duty(9e3, 60)) == near(3 * base, 1e-12));
    CHECK(spin_heat(bearing, 0.06, {}, steady_duty(18e3, 20)) == near(std::pow(2, 4.0 / 3) * base, 1e-9));
    const BallLoading preloaded{0, preload_approach(bearing, 3e3)};
    CHECK(spin_heat(bearing, 0.06, preloaded, steady_duty(9e3, 20)) > base);
    CHECK(spin_heat(bearing, 0.06, preloaded, steady_duty(9e3, 0)) == 0.0);
    CHECK(spin_heat(bearing_209(), 0.06, {}, steady_duty(9e3, 20)) == 0.0);
}

TEST_CASE("preload: the approach of an axial force gives it back; a clearance opens the zone")
{
    const BallBearing bearing = crank_pair();
    const double approach = preload_approach(bearing, 3e3);
    const PreloadForces forces = preload_forces(bearing, approach);
    CHECK(forces.axial == near(3e3, 1e-12));
    CHECK(forces.radial == near(3e3 / std::tan(bearing.contact_angle), 1e-12));
    CHECK(forces.ball * bearing.balls * std::sin(bearing.contact_angle) == near(3e3, 1e-12));
    CHECK(clearance_approach(bearing, 40e-6) == near(-20e-6 * std::cos(25 * degree), 1e-14));
    CHECK(preload_forces(bearing, clearance_approach(bearing, 40e-6)).ball == 0.0);
    const BallBearing radial = bearing_209();
    CHECK(largest_load(rolling_row(radial), spread_load(radial, 1e3, {0, clearance_approach(radial, 30e-6)})[0]) >
          largest_load(rolling_row(radial), spread_load(radial, 1e3, {})[0]));
}

TEST_CASE("thermal preload: even warming does nothing, a warm inner ring tightens, meeting cones are neutral")
{
    constexpr double expansion = 12e-6;
    const BallBearing bearing = crank_pair();
    CHECK(std::abs(thermal_approach(bearing, {20, 20, 20}, expansion)) < 1e-18);
    CHECK(std::abs(thermal_approach(bearing, {20, 20, 20}, expansion, PairArrangement::back_to_back, 0.042)) < 1e-18);

    // Without contact angle: half the difference of the groove diameters' growth, balls halfway between.
    const BallBearing deep = bearing_209();
    CHECK(thermal_approach(deep, {10, 0, 5}, expansion) ==
          near(expansion * (10 * (65e-3 - 12.7e-3) / 2 + 5 * 12.7e-3), 1e-12));

    const double back = thermal_approach(bearing, {10, 0, 5}, expansion, PairArrangement::back_to_back, 0.042);
    const double single = thermal_approach(bearing, {10, 0, 5}, expansion);
    const double face = thermal_approach(bearing, {10, 0, 5}, expansion, PairArrangement::face_to_face, 0.042);
    CHECK(0 < back);
    CHECK(back < single);
    CHECK(single < face);
    CHECK(face - single == near(single - back, 1e-12));  // the pair turned around
    const double neutral = bearing.pitch_diameter / std::tan(bearing.contact_angle);
    CHECK(std::abs(thermal_approach(bearing, {10, 0, 5}, expansion, PairArrangement::back_to_back, neutral)) < 1e-18);

    // 10 K on a 170 x 260 pair without preload: a few kilonewton of axial force, rising with the difference.
    const double warm = preload_forces(bearing, face).axial;
    CHECK(warm > 500);
    const double warmer =
        preload_forces(bearing, thermal_approach(bearing, {20, 0, 10}, expansion, PairArrangement::face_to_face, 0.042))
            .axial;
    CHECK(warmer == near(std::pow(2, 1.5) * warm, 1e-12));
}

TEST_CASE("ball bearings that mean nothing are refused")
{
    BallBearing bearing = crank_pair();
    bearing.inner_osculation = 0.5;
    CHECK_THROWS_AS(rolling_row(bearing), InputError);
    bearing = crank_pair();
    bearing.balls = 60;
    CHECK_THROWS_WITH_AS(rolling_row(bearing), doctest::Contains("do not fit"), InputError);
    bearing = crank_pair();
    bearing.rows = 3;
    CHECK_THROWS_AS(rolling_row(bearing), InputError);
    CHECK_THROWS_AS(preload_approach(crank_pair(), -1), InputError);
    CHECK_THROWS_AS(preload_approach(bearing_209(), 100), InputError);
    CHECK_THROWS_AS(thermal_approach(crank_pair(), {}, 0), InputError);
}
