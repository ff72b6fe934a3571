/// Requirement: films and radiation by their laws, with slopes that keep matrices positive, and each watt with the
/// room, the enclosed air or the prescribed flux that it belongs to.
#include "deadpoint/heat/films.hpp"

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

LawValue constant(double value) { return {value, 0, true}; }

/// Surfaces: 0 film of 12 in the room, 1 film of 8 in its own ambient, 2 film of 5 in an enclosure, 3 flux,
/// 4 a temperature, 5 a film that radiates, 6 a film by a law in an enclosure.
struct Surfaces {
    Surfaces()
    {
        problem.surfaces.resize(7);
        for (auto& condition : problem.surfaces)
            condition.kind = SurfaceCondition::Kind::film;
        problem.surfaces[0].coefficient = 12;
        problem.surfaces[1].coefficient = 8;
        problem.surfaces[1].ambient = [](double time) { return 280 + time; };
        problem.surfaces[2].coefficient = 5;
        problem.surfaces[2].enclosure = 1;
        problem.surfaces[3].kind = SurfaceCondition::Kind::flux;
        problem.surfaces[3].flux = [](double time) { return 100 + 10 * time; };
        problem.surfaces[4].kind = SurfaceCondition::Kind::temperature;
        problem.surfaces[5].coefficient = 3;
        problem.surfaces[5].emissivity = 0.7;
        problem.surfaces[6].enclosure = 0;
        for (const double strength : {2.0, 6.0})
            problem.surfaces[6].laws.emplace_back([strength](double faced) -> FilmLaw {
                return [strength, faced](double t) {
                    return LawValue{strength * std::sqrt(std::abs(t - faced)), 0.5 * strength, true};
                };
            });
        problem.segments.resize(2);
        for (auto& segment : problem.segments)
            segment.ambient = [](double time) { return 290 + 0.5 * time; };
        geometry.layout = {0, 1, 7, 0, 0};
        geometry.surface_area = {0.5, 2, 1.5, 0.25, 0, 1, 3};
        values.assign(geometry.layout.count(), 0.0);
        for (std::size_t s = 0; s < 7; ++s)
            values[geometry.layout.surface(s)] = geometry.surface_area[s] * (310 + 2.0 * static_cast<double>(s));
        watts.assign(geometry.layout.count(), 0.0);
        balance.air.resize(2);
    }
    HeatProblem problem;
    HeatGeometry geometry;
    std::vector<double> values, watts;
    const std::vector<double> air{305, 300};
    HeatBalance balance;
};

}  // namespace

TEST_CASE("a film without emission is h (T - T_air), radiation alone is eps sigma (T^4 - T_a^4)")
{
    CHECK(film_flux(constant(15), 0, 330, 300) == near(450, 1e-15));
    const double exact = 0.9 * stefan_boltzmann * (std::pow(420.0, 4) - std::pow(290.0, 4));
    CHECK(film_flux(constant(0), 0.9, 420, 290) == near(exact, 1e-13));  // factored: no digits lost
    CHECK(film_flux(constant(15), 0.9, 300, 300) == 0);
    CHECK(film_flux(constant(15), 0.9, 290, 420) == near(-film_flux(constant(15), 0.9, 420, 290), 1e-15));
    CHECK(stefan_boltzmann == near(5.670374419e-8, 1e-12));  // CODATA 2018, exact by definition
}

TEST_CASE("near the surroundings' temperature radiation keeps its digits")
{
    constexpr double tiny = 1e-9;
    const double flux = film_flux(constant(0), 1, 300 + tiny, 300);
    const double difference = (300 + tiny) - 300;  // as numbers have it
    CHECK(flux == near(4 * stefan_boltzmann * 27e6 * difference, 1e-10));
}

TEST_CASE("the slope of a film is the derivative of its flux")
{
    const auto law = [](double t) { return LawValue{4 + 0.3 * (t - 300), 0.3, true}; };
    for (const double surface : {301.0, 340.0, 500.0}) {
        constexpr double h = 1e-3;
        const double by_difference =
            (film_flux(law(surface + h), 0.6, surface + h, 300) - film_flux(law(surface - h), 0.6, surface - h, 300)) /
            (2 * h);
        CHECK(film_slope(law(surface), 0.6, surface, 300) == near(by_difference, 1e-8));  // h^2, rounding
    }
}

TEST_CASE("the slope of a film that weakens as it warms stays above a quarter of its coefficient")
{
    // 20 W/m2/K that lose 1 W/m2/K a kelvin, 60 K above the air: the derivative is -40.
    CHECK(film_slope({20, -1, true}, 0, 360, 300) == 5);
    CHECK(film_slope({20, -0.1, true}, 0, 360, 300) == near(14, 1e-15));  // above it: the derivative
    CHECK(film_slope({20, -1, true}, 1, 360, 300) == near(5 + 4 * stefan_boltzmann * 360 * 360 * 360, 1e-14));
    CHECK(film_slope({0, -5, true}, 0, 360, 300) == 0);
}

TEST_CASE("only films with a law or an emissivity follow the temperature")
{
    const Surfaces at;
    const std::vector<bool> expected{false, false, false, false, false, true, true};
    for (std::size_t s = 0; s < expected.size(); ++s)
        CHECK(follows_temperature(at.problem.surfaces[s]) == expected[s]);
    SurfaceCondition flux;
    flux.kind = SurfaceCondition::Kind::flux;
    flux.emissivity = 0.5;  // has no film to radiate from
    CHECK_FALSE(follows_temperature(flux));
}

