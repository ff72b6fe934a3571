#include "deadpoint/tribology/friction/ball_seat.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"

#include <cmath>
#include <numbers>

namespace deadpoint::tribology {
namespace {

void check(const BallSeat& seat)
{
    require_positive("radius of a ball [m]", seat.radius);
    if (!(seat.from >= 0 && seat.from < seat.to && seat.to <= std::numbers::pi / 2 * (1 + 1e-12)))
        throw InputError("the seat of a ball joint lies between two half angles, 0 <= from < to <= 90 degrees");
}

double cube(double x) { return x * x * x; }

/// (1 + s^2) E(s) - (1 - s^2) K(s), three times the integral of s E(s) from 0.
double disc_integral(double s)
{
    if (s >= 1)
        return 2;
    return (1 + s * s) * std::comp_ellint_2(s) - (1 - s * s) * std::comp_ellint_1(s);
}

}  // namespace

double seat_area(const BallSeat& seat)
{
    check(seat);
    return 2 * std::numbers::pi * seat.radius * seat.radius * (std::cos(seat.from) - std::cos(seat.to));
}

double friction_radius(const BallSeat& seat)
{
    check(seat);
    const double turned = disc_integral(std::sin(seat.to)) - disc_integral(std::sin(seat.from));
    return seat.radius * 2 / std::numbers::pi * turned / (cube(std::cos(seat.from)) - cube(std::cos(seat.to)));
}

double film_length(const BallSeat& seat)
{
    check(seat);
    const double along = std::cos(seat.from) - std::cos(seat.to);
    const double cubes = cube(std::cos(seat.from)) - cube(std::cos(seat.to));
    return seat.radius * cube(seat.radius / friction_radius(seat)) * (along + cubes / 3) / 2;
}

}  // namespace deadpoint::tribology
