#include "deadpoint/reduce/sensitivity/film_state.hpp"

#include "deadpoint/heat/films.hpp"

#include <cmath>

namespace deadpoint::reduce {
namespace {

constexpr double difference_step = 1e-3;  // [K]

// Central difference of fourth order at a place.
double slope_of(const std::function<double(double)>& function, double at)
{
    const double h = difference_step;
    return (8 * (function(at + h) - function(at - h)) - (function(at + 2 * h) - function(at - 2 * h))) / (12 * h);
}

// (q(mean + s) + q(mean - s)) / 2
double mean_flux(const FilmLaw& law, double mean, double deviation, double faced)
{
    const auto flux = [&](double at) { return law(at).value * (at - faced); };
    return deviation > 0 ? 0.5 * (flux(mean + deviation) + flux(mean - deviation)) : flux(mean);
}

void add_convection(const std::function<FilmLaw(double)>& law_at, FilmState& film)
{
    const auto law = law_at(film.faced);
    const double deviation = std::sqrt(film.variance);
    const auto flux_slope = [&](double at) {
        const auto value = law(at);
        return value.value + value.slope * (at - film.faced);
    };
    const double above = flux_slope(film.mean + deviation), below = flux_slope(film.mean - deviation);
    film.by_mean = 0.5 * (above + below);
    film.by_variance = deviation > 0 ? (above - below) / (4 * deviation) : 0;
    film.by_faced = slope_of([&](double at) { return mean_flux(law_at(at), film.mean, deviation, at); }, film.faced);
}

void add_radiation(double emissivity, FilmState& film)
{
    const auto own = emission(film.mean, film.variance), received = emission(film.faced, 0);
    film.by_mean += emissivity * own.by_mean;
    film.by_variance += emissivity * own.by_variance;
    film.by_faced -= emissivity * received.by_mean;
}

}  // namespace

FilmState film_state(const std::function<FilmLaw(double)>& law, double emissivity, bool in_room, double mean,
                     double variance, double faced)
{
    FilmState film;
    film.mean = mean;
    film.variance = variance;
    film.faced = faced;
    film.outside = outside_flux(law(faced), emissivity, in_room, mean, variance, faced);
    add_convection(law, film);
    if (!in_room)
        add_radiation(emissivity, film);
    const auto slope = [&](double of, double at_mean, double at_faced) {
        return heat::film_slope(law(at_faced)(at_mean), of, at_mean, at_faced);
    };
    film.slope = slope(emissivity, mean, faced);
    film.own_slope = slope(in_room ? 0 : emissivity, mean, faced);
    film.slope_by_mean = slope_of([&](double at) { return slope(emissivity, at, faced); }, mean);
    film.slope_by_faced = slope_of([&](double at) { return slope(emissivity, mean, at); }, faced);
    return film;
}

double outside_flux(const FilmLaw& law, double emissivity, bool in_room, double mean, double variance, double faced)
{
    const double radiated = in_room ? 0 : emissivity * (emission(mean, variance).value - emission(faced, 0).value);
    return mean_flux(law, mean, std::sqrt(variance), faced) + radiated;
}

Emission emission(double mean, double variance)
{
    const double sigma = heat::stefan_boltzmann, square = mean * mean;
    return {sigma * square * (square + 6 * variance), sigma * mean * (4 * square + 12 * variance), 6 * sigma * square};
}

}  // namespace deadpoint::reduce
