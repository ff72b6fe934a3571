#include "deadpoint/surroundings/paper_film.hpp"

#include "deadpoint/core/table.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/air.hpp"

#include <array>
#include <cmath>

namespace deadpoint::surroundings {
namespace {

constexpr double paper_prandtl = 0.707;

constexpr std::array<PaperAir, 6> table_7{{
    {293.15, 2.59e-2, 18.1e-6},
    {303.15, 2.67e-2, 18.6e-6},
    {313.15, 2.73e-2, 19.1e-6},
    {323.15, 2.83e-2, 25.7e-6},
    {333.15, 2.90e-2, 27.2e-6},
    {343.15, 2.96e-2, 28.6e-6},
}};

bool within_table(double temperature)
{
    return temperature >= table_7.front().temperature && temperature <= table_7.back().temperature;
}

/// A row pair of Table 6: laminar c Ra^(1/4) from `low` to `middle`, turbulent c Ra^(1/3) to `high`.
struct PaperWall {
    double laminar, turbulent, low, middle, high;

    [[nodiscard]] double nusselt(double rayleigh) const
    {
        return rayleigh <= middle ? laminar * std::pow(rayleigh, 0.25) : turbulent * std::cbrt(rayleigh);
    }
};

PaperWall table_6(NaturalFlow flow)
{
    switch (flow) {
    case NaturalFlow::vertical:
        return {0.59, 0.13, 1e4, 1e9, 1e12};
    case NaturalFlow::facing_up:
        return {0.54, 0.14, 1e5, 2e7, 3e10};
    case NaturalFlow::facing_down:
        return {0.27, 0, 3e5, 3e10, 3e10};
    default:
        throw DomainError(
            "Table 6 of the paper has no such surface\n  help: compare a vertical wall, or a plate facing "
            "up or down");
    }
}

}  // namespace

std::span<const PaperAir> paper_air_table() { return table_7; }

PaperAir paper_air(double temperature)
{
    std::array<double, table_7.size()> places{}, conductivities{}, viscosities{};
    for (std::size_t i = 0; i < table_7.size(); ++i) {
        places[i] = table_7[i].temperature;
        conductivities[i] = table_7[i].conductivity;
        viscosities[i] = table_7[i].kinematic_viscosity;
    }
    return {temperature, interpolate_linear(places, conductivities, temperature).value,
            interpolate_linear(places, viscosities, temperature).value};
}

FilmComparison compare_natural_film(NaturalFlow flow, double length, double surface_temperature, double ambient)
{
    const PaperWall wall = table_6(flow);
    const FilmLaw corrected = film_law({.natural = flow, .natural_length = length}, ambient);
    const LawValue film = corrected(surface_temperature);

    const double mean = (surface_temperature + ambient) / 2;
    const PaperAir air = paper_air(mean);
    const double nu = air.kinematic_viscosity;
    const double printed_grashof =
        gravity * air.conductivity * std::abs(surface_temperature - ambient) * length * length * length / (nu * nu);
    const double product = printed_grashof * paper_prandtl;
    return {.paper = wall.nusselt(product) * air.conductivity / length,
            .corrected = film.value,
            .paper_in_range = product >= wall.low && product <= wall.high && within_table(mean),
            .corrected_in_range = film.in_range};
}

FilmComparison compare_rotating_film(double speed, double diameter, double film)
{
    const AirProperties air = air_properties(film);
    const PaperAir printed = paper_air(film);
    const double printed_reynolds = rotating_reynolds(speed, diameter, printed.kinematic_viscosity);
    const double reynolds = rotating_reynolds(speed, diameter, air.kinematic_viscosity);
    if (!(reynolds > 0))
        throw DomainError("a cylinder at rest has no rotating film\n  help: give a speed and a diameter above zero");
    const Nusselt paper = nusselt_rotating_cylinder(RotatingLaw::becker, printed_reynolds, paper_prandtl);
    const Nusselt corrected = nusselt_rotating_cylinder(RotatingLaw::becker, reynolds, air.prandtl);
    return {.paper = paper.value * printed.conductivity / diameter,
            .corrected = corrected.value * air.conductivity / diameter,
            .paper_in_range = printed_reynolds < 4.3e5 && within_table(film),
            .corrected_in_range = corrected.in_range && air.in_range};
}

FilmLaw paper_film_law(const AirSurface& surface, double ambient)
{
    const auto value = [surface, ambient](double temperature) {
        const double rise = std::abs(temperature - ambient);
        if (surface.forced == ForcedFlow::rotating_cylinder && surface.speed > 0)
            return compare_rotating_film(surface.speed, surface.forced_length, ambient + rise / 2);
        const auto flow = surface.natural == NaturalFlow::horizontal_cylinder ? NaturalFlow::vertical : surface.natural;
        return compare_natural_film(flow, surface.natural_length, ambient + rise, ambient);
    };
    return [value](double temperature) {
        constexpr double step = 0.01;  // [K]
        const auto at = value(temperature);
        const double slope = (value(temperature + step).paper - value(temperature - step).paper) / (2 * step);
        return LawValue{at.paper, slope, at.paper_in_range};
    };
}

}  // namespace deadpoint::surroundings
