#include "deadpoint/core/error.hpp"
#include "deadpoint/surroundings/radiation.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::surroundings;

TEST_CASE("radiation coefficient: flux is the difference of fourth powers")
{
    const double flux = radiation_coefficient(0.8, 350, 290).value * (350 - 290);
    const double exact = 0.8 * stefan_boltzmann * (std::pow(350, 4) - std::pow(290, 4));
    CHECK(flux == doctest::Approx(exact).epsilon(1e-13));
    // Hand number: 4 * 0.9 * 5.670374419e-8 * 293.15^3 at equal temperatures.
    CHECK(radiation_coefficient(0.9, 293.15, 293.15).value == doctest::Approx(5.14267).epsilon(1e-5));
}

TEST_CASE("radiation coefficient: derivative agrees with central differences")
{
    const double h = 1e-3;
    const double slope =
        (radiation_coefficient(0.6, 320 + h, 295).value - radiation_coefficient(0.6, 320 - h, 295).value) / (2 * h);
    CHECK(radiation_coefficient(0.6, 320, 295).slope == doctest::Approx(slope).epsilon(1e-8));
}

TEST_CASE("constant film adds convection and radiation")
{
    const FilmLaw film = constant_film(5, 0.9, 293.15);
    const LawValue radiation = radiation_coefficient(0.9, 300, 293.15);
    CHECK(film(300).value == doctest::Approx(5 + radiation.value).epsilon(1e-15));
    CHECK(film(300).slope == radiation.slope);
    CHECK(constant_film(9.7, 0, 293.15)(400).value == 9.7);
    CHECK(constant_film(9.7, 0, 293.15)(400).slope == 0.0);
}

TEST_CASE("radiation refuses what has no meaning")
{
    CHECK_THROWS_AS((void)radiation_coefficient(1.2, 300, 290), DomainError);
    CHECK_THROWS_AS((void)radiation_coefficient(0.5, -3, 290), DomainError);
    CHECK_THROWS_AS((void)constant_film(-1, 0, 290), DomainError);
    CHECK_THROWS_AS((void)constant_film(5, 2, 290), DomainError);
}
