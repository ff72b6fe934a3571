#include "deadpoint/surroundings/film.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/air.hpp"
#include "deadpoint/surroundings/forms.hpp"
#include "deadpoint/surroundings/radiation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace deadpoint::surroundings {
namespace {

using detail::Dual;
using Air = detail::AirForm<Dual>;

struct Part {
    Dual coefficient;
    bool in_range = true;
};

/// |x|, smoothed near zero as film_law() states.
Dual smooth_magnitude(Dual x)
{
    const double d = smoothed_difference;
    if (x.value >= d)
        return x;
    if (x.value <= -d)
        return Dual(0) - x;
    const Dual r = x / d;
    return d * (0.375 + r * r * (0.75 - 0.125 * r * r));
}

/// 0 well below zero, 1 well above, smooth between.
Dual share_above(Dual x)
{
    const double d = smoothed_difference;
    if (x.value >= d)
        return 1;
    if (x.value <= -d)
        return 0;
    const Dual s = (x + d) / (2 * d);
    return s * s * (3.0 - 2.0 * s);
}

bool tested(const detail::Range& range, Dual rayleigh, double difference)
{
    return range.contains(rayleigh.value) || (rayleigh.value < range.low && std::abs(difference) < 1);
}

/// Nusselt number of a horizontal plate that is warm on its upper side (or cold on its lower one) by `difference`.
Part horizontal_plate(const AirSurface& surface, Dual Ra, Dual difference)
{
    const bool quarter = surface.down_law == DownLaw::quarter;
    const Dual up = detail::facing_up(Ra);
    const Dual down = quarter ? detail::facing_down_quarter(Ra) : detail::facing_down_fifth(Ra);
    const auto& down_range = quarter ? detail::range_down_quarter : detail::range_down_fifth;
    const bool in_range = tested(difference.value > 0 ? detail::range_facing_up : down_range, Ra, difference.value);
    const Dual share = share_above(difference);
    return {share * up + (1.0 - share) * down, in_range};
}

Dual grashof_of(const Air& air, Dual difference, double length)
{
    return gravity * air.expansion * smooth_magnitude(difference) * (length * length * length) /
           (air.kinematic_viscosity * air.kinematic_viscosity);
}

Part natural_part(const AirSurface& surface, const Air& air, Dual difference)
{
    if (surface.natural == NaturalFlow::none)
        return {};
    const double length = surface.natural_length;
    const Dual Ra = grashof_of(air, difference, length) * air.prandtl;
    Part nusselt;
    switch (surface.natural) {
    case NaturalFlow::facing_up:
        nusselt = horizontal_plate(surface, Ra, difference);
        break;
    case NaturalFlow::facing_down:
        nusselt = horizontal_plate(surface, Ra, Dual(0) - difference);
        break;
    case NaturalFlow::horizontal_cylinder:
        nusselt = {detail::horizontal_cylinder(Ra, air.prandtl),
                   tested(detail::range_horizontal_cylinder, Ra, difference.value)};
        break;
    default:
        if (surface.vertical_law == VerticalLaw::pair)
            nusselt = {detail::vertical_pair(Ra), tested(detail::range_vertical_pair, Ra, difference.value)};
        else
            nusselt = {detail::vertical_churchill_chu(Ra, air.prandtl),
                       tested(detail::range_vertical, Ra, difference.value)};
    }
    return {nusselt.coefficient * air.conductivity / length, nusselt.in_range};
}

Part rotating_cylinder_part(const AirSurface& surface, const Air& air, Dual difference)
{
    const double d = surface.forced_length;
    const Dual Re = std::abs(surface.speed) * d * d / 2 / air.kinematic_viscosity;
    switch (surface.rotating_law) {
    case RotatingLaw::etemad:
        return {detail::etemad(Re), detail::range_etemad.contains(Re.value)};
    case RotatingLaw::dropkin_carmi:
        return {detail::dropkin_carmi(Re), detail::range_dropkin_carmi.contains(Re.value)};
    case RotatingLaw::kays_bjorklund:
        return {detail::kays_bjorklund(Re, air.prandtl, grashof_of(air, difference, d), Dual(0)),
                detail::range_becker.contains(Re.value)};
    case RotatingLaw::becker:
        break;
    }
    return {detail::becker(Re, air.prandtl), detail::range_becker.contains(Re.value)};
}

bool law_contains_natural(const AirSurface& surface)
{
    return surface.forced == ForcedFlow::rotating_cylinder && surface.rotating_law == RotatingLaw::kays_bjorklund;
}

Part forced_part(const AirSurface& surface, const Air& air, Dual difference)
{
    if (surface.forced == ForcedFlow::none || (surface.speed == 0 && !law_contains_natural(surface)))
        return {};
    const double length = surface.forced_length;
    const double speed = std::abs(surface.speed);
    if (surface.forced == ForcedFlow::rotating_disk) {
        const double radius = length / 2;
        const Dual Re = speed * radius * radius / air.kinematic_viscosity;
        return {detail::rotating_disk(Re) * air.conductivity / radius, detail::range_disk.contains(Re.value)};
    }
    Part nusselt;
    if (surface.forced == ForcedFlow::rotating_cylinder) {
        nusselt = rotating_cylinder_part(surface, air, difference);
    } else {
        const Dual Re = speed * length / air.kinematic_viscosity;
        nusselt = {detail::moving_plate(Re, air.prandtl), detail::range_moving_plate.contains(Re.value)};
    }
    return {nusselt.coefficient * air.conductivity / length, nusselt.in_range};
}

double exponent_of(const AirSurface& surface)
{
    if (surface.natural == NaturalFlow::horizontal_cylinder || surface.forced == ForcedFlow::rotating_cylinder)
        return mixed_exponent_cylinder;
    if (surface.natural == NaturalFlow::facing_up || surface.natural == NaturalFlow::facing_down)
        return mixed_exponent_horizontal;
    return mixed_exponent_plate;
}

LawValue film_of(const AirSurface& surface, double surface_temperature, double ambient)
{
    const double mean = (surface_temperature + ambient) / 2;
    const bool air_in_range = air_properties(mean).in_range;  // refuses an impossible temperature
    const Air air = detail::air_form(Dual(mean, 0.5));
    const Dual difference(surface_temperature - ambient, 1);

    const Part forced = forced_part(surface, air, difference);
    Dual convection = forced.coefficient;
    bool in_range = forced.in_range;
    if (!law_contains_natural(surface)) {
        const Part natural = natural_part(surface, air, difference);
        convection = detail::blend(forced.coefficient, natural.coefficient, exponent_of(surface));
        // If forced convection is the smaller part, a speed below its tested range has little effect.
        in_range =
            forced.coefficient.value > natural.coefficient.value ? in_range && natural.in_range : natural.in_range;
    }
    const LawValue radiation = radiation_coefficient(surface.emissivity, surface_temperature, ambient);
    return {convection.value + radiation.value, convection.slope + radiation.slope, in_range && air_in_range};
}

void check_length(const char* what, double value)
{
    if (!(value > 0) || !std::isfinite(value))
        throw DomainError(fmt::format("surface in air: the {} is {} m\n  help: give a positive length", what, value));
}

}  // namespace

