/// Requirement: a ball in its socket has the friction, the film and the area of its seat.
#include "deadpoint/tribology/friction/ball_seat.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;

/// Integral over the seat of f(cos of the angle to the force, lever arm about the axis), by the rule of the middle:
/// the error falls with the square of the steps, 4e-6 of the value here.
template <class Function>
double over(const BallSeat& seat, const Function& f)
{
    constexpr int steps = 600;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double theta = seat.from + (seat.to - seat.from) * (i + 0.5) / steps;
            const double phi = 2 * pi * (j + 0.5) / steps;
            const double along = std::sin(theta) * std::cos(phi);
            const double area =
                seat.radius * seat.radius * std::sin(theta) * (seat.to - seat.from) / steps * 2 * pi / steps;
            sum += area * f(std::cos(theta), seat.radius * std::sqrt(1 - along * along));
        }
    return sum;
}

}  // namespace

TEST_CASE("a half ball rubs at 4 / pi of its radius, a small seat at its radius")
{
    CHECK(friction_radius({0.05, 0, pi / 2}) == near(0.05 * 4 / pi, 1e-12));
    CHECK(friction_radius({0.05, 0, 0.01}) == near(0.05, 1e-4));  // 1 + theta^2 / 8
    CHECK(seat_area({0.05, 0, pi / 2}) == near(2 * pi * 0.05 * 0.05, 1e-14));
    CHECK(film_length({0.05, 0, pi / 2}) ==  // 2 pi r^3 L = 4 pi / 3 R^4, at r = 4 / pi R
          near(0.05 * 2.0 / 3 * std::pow(pi / 4, 3), 1e-12));
}

TEST_CASE("friction, film and area of any seat are the integrals over it")
{
    for (const BallSeat& seat : {BallSeat{0.04, 0, 1.2}, BallSeat{0.03, 0.35, 1.4}, BallSeat{0.1, 0.5, pi / 2}}) {
        const double force = over(seat, [](double cosine, double) { return cosine * cosine; });
        const double moment = over(seat, [](double cosine, double arm) { return cosine * arm; });
        CHECK(friction_radius(seat) == near(moment / force, 1e-5));
        CHECK(seat_area(seat) == near(over(seat, [](double, double) { return 1; }), 1e-5));
        const double r = friction_radius(seat);
        CHECK(2 * pi * r * r * r * film_length(seat) ==
              near(over(seat, [](double, double arm) { return arm * arm; }), 1e-5));
    }
}

TEST_CASE("seats that are none are refused")
{
    CHECK_THROWS_AS(friction_radius({0, 0, 1}), InputError);
    CHECK_THROWS_AS(seat_area({0.05, 1, 1}), InputError);
    CHECK_THROWS_AS(seat_area({0.05, -0.1, 1}), InputError);
    CHECK_THROWS_AS(film_length({0.05, 0, 1.6}), InputError);
}
