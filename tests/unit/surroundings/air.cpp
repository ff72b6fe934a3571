#include "deadpoint/surroundings/air.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/ambient.hpp"
#include "near.hpp"
#include "oracle.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::surroundings;
using namespace surroundings_test;

TEST_CASE("air: reference values")
{
    for (const auto& row : oracle("air")) {
        const AirProperties air = air_properties(number(row, "T") + zero_celsius);
        CHECK(air.conductivity == near(number(row, "k"), printed));
        CHECK(air.viscosity == near(number(row, "mu"), printed));
        CHECK(air.kinematic_viscosity == near(number(row, "nu"), printed));
        CHECK(air.diffusivity == near(number(row, "alpha"), printed));
        CHECK(air.prandtl == near(number(row, "Pr"), printed));
        CHECK(air.expansion == near(number(row, "beta"), printed));
        CHECK(air.in_range);
    }
}

TEST_CASE("air: standard dry-air table")
{
    // Kinematic viscosity [1e-6 m2/s] at 20..70 C, printed to 0.01: 15.06, 16.00, 16.96, 17.95, 18.97, 20.02.
    const double nu[] = {15.06, 16.00, 16.96, 17.95, 18.97, 20.02};
    // Dynamic viscosity [1e-6 Pa s] and conductivity [1e-2 W/m/K] of the same table.
    const double mu[] = {18.1, 18.6, 19.1, 19.6, 20.1, 20.6};
    const double k[] = {2.59, 2.67, 2.76, 2.83, 2.90, 2.96};
    // Thermal diffusivity [1e-6 m2/s] at 50, 60, 70 C.
    const double alpha[] = {25.7, 27.2, 28.6};
    for (int i = 0; i < 6; ++i) {
        const AirProperties air = air_properties(zero_celsius + 20 + 10 * i);
        INFO("T ", 20 + 10 * i, " C");
        CHECK(air.kinematic_viscosity == near(nu[i] * 1e-6, 0.01));
        CHECK(air.viscosity == near(mu[i] * 1e-6, 0.01));
        CHECK(air.conductivity == near(k[i] * 1e-2, 0.012));
        if (i >= 3)
            CHECK(air.diffusivity == near(alpha[i - 3] * 1e-6, 0.01));
    }
    // Incropera et al., Table A.4, at the ends of the tested range: nu 11.44e-6 and 26.41e-6, k 22.3e-3 and 33.8e-3.
    CHECK(air_properties(250).kinematic_viscosity == near(11.44e-6, 0.02));
    CHECK(air_properties(400).kinematic_viscosity == near(26.41e-6, 0.02));
    CHECK(air_properties(250).conductivity == near(22.3e-3, 0.02));
    CHECK(air_properties(400).conductivity == near(33.8e-3, 0.02));
    CHECK(air_properties(300).heat_capacity == near(1007, 0.002));
}

TEST_CASE("air: flags and refusals; Grashof and Rayleigh numbers")
{
    CHECK_FALSE(air_properties(249).in_range);
    CHECK_FALSE(air_properties(401).in_range);
    CHECK_THROWS_AS((void)air_properties(100), DomainError);
    CHECK_THROWS_AS((void)air_properties(std::nan("")), DomainError);
    const AirProperties air = air_properties(300);
    const double nu = air.kinematic_viscosity;
    CHECK(grashof(-10, 0.5, air) == near(9.81 / 300 * 10 * 0.125 / (nu * nu), 1e-14));
    CHECK(rayleigh(10, 0.5, air) == near(grashof(10, 0.5, air) * air.prandtl, 1e-14));
    CHECK_THROWS_AS((void)grashof(10, 0, air), DomainError);
}

TEST_CASE("daily course: highest at its time, lowest half a day later")
{
    const DailyCourse course{.mean = 293.15, .amplitude = 4, .time_of_maximum = 15 * 3600};
    CHECK(daily_temperature(course, 15 * 3600) == near(297.15, 1e-15));
    CHECK(daily_temperature(course, 3 * 3600) == near(289.15, 1e-15));
    CHECK(daily_temperature(course, 9 * 3600) == near(293.15, 1e-14));
    CHECK(daily_temperature(course, 10 * day + 1234) == near(daily_temperature(course, 1234), 1e-13));
    CHECK(daily_temperature(course, 7001) < daily_temperature(course, 6999));  // before three it still cools
    CHECK(daily_temperature({.mean = 300}, 77) == 300);
    CHECK_THROWS_AS((void)daily_temperature({.mean = 293, .amplitude = -1}, 0), DomainError);
    CHECK_THROWS_AS((void)daily_temperature({.mean = 293, .amplitude = 1, .period = 0}, 0), DomainError);
    CHECK_THROWS_AS((void)daily_temperature(course, std::nan("")), DomainError);
}
