#include "deadpoint/surroundings/convection.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/forms.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::surroundings {
namespace {

void check(const char* what, double value)
{
    if (!(value >= 0) || !std::isfinite(value))
        throw DomainError(fmt::format("convection: the {} is {}\n  help: it must be a number not below zero; check the "
                                      "lengths, speeds and temperatures of the surface",
                                      what, value));
}

void check_prandtl(double prandtl)
{
    check("Prandtl number", prandtl);
    if (prandtl == 0)
        throw DomainError("convection: the Prandtl number is 0\n  help: that of air is about 0.7");
}

}  // namespace

Nusselt nusselt_vertical(double rayleigh, double prandtl, VerticalLaw law)
{
    check("Rayleigh number", rayleigh);
    check_prandtl(prandtl);
    if (law == VerticalLaw::pair)
        return {detail::vertical_pair(rayleigh), detail::range_vertical_pair.contains(rayleigh)};
    return {detail::vertical_churchill_chu(rayleigh, prandtl), detail::range_vertical.contains(rayleigh)};
}

Nusselt nusselt_facing_up(double rayleigh)
{
    check("Rayleigh number", rayleigh);
    return {detail::facing_up(rayleigh), detail::range_facing_up.contains(rayleigh)};
}

Nusselt nusselt_facing_down(double rayleigh, DownLaw law)
{
    check("Rayleigh number", rayleigh);
    if (law == DownLaw::fifth)
        return {detail::facing_down_fifth(rayleigh), detail::range_down_fifth.contains(rayleigh)};
    return {detail::facing_down_quarter(rayleigh), detail::range_down_quarter.contains(rayleigh)};
}

Nusselt nusselt_horizontal_cylinder(double rayleigh, double prandtl)
{
    check("Rayleigh number", rayleigh);
    check_prandtl(prandtl);
    return {detail::horizontal_cylinder(rayleigh, prandtl), detail::range_horizontal_cylinder.contains(rayleigh)};
}

Nusselt nusselt_rotating_cylinder(RotatingLaw law, double reynolds, double prandtl, double grashof, double cross_flow)
{
    check("Reynolds number", reynolds);
    check("Grashof number", grashof);
    check("Reynolds number of the cross flow", cross_flow);
    check_prandtl(prandtl);
    switch (law) {
    case RotatingLaw::etemad:
        return {detail::etemad(reynolds), detail::range_etemad.contains(reynolds)};
    case RotatingLaw::dropkin_carmi:
        return {detail::dropkin_carmi(reynolds), detail::range_dropkin_carmi.contains(reynolds)};
    case RotatingLaw::kays_bjorklund:
        return {detail::kays_bjorklund(reynolds, prandtl, grashof, cross_flow),
                detail::range_becker.contains(reynolds)};
    case RotatingLaw::becker:
        break;
    }
    return {detail::becker(reynolds, prandtl), detail::range_becker.contains(reynolds)};
}

double rotating_reynolds(double speed, double diameter, double kinematic_viscosity)
{
    check("diameter [m]", diameter);
    check("kinematic viscosity [m2/s]", kinematic_viscosity);
    const double reynolds = std::abs(speed) * diameter * diameter / (2 * kinematic_viscosity);
    check("Reynolds number", reynolds);
    return reynolds;
}

Nusselt nusselt_rotating_disk(double reynolds)
{
    check("Reynolds number", reynolds);
    return {detail::rotating_disk(reynolds), detail::range_disk.contains(reynolds)};
}

Nusselt nusselt_moving_plate(double reynolds, double prandtl)
{
    check("Reynolds number", reynolds);
    check_prandtl(prandtl);
    return {detail::moving_plate(reynolds, prandtl), detail::range_moving_plate.contains(reynolds)};
}

double mixed_convection(double forced, double natural, double n, bool assisting)
{
    check("forced part", forced);
    check("natural part", natural);
    if (!(n >= 1) || !std::isfinite(n))
        throw DomainError(fmt::format("mixed convection with exponent {}\n  help: it lies between 3 and 4", n));
    if (assisting)
        return detail::blend(forced, natural, n);
    return std::pow(std::abs(std::pow(forced, n) - std::pow(natural, n)), 1 / n);
}

}  // namespace deadpoint::surroundings
