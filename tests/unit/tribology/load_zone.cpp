#include "deadpoint/tribology/friction/load_zone.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double ball = 1.5;
constexpr double line = 1.1;  // of the published table; 10/9 is usual today

RollingRow row_at(double degrees) { return {20, degrees * pi / 180, 8e9, ball}; }

/// Sum over so many elements that their places do not matter.
double by_summation(const RowApproach& approach, double exponent, int harmonic)
{
    constexpr int count = 200000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double psi = 2 * pi * (i + 0.5) / count;
        const double value = approach.base + approach.radial * std::cos(psi);
        if (value > 0)
            sum += std::pow(value, exponent) * (harmonic == 1 ? std::cos(psi) : 1) / count;
    }
    return sum;
}

}  // namespace

TEST_CASE("load zone: Sjoevall's integrals as published (Harris), and Stribeck's constant")
{
    struct Row {
        double zone, point, line_contact;
    };
    const Row radial[] = {{0.1, 0.1156, 0.1268}, {0.2, 0.1590, 0.1737},  {0.3, 0.1892, 0.2055},
                          {0.4, 0.2117, 0.2286}, {0.5, 0.2288, 0.2453},  {0.6, 0.2416, 0.2568},
                          {0.7, 0.2505, 0.2636}, {0.8, 0.2559, 0.2658},  {0.9, 0.2576, 0.2628},
                          {1.0, 0.2546, 0.2523}, {1.25, 0.2289, 0.2078}, {5.0 / 3, 0.1871, 0.1589},
                          {2.5, 0.1339, 0.1075}, {5.0, 0.0711, 0.0544}};
    for (const Row& row : radial) {
        CAPTURE(row.zone);
        // Printed to four digits, from older quadrature.
        CHECK(std::abs(radial_integral(row.zone, ball) - row.point) < 2e-4);
        CHECK(std::abs(radial_integral(row.zone, line) - row.line_contact) < 2e-4);
    }
    CHECK(1 / radial_integral(0.5, ball) == near(4.37, 0.001));
    CHECK(1 / radial_integral(0.5, line) == near(4.08, 0.001));
    // A zone of 0.5 has closed forms: 1/(2 pi) B-functions of cos^n over half the ring.
    const auto cosine_power = [](double q) {
        return std::tgamma((q + 1) / 2) / (2 * std::sqrt(pi) * std::tgamma(q / 2 + 1));
    };
    CHECK(radial_integral(0.5, ball) == near(cosine_power(2.5), 1e-10));
    CHECK(axial_integral(0.5, ball) == near(cosine_power(1.5), 1e-10));
}

TEST_CASE("load zone: quadrature against summation, and as the zone closes or opens")
{
    for (const double zone : {0.01, 0.3, 0.5, 0.99, 1.0, 1.01, 1.5, 20.0})
        for (const double exponent : {line, ball, 2.0}) {
            const RowApproach approach{1 - 1 / (2 * zone), 1 / (2 * zone)};
            // Both rules see the kink of the zone's end; the summation's error is a few 1e-9.
            CHECK(std::abs(radial_integral(zone, exponent) - by_summation(approach, exponent, 1)) < 2e-8);
            CHECK(std::abs(axial_integral(zone, exponent) - by_summation(approach, exponent, 0)) < 2e-8);
        }
    CHECK(mean_approach({-2, 1}, ball, 0) == 0.0);
    CHECK(mean_approach({4, 0}, ball, 0) == near(8, 1e-13));
}

TEST_CASE("load zone: a radial force without clearance gives Stribeck's largest load; preload and clearance change it")
{
    RollingRow row = row_at(0);
    const double force = 18e3;
    const RowApproach plain = spread_radial(row, force, 0);
    const double stribeck = force / (row.elements * radial_integral(0.5, ball));
    CHECK(largest_load(row, plain) == near(stribeck, 1e-11));
    CHECK(stribeck == near(4.37 * force / 20, 1e-3));

    const RowApproach loose = spread_radial(row, force, -20e-6);
    CHECK(radial_force(row, loose) == near(force, 1e-11));
    CHECK(largest_load(row, loose) > stribeck);
    const RowApproach tight = spread_radial(row, force, 10e-6);
    CHECK(radial_force(row, tight) == near(force, 1e-11));
    CHECK(tight.radial < plain.radial);  // a preloaded bearing is stiffer
    const RowApproach idle = spread_radial(row, 0, 10e-6);
    CHECK(largest_load(row, idle) == near(8e9 * std::pow(10e-6, 1.5), 1e-13));
    CHECK(radial_force(row, spread_radial(row, 1e-3, 10e-6)) == near(1e-3, 1e-6));
}

