#include "deadpoint/surroundings/convection.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/air.hpp"
#include "deadpoint/surroundings/film.hpp"
#include "deadpoint/surroundings/radiation.hpp"
#include "near.hpp"
#include "oracle.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::surroundings;
using namespace surroundings_test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rpm = pi / 30;

}  // namespace

TEST_CASE("natural convection: reference values by number and by film law")
{
    for (const auto& row : oracle("natural")) {
        const double dT = number(row, "dT");
        const double L = number(row, "L");
        const double ambient = number(row, "Tinf") + zero_celsius;
        const AirProperties air = air_properties(ambient + dT / 2);
        const double Ra = rayleigh(dT, L, air);
        const auto film = [&](AirSurface surface) {
            surface.natural_length = L;
            return film_law(surface, ambient)(ambient + dT).value;
        };
        const auto matches = [&](const Nusselt& nusselt, const char* key, const AirSurface& surface) {
            INFO(key, ", L ", L, ", dT ", dT);
            CHECK(nusselt.value * air.conductivity / L == near(number(row, key), printed));
            CHECK(nusselt.in_range);
            CHECK(film(surface) == near(number(row, key), printed));
        };
        if (row.contains("vertical_cc")) {
            matches(nusselt_vertical(Ra, air.prandtl), "vertical_cc", {});
            matches(nusselt_vertical(Ra, air.prandtl, VerticalLaw::pair), "vertical_table6",
                    {.vertical_law = VerticalLaw::pair});
        } else {
            matches(nusselt_facing_up(Ra), "up", {.natural = NaturalFlow::facing_up});
            matches(nusselt_facing_down(Ra), "down", {.natural = NaturalFlow::facing_down});
            matches(nusselt_facing_down(Ra, DownLaw::fifth), "down52",
                    {.natural = NaturalFlow::facing_down, .down_law = DownLaw::fifth});
            matches(nusselt_horizontal_cylinder(Ra, air.prandtl), "hcyl",
                    {.natural = NaturalFlow::horizontal_cylinder});
        }
    }
}

TEST_CASE("natural convection and radiation: table of a warm wall in a room of 20 C")
{
    struct Row {
        double dT, wall[4], up[2], down[2], radiation;
    };
    const Row rows[] = {{5, {2.76, 2.58, 2.45, 2.40}, {3.73, 3.09}, {1.86, 1.42}, 5.28},
                        {10, {3.38, 3.18, 3.04, 2.98}, {4.42, 3.88}, {2.21, 1.68}, 5.41},
                        {15, {3.80, 3.58, 3.44, 3.37}, {4.89, 4.41}, {2.44, 1.86}, 5.55},
                        {20, {4.12, 3.90, 3.74, 3.68}, {5.24, 4.83}, {2.62, 1.99}, 5.69}};
    const double ambient = 293.15;
    const double half_digit = 0.00501;  // two digits after the point are printed
    for (const auto& row : rows) {
        INFO("dT ", row.dT);
        const auto film = [&](NaturalFlow flow, double length) {
            return film_law({.natural = flow, .natural_length = length}, ambient)(ambient + row.dT).value;
        };
        const double heights[] = {0.5, 1, 2, 3};
        for (int i = 0; i < 4; ++i)
            CHECK(std::abs(film(NaturalFlow::vertical, heights[i]) - row.wall[i]) < half_digit);
        const double lengths[] = {0.1, 0.3};
        for (int i = 0; i < 2; ++i) {
            CHECK(std::abs(film(NaturalFlow::facing_up, lengths[i]) - row.up[i]) < half_digit);
            CHECK(std::abs(film(NaturalFlow::facing_down, lengths[i]) - row.down[i]) < half_digit);
        }
        CHECK(std::abs(radiation_coefficient(0.9, ambient + row.dT, ambient).value - row.radiation) < half_digit);
    }
    // The reference of the coefficients of radiation was computed with 5.670374e-8.
    for (const auto& row : oracle("radiation"))
        CHECK(radiation_coefficient(number(row, "eps"), ambient + number(row, "dT"), ambient).value * 5.670374e-8 /
                  stefan_boltzmann ==
              near(number(row, "h"), printed));
}

TEST_CASE("rotating surfaces: reference values")
{
    for (const auto& row : oracle("rotating")) {
        const double omega = number(row, "n_rpm") * rpm;
        const double d = number(row, "d");
        INFO("n ", number(row, "n_rpm"), " d ", d);
        const AirProperties air = air_properties(number(row, "T") + zero_celsius);
        const double Re = rotating_reynolds(omega, d, air.kinematic_viscosity);
        const double to_film = air.conductivity / d;
        const auto nusselt = [&](RotatingLaw law) {
            return nusselt_rotating_cylinder(law, Re, air.prandtl).value * to_film;
        };
        CHECK(nusselt(RotatingLaw::becker) == near(number(row, "becker"), printed));
        CHECK(nusselt(RotatingLaw::etemad) == near(number(row, "etemad"), printed));
        CHECK(nusselt(RotatingLaw::dropkin_carmi) == near(number(row, "dropkin"), printed));
        CHECK(nusselt_rotating_disk(Re / 2).value * 2 * to_film == near(number(row, "disk"), printed));

        // By film law: surface and ambient around the film temperature; natural convection off.
        const double film = air.temperature;
        AirSurface surface{
            .natural = NaturalFlow::none, .forced = ForcedFlow::rotating_cylinder, .forced_length = d, .speed = -omega};
        CHECK(film_law(surface, film - 5)(film + 5).value == near(number(row, "becker"), printed));
        surface.forced = ForcedFlow::rotating_disk;
        CHECK(film_law(surface, film - 5)(film + 5).value == near(number(row, "disk"), printed));
        surface.forced = ForcedFlow::rotating_cylinder;
        surface.rotating_law = RotatingLaw::kays_bjorklund;
        CHECK(film_law(surface, 293.15)(308.15).value == near(number(row, "kays_bjorklund_dT15"), printed));
    }
    CHECK_FALSE(nusselt_rotating_cylinder(RotatingLaw::becker, 100, 0.7).in_range);
    CHECK_FALSE(nusselt_rotating_cylinder(RotatingLaw::etemad, 7e3, 0.7).in_range);
    CHECK(nusselt_rotating_cylinder(RotatingLaw::kays_bjorklund, 0, 0.7, 1e6).value ==
          near(0.135 * std::cbrt(0.7e6), 1e-13));
}

