#include "deadpoint/full/refine/refine.hpp"

#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using deadpoint::full::PartError;
using deadpoint::full::size_factors;

TEST_CASE("like parts are refined alike, by the order of the error")
{
    const std::vector<PartError> parts{{1, 1000, 2, false}, {1, 1000, 2, false}};
    const auto factors = size_factors(parts, 2 * 0.49, 0.3, 1e9);
    CHECK(factors[0] == near(0.7, 1e-9));  // 0.7^2 = 0.49
    CHECK(factors[1] == near(0.7, 1e-9));
}

TEST_CASE("the factors take the fewest cells of all that reach the target")
{
    const std::vector<PartError> parts{{0.9, 500, 2, false}, {0.3, 4000, 2, false}};
    const double target = 0.4;
    const auto best = size_factors(parts, target, 0.2, 1e9);
    const auto error = [&](double f, double g) { return 0.9 * f * f + 0.3 * g * g; };
    const auto cells = [&](double f, double g) { return 500 / (f * f * f) + 4000 / (g * g * g); };
    CHECK(error(best[0], best[1]) == near(target, 1e-6));
    // (n_1 e_2 / (n_2 e_1))^(1/5)
    CHECK(best[0] / best[1] == near(std::pow(500 * 0.3 / (4000 * 0.9), 0.2), 1e-6));
    for (double f = 0.4; f < 0.74; f += 0.002) {
        const double left = (target - 0.9 * f * f) / 0.3;
        if (left > 0 && left <= 1)
            CHECK(cells(f, std::sqrt(left)) >= cells(best[0], best[1]) * (1 - 1e-9));
    }
}

TEST_CASE("parts of no error and meshes from files stay, and one round refines within its limit")
{
    const std::vector<PartError> parts{
        {1, 1000, 2, false}, {0, 10, 2, false}, {0.4, 100, 2, true}, {1e-6, 10, 2, false}};
    const auto factors = size_factors(parts, 1e-3, 0.5, 1e9);
    CHECK(factors[0] < 0.7);
    CHECK(factors[0] >= 0.5);
    CHECK(factors[1] == 1);
    CHECK(factors[2] == 1);
    CHECK(factors[3] == 1);
}

TEST_CASE("the cells stay below their limit, at the price of the target")
{
    const std::vector<PartError> parts{{1, 1000, 2, false}, {0.5, 3000, 2, false}};
    const auto factors = size_factors(parts, 0.1, 0.2, 10000);
    const double cells = 1000 * std::pow(factors[0], -3) + 3000 * std::pow(factors[1], -3);
    CHECK(cells <= 10000 * (1 + 1e-6));
    CHECK(cells > 9000);
    for (const double factor : size_factors(parts, 0.1, 0.2, 3000))
        CHECK(factor == 1);  // more than allowed already
}

TEST_CASE("an element order of two asks for less: the error falls faster")
{
    const auto first = size_factors({{1, 1000, 2, false}}, 0.25, 0.2, 1e9);
    const auto second = size_factors({{1, 1000, 3, false}}, 0.25, 0.2, 1e9);
    CHECK(first[0] == near(0.5, 1e-9));
    CHECK(second[0] == near(std::cbrt(0.25), 1e-9));
}
