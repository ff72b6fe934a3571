#include "deadpoint/surroundings/radiation.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::surroundings;

TEST_CASE("radiation coefficient: flux is the difference of fourth powers")
{
    const double flux = radiation_coefficient(0.8, 350, 290).value * (350 - 290);
    const double exact = 0.8 * stefan_boltzmann * (std::pow(350, 4) - std::pow(290, 4));
    CHECK(flux == near(exact, 1e-13));
    // Hand number: 4 * 0.9 * 5.670374419e-8 * 293.15^3 at equal temperatures.
    CHECK(radiation_coefficient(0.9, 293.15, 293.15).value == near(5.142614, 1e-7));
}

TEST_CASE("radiation coefficient: derivative agrees with central differences")
{
    const double h = 1e-3;
    const double slope =
        (radiation_coefficient(0.6, 320 + h, 295).value - radiation_coefficient(0.6, 320 - h, 295).value) / (2 * h);
    CHECK(radiation_coefficient(0.6, 320, 295).slope == near(slope, 1e-8));
}

TEST_CASE("constant film adds convection and radiation")
{
    const FilmLaw film = constant_film(5, 0.9, 293.15);
    const LawValue radiation = radiation_coefficient(0.9, 300, 293.15);
    CHECK(film(300).value == near(5 + radiation.value, 1e-15));
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

TEST_CASE("radiation in an enclosure: two large parallel plates, and a body within another")
{
    // 1 / (1/e1 + 1/e2 - 1) per area.
    const auto plates = enclosure_exchange({2, 2}, {0.8, 0.3});
    CHECK(plates[1] == near(2 / (1 / 0.8 + 1 / 0.3 - 1), 1e-14));
    // Concentric spheres or long cylinders: A1 / (1/e1 + A1/A2 (1/e2 - 1)), whichever comes first.
    const double exact = 0.5 / (1 / 0.6 + 0.5 / 3 * (1 / 0.2 - 1));
    CHECK(enclosure_exchange({0.5, 3}, {0.6, 0.2})[1] == near(exact, 1e-14));
    CHECK(enclosure_exchange({3, 0.5}, {0.2, 0.6})[2] == near(exact, 1e-14));
    // Black walls far larger than a body: as if in a large room.
    CHECK(enclosure_exchange({1, 1e6}, {0.9, 1})[1] == near(0.9, 1e-12));
}

TEST_CASE("radiation in an enclosure: surfaces that see each other alike")
{
    // The sides of a long duct of an equilateral triangle see half of their heat on either other side. For black sides
    // X = A F; for two sides of one emissivity and a black one by hand: J2 = e E2 + (1 - e) (E1 + J3) / 2 and so on.
    const auto black = enclosure_exchange({1, 1, 1}, {1, 1, 1});
    CHECK(black[1] == near(0.5, 1e-10));
    CHECK(black[0] == near(0, 0, 1e-10));
    const double e = 0.4, r = 1 - e;
    // With E1 = 1, E2 = E3 = 0: J2 = J3 = J, J = r (1 + J) / 2; what reaches side 2 and stays is e (1 + J) / 2.
    const double j = r / (2 - r);
    CHECK(enclosure_exchange({1, 1, 1}, {1, e, e})[1] == near(e * (1 + j) / 2, 1e-10));
    // The walls of a cube see a fifth of their heat on each other wall in this model.
    CHECK(enclosure_exchange({4, 4, 4, 4, 4, 4}, {1, 1, 1, 1, 1, 1})[5] == near(0.8, 1e-10));
}

TEST_CASE("radiation in an enclosure: reciprocal, and nothing is exchanged at one temperature")
{
    const std::vector<double> areas{0.3, 2, 1.1, 0.02, 2.4}, emissivities{0.9, 0.05, 0.5, 1, 0.3};
    const auto exchange = enclosure_exchange(areas, emissivities);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < areas.size(); ++j) {
            sum += exchange[i * areas.size() + j];
            CHECK(exchange[i * areas.size() + j] == exchange[j * areas.size() + i]);
            CHECK(exchange[i * areas.size() + j] >= -1e-12);
        }
        // Shares that still change by 1e-14 leave that much in the sums of the view factors.
        CHECK(sum == near(emissivities[i] * areas[i], 1e-11));
    }
    CHECK(enclosure_exchange({2}, {0.7}) == std::vector<double>{0.7 * 2});
}

TEST_CASE("radiation in an enclosure: what it refuses")
{
    CHECK_THROWS_AS(enclosure_exchange({1, 0}, {0.5, 0.5}), DomainError);
    CHECK_THROWS_AS(enclosure_exchange({1, 1}, {0.5, 0}), DomainError);
    CHECK_THROWS_AS(enclosure_exchange({1, 1}, {0.5, 1.01}), DomainError);
    CHECK_THROWS_AS(enclosure_exchange({1, 1}, {0.5}), DomainError);
}