TEST_CASE("scaling with speed and size")
{
    const auto film = [](ForcedFlow flow, double length, double speed) {
        return film_law({.natural = NaturalFlow::none, .forced = flow, .forced_length = length, .speed = speed},
                        293.15)(303.15)
            .value;
    };
    const auto cylinder = ForcedFlow::rotating_cylinder;
    CHECK(film(cylinder, 0.2, 40) / film(cylinder, 0.2, 20) == near(std::pow(2, 2.0 / 3), 1e-13));
    CHECK(film(cylinder, 0.4, 20) / film(cylinder, 0.2, 20) == near(std::pow(2, 1.0 / 3), 1e-13));
    const auto disk = ForcedFlow::rotating_disk;  // laminar: independent of the radius
    CHECK(film(disk, 0.4, 20) / film(disk, 0.4, 10) == near(std::sqrt(2), 1e-13));
    CHECK(film(disk, 0.2, 20) == near(film(disk, 0.4, 20), 1e-13));
    const auto plate = ForcedFlow::moving_plate;
    CHECK(film(plate, 0.5, 2) / film(plate, 0.5, 1) == near(std::sqrt(2), 1e-13));
    CHECK(film(plate, 0.5, 0) == 0);
    // Hand number: a slide 0.5 m long at 1 m/s, film at 300 K: Re 31492, Nu 0.664 * 177.46 * 0.8914 = 105.0.
    CHECK(nusselt_moving_plate(31492, 0.7083).value == near(105.04, 1e-3));
    // Printed laws on both sides of the transition.
    CHECK(nusselt_moving_plate(1e6, 0.7).value == near((0.037 * std::pow(1e6, 0.8) - 871) * std::cbrt(0.7), 1e-13));
    CHECK(nusselt_rotating_disk(1e6).value == near(0.015 * std::pow(1e6, 0.8) - 100 * std::sqrt(0.24), 1e-13));
}

TEST_CASE("every transition between two laws is continuous in value and slope, and increasing")
{
    struct Case {
        const char* name;
        double begin, end;
        double (*law)(double);
    };
    const Case cases[] = {
        {"vertical", 1e9, 1.5e9, [](double x) { return nusselt_vertical(x, 0.7, VerticalLaw::pair).value; }},
        {"up", 1e7, 1.3e7, [](double x) { return nusselt_facing_up(x).value; }},
        {"disk", 2.4e5, 3e5, [](double x) { return nusselt_rotating_disk(x).value; }},
        {"plate", 5e5, 6e5, [](double x) { return nusselt_moving_plate(x, 0.7).value; }}};
    for (const auto& c : cases) {
        INFO(c.name);
        for (const double x : {c.begin, c.end}) {
            const double step = 1e-5 * x;
            const double below = c.law(x) - c.law(x - step);
            const double above = c.law(x + step) - c.law(x);
            CHECK(above / below == near(1, 0.01));
        }
        for (double x = 0.8 * c.begin; x < 1.2 * c.end; x *= 1.003)
            CHECK(c.law(x * 1.003) > c.law(x));
    }
}

TEST_CASE("mixed convection")
{
    for (const auto& row : oracle("mixed"))
        CHECK(mixed_convection(number(row, "hf"), number(row, "hn"), number(row, "n"), row["assist"].get<bool>()) ==
              near(number(row, "h"), printed));
    CHECK(mixed_convection(7, 0, 3) == 7);
    CHECK(mixed_convection(0, 7, 4) == 7);
    CHECK(mixed_convection(5, 5, 3, false) == 0);
    CHECK(mixed_convection(1e200, 1e200, 4) == near(std::pow(2, 0.25) * 1e200, 1e-14));
    CHECK_THROWS_AS((void)mixed_convection(-1, 1, 3), DomainError);
    CHECK_THROWS_AS((void)mixed_convection(1, 1, 0), DomainError);
}

TEST_CASE("Nusselt numbers: ranges are flagged, nonsense refused")
{
    CHECK_FALSE(nusselt_vertical(1e13, 0.7).in_range);
    CHECK_FALSE(nusselt_vertical(1e3, 0.7, VerticalLaw::pair).in_range);
    CHECK_FALSE(nusselt_facing_up(1e12).in_range);
    CHECK_FALSE(nusselt_facing_down(1e4).in_range);
    CHECK(nusselt_facing_down(1e4, DownLaw::fifth).in_range);
    CHECK_FALSE(nusselt_rotating_disk(1e7).in_range);
    CHECK(nusselt_rotating_disk(0).value == 0);
    CHECK_THROWS_AS((void)nusselt_vertical(-1, 0.7), DomainError);
    CHECK_THROWS_AS((void)nusselt_vertical(1e6, 0), DomainError);
    CHECK_THROWS_AS((void)nusselt_facing_up(std::nan("")), DomainError);
    CHECK_THROWS_AS((void)nusselt_moving_plate(-5, 0.7), DomainError);
    CHECK_THROWS_AS((void)rotating_reynolds(10, -0.1, 1.6e-5), DomainError);
}
