#pragma once

#include "deadpoint/core/units.hpp"
#include "deadpoint/surroundings/dual.hpp"

#include <cmath>

/// Internal to surroundings: the formulas themselves, on plain numbers or numbers with a slope. Sources and ranges are
/// stated with the public functions in air.hpp and convection.hpp.
namespace deadpoint::surroundings::detail {

template <class S>
struct AirForm {
    S conductivity, viscosity, density, kinematic_viscosity, diffusivity, prandtl, expansion;
};

inline constexpr double air_heat_capacity = 1006;

template <class S>
AirForm<S> air_form(S T)
{
    const double T0 = zero_celsius;
    const S reduced = power(T / T0, 1.5);
    AirForm<S> air;
    air.viscosity = 1.716e-5 * reduced * (T0 + 110.4) / (T + 110.4);
    air.conductivity = 0.02414 * reduced * (T0 + 194.4) / (T + 194.4);
    air.density = 101325.0 / (287.05 * T);
    air.kinematic_viscosity = air.viscosity / air.density;
    air.diffusivity = air.conductivity / (air.density * air_heat_capacity);
    air.prandtl = air.kinematic_viscosity / air.diffusivity;
    air.expansion = 1.0 / T;
    return air;
}

/// Tested range of a law, in its Rayleigh or Reynolds number.
struct Range {
    double low, high;
    [[nodiscard]] bool contains(double x) const { return x >= low && x <= high; }
};
inline constexpr Range range_vertical{0.1, 1e12};
inline constexpr Range range_vertical_pair{1e4, 1e13};
inline constexpr Range range_facing_up{1e4, 1e11};
inline constexpr Range range_down_quarter{1e5, 1e10};
inline constexpr Range range_down_fifth{1e4, 1e9};
inline constexpr Range range_horizontal_cylinder{1e-5, 1e12};
inline constexpr Range range_becker{800, 4.3e5};
inline constexpr Range range_etemad{8e3, 6.54e4};
inline constexpr Range range_dropkin_carmi{1.5e4, 4.33e5};
inline constexpr Range range_disk{0, 4e6};
inline constexpr Range range_moving_plate{0, 1e8};

/// From `before` to `after` while x grows from `begin` to `end`, with a continuous slope: the
/// textbook pairs of laws jump where they meet, which would disturb the solver.
template <class S>
S crossover(S x, double begin, double end, S before, S after)
{
    if (value_of(x) <= begin)
        return before;
    if (value_of(x) >= end)
        return after;
    const S s = logarithm(x / begin) / std::log(end / begin);
    const S weight = s * s * (3.0 - 2.0 * s);
    return before + weight * (after - before);
}

template <class S>
S churchill_chu(S Ra, S Pr, double offset, double prandtl_scale)
{
    const S denominator = power(1.0 + power(prandtl_scale / Pr, 9.0 / 16), 8.0 / 27);
    const S root = offset + 0.387 * power(Ra, 1.0 / 6) / denominator;
    return root * root;
}

template <class S>
S vertical_churchill_chu(S Ra, S Pr)
{
    return churchill_chu(Ra, Pr, 0.825, 0.492);
}

template <class S>
S horizontal_cylinder(S Ra, S Pr)
{
    return churchill_chu(Ra, Pr, 0.6, 0.559);
}

template <class S>
S vertical_pair(S Ra)
{
    return crossover(Ra, 1e9, 1.5e9, S(0.59 * power(Ra, 0.25)), S(0.13 * power(Ra, 1.0 / 3)));
}

template <class S>
S facing_up(S Ra)
{
    return crossover(Ra, 1e7, 1.3e7, S(0.54 * power(Ra, 0.25)), S(0.15 * power(Ra, 1.0 / 3)));
}

template <class S>
S facing_down_quarter(S Ra)
{
    return 0.27 * power(Ra, 0.25);
}

template <class S>
S facing_down_fifth(S Ra)
{
    return 0.52 * power(Ra, 0.2);
}

template <class S>
S becker(S Re, S Pr)
{
    return 0.133 * power(Re, 2.0 / 3) * power(Pr, 1.0 / 3);
}

template <class S>
S etemad(S Re)
{
    return 0.076 * power(Re, 0.7);
}

template <class S>
S dropkin_carmi(S Re)
{
    return 0.073 * power(Re, 0.7);
}

template <class S>
S kays_bjorklund(S Re, S Pr, S Gr, S cross_flow)
{
    return 0.135 * power((0.5 * Re * Re + cross_flow * cross_flow + Gr) * Pr, 1.0 / 3);
}

template <class S>
S rotating_disk(S Re)
{
    const S turbulent = 0.015 * power(Re, 0.8) - 100.0 * power(2.4e5 / Re, 0.5);
    return crossover(Re, 2.4e5, 3e5, S(0.36 * power(Re, 0.5)), turbulent);
}

template <class S>
S moving_plate(S Re, S Pr)
{
    const S laminar = 0.664 * power(Re, 0.5);
    const S turbulent = 0.037 * power(Re, 0.8) - 871.0;
    return crossover(Re, 5e5, 6e5, laminar, turbulent) * power(Pr, 1.0 / 3);
}

/// (a^n + b^n)^(1/n), scaled so that neither power overflows; either may be zero.
template <class S>
S blend(S a, S b, double n)
{
    if (value_of(b) == 0)
        return a;
    if (value_of(a) == 0)
        return b;
    const bool first = value_of(a) >= value_of(b);
    const S large = first ? a : b;
    const S small = first ? b : a;
    return large * power(1.0 + power(small / large, n), 1 / n);
}

}  // namespace deadpoint::surroundings::detail
