#include "deadpoint/surroundings/radiation.hpp"

#include "deadpoint/core/error.hpp"

#include <fmt/format.h>

namespace deadpoint::surroundings {

LawValue radiation_coefficient(double emissivity, double surface_temperature, double ambient_temperature)
{
    const double s = surface_temperature;
    const double a = ambient_temperature;
    if (!(emissivity >= 0 && emissivity <= 1))
        throw DomainError(fmt::format("emissivity {} is not between 0 and 1", emissivity));
    if (!(s > 0) || !(a > 0))
        throw DomainError(
            fmt::format("radiation needs absolute temperatures above zero: surface {} K, ambient {} K", s, a));
    const double factor = emissivity * stefan_boltzmann;
    return {factor * (s * s + a * a) * (s + a), factor * (3 * s * s + 2 * s * a + a * a), true};
}

FilmLaw constant_film(double coefficient, double emissivity, double ambient_temperature)
{
    if (!(coefficient >= 0))
        throw DomainError(fmt::format("film coefficient {} W/m2/K is negative", coefficient));
    if (emissivity == 0)
        return [coefficient](double) { return LawValue{coefficient, 0, true}; };
    (void)radiation_coefficient(emissivity, ambient_temperature,
                                ambient_temperature);  // refuses wrong arguments at once
    return [=](double surface_temperature) {
        LawValue film = radiation_coefficient(emissivity, surface_temperature, ambient_temperature);
        film.value += coefficient;
        return film;
    };
}

}  // namespace deadpoint::surroundings
