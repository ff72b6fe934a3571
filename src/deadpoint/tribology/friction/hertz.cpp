#include "deadpoint/tribology/friction/hertz.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::tribology {
namespace {

constexpr double largest_difference = 0.99999999;
constexpr double nearly_round = 1e-6;  // below it F = 3/8 k^2 is exact to rounding, and the full form cancels

double curvature_difference(double axis_ratio)
{
    const double squared = axis_ratio * axis_ratio;
    const auto [first, second] = elliptic_integrals(axis_ratio);
    return ((1 + squared) * second - 2 * squared * first) / ((1 - squared) * second);
}

/// Bisection in ln(b/a): the difference decreases as the ellipse becomes rounder.
double axis_ratio_of(double difference)
{
    if (difference < nearly_round)
        return std::sqrt(1 - difference * 8 / 3);
    double slender = std::log(1e-6);
    double round = 0;
    for (int i = 0; i < 100; ++i) {
        const double middle = (slender + round) / 2;
        (curvature_difference(std::exp(middle)) > difference ? slender : round) = middle;
    }
    return std::exp((slender + round) / 2);
}

}  // namespace

EllipticIntegrals elliptic_integrals(double complementary)
{
    if (!(complementary > 0) || complementary > 1)
        throw DomainError(
            fmt::format("elliptic integrals: the axis ratio {} is not above 0 and at most 1", complementary));
    double a = 1;
    double b = complementary;
    double c_squared = 1 - complementary * complementary;
    double sum = c_squared / 2;
    for (int halving = 0; c_squared > 1e-34 && halving < 20; ++halving) {
        const double c = (a - b) / 2;
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
        c_squared = c * c;
        sum += std::ldexp(c_squared, halving);
    }
    const double first = std::numbers::pi / (2 * a);
    return {first, first * (1 - sum)};
}

ContactShape contact_shape(double difference)
{
    if (!(difference >= 0) || difference > largest_difference)
        throw DomainError(
            fmt::format("Hertz contact: curvature difference {} is outside 0 .. {}\n  help: the groove must "
                        "be wider than the ball (osculation above 0.5)",
                        difference, largest_difference));
    const double ratio = axis_ratio_of(difference);
    const auto [first, second] = elliptic_integrals(ratio);
    const double major = std::cbrt(2 * second / (std::numbers::pi * ratio * ratio));
    return {ratio, major, ratio * major, 2 * first / std::numbers::pi / major};
}

double contact_compliance(double modulus_1, double poisson_1, double modulus_2, double poisson_2)
{
    require_positive("Young's modulus of the first body [Pa]", modulus_1);
    require_positive("Young's modulus of the second body [Pa]", modulus_2);
    for (const double poisson : {poisson_1, poisson_2})
        if (!(poisson >= 0) || poisson > 0.5)
            throw InputError(fmt::format("Hertz contact: Poisson's ratio {} is outside 0 .. 0.5", poisson));
    return (1 - poisson_1 * poisson_1) / modulus_1 + (1 - poisson_2 * poisson_2) / modulus_2;
}

ContactEllipse contact_ellipse(const ContactCurvature& curvature, double compliance, double load)
{
    require_positive("compliance of a contact [1/Pa]", compliance);
    require_not_negative("load of a contact [N]", load);
    if (!(curvature.sum > 0) || !std::isfinite(curvature.sum))
        throw DomainError(fmt::format("Hertz contact: the sum of curvatures is {} 1/m, so the bodies do not touch in a "
                                      "point",
                                      curvature.sum));
    const ContactShape shape = contact_shape(curvature.difference);
    if (load == 0)
        return {};
    const double unit = std::cbrt(1.5 * load * compliance / curvature.sum);
    const double major = shape.major * unit;
    const double minor = shape.minor * unit;
    return {major, minor, shape.approach * unit * unit * curvature.sum / 2,
            1.5 * load / (std::numbers::pi * major * minor)};
}

}  // namespace deadpoint::tribology