TEST_CASE("load zone: the integral is the mean over the positions of single balls")
{
    const RollingRow row = row_at(0);
    const RowApproach approach = spread_radial(row, 18e3, 0);
    double mean = 0;
    constexpr int positions = 500;
    for (int p = 0; p < positions; ++p)
        for (int i = 0; i < row.elements; ++i)
            mean +=
                std::pow(element_load(row, approach, 2 * pi * (i + (p + 0.5) / positions) / row.elements), 4.0 / 3) /
                positions;
    CHECK(summed_load(row, approach, 4.0 / 3) == near(mean, 1e-7));
}

TEST_CASE("load zone: a single row at a contact angle balances both forces")
{
    const RollingRow row = row_at(25);
    const double tangent = std::tan(row.contact_angle);
    for (const double ratio : {1.3, 2.0, 10.0, 1000.0}) {
        const RowApproach approach = spread_single(row, 5e3, ratio * 5e3 * tangent);
        CHECK(radial_force(row, approach) == near(5e3, 1e-10));
        CHECK(axial_force(row, approach) == near(ratio * 5e3 * tangent, 1e-10));
    }
    // Below the load that the half-ring zone induces, the bearing opposite gives the rest.
    const RowApproach induced = spread_single(row, 5e3, 0);
    CHECK(axial_force(row, induced) == near(1.216 * 5e3 * tangent, 1e-3));
    const RowApproach axial = spread_single(row, 0, 3e3);
    CHECK(axial.radial == 0.0);
    CHECK(largest_load(row, axial) == near(3e3 / (20 * std::sin(row.contact_angle)), 1e-12));
    CHECK(spread_single(row, 0, 0).base == 0.0);
}

TEST_CASE("load zone: a pair shares the forces and stays in balance")
{
    const RollingRow row = row_at(15);
    for (const double base : {-5e-6, 0.0, 8e-6})
        for (const double radial : {0.0, 2e3, 18e3})
            for (const double axial : {-4e3, 0.0, 500.0, 9e3}) {
                CAPTURE(base);
                CAPTURE(radial);
                CAPTURE(axial);
                const auto rows = spread_pair(row, radial, axial, base);
                // 1e-6 N where the force sought is zero, else to the tolerance of the nested solution.
                CHECK(std::abs(radial_force(row, rows[0]) + radial_force(row, rows[1]) - radial) <
                      1e-6 + 1e-8 * radial);
                CHECK(std::abs(axial_force(row, rows[0]) - axial_force(row, rows[1]) - axial) <
                      1e-6 + 1e-7 * std::abs(axial));
                CHECK(rows[0].base + rows[1].base == near(2 * base, 1e-5));
            }
}

TEST_CASE("load zones that mean nothing are refused")
{
    RollingRow row = row_at(0);
    CHECK_THROWS_AS(spread_radial(row, -1, 0), InputError);
    CHECK_THROWS_AS(spread_single(row, 1, 1), InputError);
    CHECK_THROWS_AS(spread_pair(row, 1, 1, 0), InputError);
    for (const double angle : {-0.1, 1.58, 3.0}) {  // below 0, above pi/2
        RollingRow turned = row;
        turned.contact_angle = angle;
        CHECK_THROWS_WITH_AS(spread_radial(turned, 1, 0), doctest::Contains("is outside 0 .. pi/2"), InputError);
    }
    CHECK_THROWS_AS(radial_integral(0, ball), InputError);
    row.elements = 0;
    CHECK_THROWS_AS(spread_radial(row, 1, 0), InputError);
}
