#include "deadpoint/surroundings/convection.hpp"

#include "deadpoint/core/error.hpp"
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

bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

Nusselt nusselt_vertical(double rayleigh, double prandtl, VerticalLaw law)
{
    check("Rayleigh number", rayleigh);
    check_prandtl(prandtl);
    if (law == VerticalLaw::pair)
        return {detail::vertical_pair(rayleigh), within(rayleigh, 1e4, 1e13)};
    return {detail::vertical_churchill_chu(rayleigh, prandtl), within(rayleigh, 0.1, 1e12)};
}

Nusselt nusselt_facing_up(double rayleigh)
{
    check("Rayleigh number", rayleigh);
    return {detail::facing_up(rayleigh), within(rayleigh, 1e4, 1e11)};
}

Nusselt nusselt_facing_down(double rayleigh, DownLaw law)
{
    check("Rayleigh number", rayleigh);
    if (law == DownLaw::fifth)
        return {detail::facing_down_fifth(rayleigh), within(rayleigh, 1e4, 1e9)};
    return {detail::facing_down_quarter(rayleigh), within(rayleigh, 1e5, 1e10)};
}

Nusselt nusselt_horizontal_cylinder(double rayleigh, double prandtl)
{
    check("Rayleigh number", rayleigh);
    check_prandtl(prandtl);
    return {detail::horizontal_cylinder(rayleigh, prandtl), within(rayleigh, 1e-5, 1e12)};
}

Nusselt nusselt_rotating_cylinder(RotatingLaw law, double reynolds, double prandtl, double grashof, double cross_flow)
{
    check("Reynolds number", reynolds);
    check("Grashof number", grashof);
    check("Reynolds number of the cross flow", cross_flow);
    check_prandtl(prandtl);
    switch (law) {
    case RotatingLaw::etemad:
        return {0.076 * std::pow(reynolds, 0.7), within(reynolds, 8e3, 6.54e4)};
    case RotatingLaw::dropkin_carmi:
        return {0.073 * std::pow(reynolds, 0.7), within(reynolds, 1.5e4, 4.33e5)};
    case RotatingLaw::kays_bjorklund:
        return {detail::kays_bjorklund(reynolds, prandtl, grashof, cross_flow), within(reynolds, 800, 4.3e5)};
    case RotatingLaw::becker:
        break;
    }
    return {detail::becker(reynolds, prandtl), within(reynolds, 800, 4.3e5)};
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
    if (reynolds == 0)
        return {0, false};
    return {detail::rotating_disk(reynolds), reynolds <= 4e6};
}

Nusselt nusselt_moving_plate(double reynolds, double prandtl)
{
    check("Reynolds number", reynolds);
    check_prandtl(prandtl);
    return {detail::moving_plate(reynolds, prandtl), reynolds <= 1e8};
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