FilmLaw film_law(const AirSurface& surface, double ambient)
{
    if (surface.natural != NaturalFlow::none && !law_contains_natural(surface))
        check_length("length for natural convection", surface.natural_length);
    if (surface.forced != ForcedFlow::none)
        check_length("diameter or length for forced convection", surface.forced_length);
    if (!std::isfinite(surface.speed))
        throw DomainError("surface in air: the speed is not finite\n  help: check the speeds of the mechanism");
    (void)film_of(surface, ambient, ambient);  // refuses a wrong ambient or emissivity at once
    return [surface, ambient](double temperature) { return film_of(surface, temperature, ambient); };
}

NaturalFlow natural_flow_of_face(double up)
{
    if (!(std::abs(up) <= 1 + 1e-9))
        throw DomainError(fmt::format("the vertical component {} of a unit normal is not within -1..1\n"
                                      "  help: divide the normal by its length",
                                      up));
    const double limit = std::numbers::sqrt2 / 2;
    if (up >= limit)
        return NaturalFlow::facing_up;
    return up <= -limit ? NaturalFlow::facing_down : NaturalFlow::vertical;
}

FilmLaw enclosed_film(FilmLaw open, double area, double exchange)
{
    if (!(area > 0) || !std::isfinite(area) || !(exchange >= 0))
        throw DomainError(fmt::format("enclosed surfaces of {} m2 with an exchange of {} W/K\n"
                                      "  help: give a positive area and an exchange not below zero",
                                      area, exchange));
    if (exchange == 0)
        return [open = std::move(open)](double temperature) { return LawValue{0, 0, open(temperature).in_range}; };
    return [open = std::move(open), ratio = area / exchange](double temperature) {
        const LawValue film = open(temperature);
        const double factor = 1 / (1 + film.value * ratio);
        return LawValue{film.value * factor, film.slope * factor * factor, film.in_range};
    };
}

namespace {

const char* name_of(NaturalFlow flow)
{
    switch (flow) {
    case NaturalFlow::vertical:
        return "vertical";
    case NaturalFlow::facing_up:
        return "facing-up";
    case NaturalFlow::facing_down:
        return "facing-down";
    case NaturalFlow::horizontal_cylinder:
        return "horizontal-cylinder";
    default:
        return "none";
    }
}

const char* name_of(ForcedFlow flow)
{
    switch (flow) {
    case ForcedFlow::rotating_cylinder:
        return "rotating-cylinder";
    case ForcedFlow::rotating_disk:
        return "rotating-disk";
    case ForcedFlow::moving_plate:
        return "moving-plate";
    default:
        return "none";
    }
}

}  // namespace

LawFormula formula_of(const AirSurface& s)
{
    return {std::string("air film, natural ") + name_of(s.natural) + ", forced " + name_of(s.forced),
            {{"natural_length", s.natural_length},
             {"forced_length", s.forced_length},
             {"speed", s.speed},
             {"emissivity", s.emissivity},
             {"vertical_law", static_cast<double>(s.vertical_law)},
             {"down_law", static_cast<double>(s.down_law)},
             {"rotating_law", static_cast<double>(s.rotating_law)}}};
}

}  // namespace deadpoint::surroundings
