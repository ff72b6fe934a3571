#pragma once

#include <cmath>

/// Internal to surroundings: forward differentiation, so that a convection coefficient and its
/// slope come from one formula.
namespace deadpoint::surroundings::detail {

/// A value and its derivative by one variable (here always the surface temperature).
struct Dual {
    double value = 0;
    double slope = 0;
    Dual() = default;
    Dual(double constant) : value(constant) {}
    Dual(double v, double s) : value(v), slope(s) {}
};

inline Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
inline Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
inline Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
inline Dual operator/(Dual a, Dual b)
{
    const double quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
}

inline double value_of(double a) { return a; }
inline double value_of(Dual a) { return a.value; }

inline double power(double base, double exponent) { return std::pow(base, exponent); }
/// At base zero the slope is given as zero: the formulas here are only evaluated there where the base stays zero.
inline Dual power(Dual base, double exponent)
{
    const double result = std::pow(base.value, exponent);
    return {result, base.value == 0 ? 0 : exponent * result / base.value * base.slope};
}

inline double logarithm(double a) { return std::log(a); }
inline Dual logarithm(Dual a) { return {std::log(a.value), a.slope / a.value}; }

}  // namespace deadpoint::surroundings::detail