TEST_CASE("what a surface faces: its enclosure's air, else its own ambient, else the segment's")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    CHECK(films.surroundings(0, 8, at.air) == 294);
    CHECK(films.surroundings(1, 8, at.air) == 288);
    CHECK(films.surroundings(2, 8, at.air) == 300);
    CHECK(films.surroundings(6, 8, at.air) == 305);
    at.problem.surfaces[2].ambient = [](double) { return 1.0; };
    CHECK(films.surroundings(2, 8, at.air) == 300);  // the enclosure wins
    CHECK(films.some_follow());
    // All but the prescribed one are read.
    CHECK(films.needed() == std::vector<std::size_t>{1, 2, 3, 4, 6, 7});
}

TEST_CASE("a film's law is that of the segment that was entered")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    CHECK(films.law(6, 300)(316).value == near(8, 1e-15));
    films.enter(at.problem.segments[1]);
    CHECK(films.law(6, 300)(316).value == near(24, 1e-15));
    CHECK(films.law(6, 307)(316).value == near(18, 1e-15));  // by the air that it faces
    CHECK(films.law(5, 300)(316).value == 3);                // no law: the constant
    CHECK(films.law(5, 300)(316).slope == 0);
}

TEST_CASE("films that follow the temperature, all of them or those of one enclosure")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    const auto all = films.following(8, at.air);
    REQUIRE(all.size() == 2);
    CHECK(all[0].surface == 5);
    CHECK(all[0].emissivity == 0.7);
    CHECK(all[0].surroundings == 294);
    CHECK(all[1].surface == 6);
    CHECK(all[1].surroundings == 305);
    const auto of_first = films.following(8, at.air, 0);
    REQUIRE(of_first.size() == 1);
    CHECK(of_first[0].surface == 6);
    CHECK(films.following(8, at.air, 1).empty());
}

TEST_CASE("constant films and fluxes: each watt goes to the room, to an enclosure's air, or comes by the flux")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    films.evaluate(at.values, 8, at.air, at.balance, at.watts);
    // Surfaces 0 and 1 into the room: h A (T - T_air).
    CHECK(at.balance.to_air == near(12 * 0.5 * (310 - 294) + 8 * 2 * (312 - 288), 1e-13));
    CHECK(at.balance.air[1].from_surfaces == near(5 * 1.5 * (314 - 300), 1e-13));
    CHECK(at.balance.air[0].from_surfaces == 0);
    CHECK(at.balance.flux == near(180 * 0.25, 1e-15));
    // Loads per area: what the air brings, h T_air, and the flux; -h T is the matrix's.
    const auto& layout = at.geometry.layout;
    CHECK(at.watts[layout.surface(0)] == near(12 * 294.0, 1e-15));
    CHECK(at.watts[layout.surface(1)] == near(8 * 288.0, 1e-15));
    CHECK(at.watts[layout.surface(2)] == near(5 * 300.0, 1e-15));
    CHECK(at.watts[layout.surface(3)] == near(180, 1e-15));
    CHECK(at.watts[layout.surface(4)] == 0);
    CHECK(at.watts[layout.surface(5)] == 0);  // books what it gives off by itself
    for (const std::size_t s : {0, 1, 2, 3, 5, 6})
        CHECK(at.balance.film_mean[s] == near(310 + 2.0 * static_cast<double>(s), 1e-15));
    CHECK(at.balance.film_mean[4] == 0);
}

TEST_CASE("a constant film's matrix and load together are what it gives off")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    films.evaluate(at.values, 3, at.air, at.balance, at.watts);
    double lost = 0;
    for (const std::size_t s : {0, 1}) {
        const auto k = at.geometry.layout.surface(s);
        lost += at.problem.surfaces[s].coefficient * at.values[k] - at.watts[k] * at.geometry.surface_area[s];
    }
    CHECK(lost == near(at.balance.to_air, 1e-12));
}

TEST_CASE("a surface whose area another part covers wholly takes no part")
{
    Surfaces at;
    at.geometry.surface_area[0] = 0;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    films.evaluate(at.values, 8, at.air, at.balance, at.watts);
    CHECK(at.watts[at.geometry.layout.surface(0)] == 0);
    CHECK(at.balance.film_mean[0] == 0);
    CHECK(at.balance.to_air == near(8 * 2 * (312 - 288), 1e-13));
}

TEST_CASE("what films that follow the temperature lose is booked to its taker, less what other surfaces receive")
{
    Surfaces at;
    FilmBalance films(at.problem, at.geometry);
    films.enter(at.problem.segments[0]);
    FilmHeat heat;
    heat.lost = {0, 0, 0, 0, 0, 120, 70};
    heat.to_surfaces = {0, 0, 0, 0, 0, 0, 30};
    heat.untested = {0, 0, 0, 0, 0, 0, 0.4};
    at.balance.to_air = 1000;
    films.book(heat, at.balance);
    CHECK(at.balance.to_air == 1120);
    CHECK(at.balance.air[0].from_surfaces == 40);
    CHECK(at.balance.air[1].from_surfaces == 0);
    CHECK(at.balance.variable_to_air == heat.lost);
    CHECK(at.balance.films_untested == heat.untested);
}
