/// Requirement: indices of sensitivity are those of functions whose indices are known exactly.
#include "deadpoint/design/morris.hpp"
#include "deadpoint/design/sobol.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

using namespace deadpoint;
using namespace deadpoint::design;

namespace {

using Function = std::function<double(const Point&)>;

/// sin x1 + a sin^2 x2 + b x3^4 sin x1, x in [-pi, pi] (Ishigami and Homma 1990), a = 7, b = 0.1.
double ishigami(const Point& u)
{
    const auto x = [&](std::size_t k) { return std::numbers::pi * (2 * u[k] - 1); };
    return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

const std::vector<double> weights{0, 1, 4.5, 9, 99, 99, 99, 99};

/// Product of (|4 u_i - 2| + a_i) / (1 + a_i) (Sobol').
double g_function(const Point& u)
{
    double product = 1;
    for (std::size_t k = 0; k < u.size(); ++k)
        product *= (std::abs(4 * u[k] - 2) + weights[k]) / (1 + weights[k]);
    return product;
}

std::vector<double> values_of(const SobolDesign& design, const Function& f)
{
    std::vector<double> values;
    for (std::size_t n = 0; n < design.size(); ++n)
        values.push_back(f(design.point(n)));
    return values;
}

SobolIndices indices_of(const Function& f, std::size_t inputs, std::size_t rows, unsigned seed = 1)
{
    const SobolDesign design(inputs, rows, seed);
    return sobol_indices(values_of(design, f), inputs, {50, 0.9, 1});
}

std::vector<MorrisEffect> effects_of(const Function& f, std::size_t inputs, std::size_t trajectories)
{
    const MorrisDesign design(inputs, trajectories, 1);
    std::vector<double> values;
    for (std::size_t n = 0; n < design.size(); ++n)
        values.push_back(f(design.point(n)));
    return morris_effects(values, design, {200, 0.9, 1});
}

}  // namespace

TEST_CASE("shifted points stay a net: each 16th of each coordinate has as many")
{
    const auto points = sobol_points(40, 256, 7);
    for (std::size_t k = 0; k < 40; ++k) {
        std::vector<int> count(16);
        for (const auto& point : points)
            ++count[static_cast<std::size_t>(16 * point[k])];
        CHECK(std::ranges::all_of(count, [](int n) { return n == 16; }));
    }
    CHECK(points == sobol_points(40, 256, 7));
    CHECK(points != sobol_points(40, 256, 8));
    CHECK_THROWS_AS(sobol_points(most_coordinates + 1, 1, 1), DomainError);
    CHECK(sobol_points(most_coordinates, 2, 1).size() == 2);
}

TEST_CASE("a design has A, B and A with one column of B")
{
    const SobolDesign design(3, 8, 1);
    CHECK(design.size() == 40);
    for (std::size_t row = 0; row < 8; ++row) {
        const auto a = design.point(row), b = design.point(8 + row);
        CHECK(a != b);
        for (std::size_t i = 0; i < 3; ++i) {
            auto mixed = a;
            mixed[i] = b[i];
            CHECK(design.point((2 + i) * 8 + row) == mixed);
        }
    }
    // In turn: each point once, row by row.
    std::set<std::size_t> seen;
    for (std::size_t k = 0; k < design.size(); ++k) {
        seen.insert(design.in_turn(k));
        CHECK(design.in_turn(k) % 8 == k / 5);
    }
    CHECK(seen.size() == design.size());
}

TEST_CASE("Sobol' indices of Ishigami's function are within 1 %")
{
    // Closed form: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2.
    const double pi4 = std::pow(std::numbers::pi, 4), a = 7, b = 0.1;
    const double v1 = 0.5 * std::pow(1 + b * pi4 / 5, 2), v2 = a * a / 8, v13 = b * b * pi4 * pi4 * 8 / 225;
    const double v = v1 + v2 + v13;
    for (const unsigned seed : {1, 2, 3}) {
        const auto found = indices_of(ishigami, 3, 8192, seed);
        CHECK(found.mean == near(a / 2, 0.01));
        CHECK(found.variance == near(v, 0.01));
        CHECK(found.inputs[0].first.value == near(v1 / v, 0.01));
        CHECK(found.inputs[1].first.value == near(v2 / v, 0.01));
        CHECK(std::abs(found.inputs[2].first.value) < 0.01);
        CHECK(found.inputs[0].total.value == near((v1 + v13) / v, 0.01));
        CHECK(found.inputs[1].total.value == near(v2 / v, 0.01));
        CHECK(found.inputs[2].total.value == near(v13 / v, 0.01));
    }
}

TEST_CASE("Sobol' indices of the g-function of eight inputs are within 0.01")
{
    // V_i = 1 / (3 (1 + a_i)^2), V = prod (1 + V_i) - 1, total V_i prod_{j != i} (1 + V_j).
    const auto found = indices_of(g_function, 8, 8192);
    double product = 1;
    for (const double weight : weights)
        product *= 1 + 1 / (3 * std::pow(1 + weight, 2));
    for (std::size_t k = 0; k < 8; ++k) {
        const double own = 1 / (3 * std::pow(1 + weights[k], 2));
        CHECK(found.inputs[k].first.value == near(own / (product - 1), 0, 0.01));
        CHECK(found.inputs[k].total.value == near(own * product / (1 + own) / (product - 1), 0, 0.01));
    }
}

TEST_CASE("bands of 90 % contain the exact indices of the g-function in most of 40 designs")
{
    double product = 1;
    for (const double weight : weights)
        product *= 1 + 1 / (3 * std::pow(1 + weight, 2));
    int covered = 0, tried = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const auto found = indices_of(g_function, 8, 256, seed);
        for (std::size_t k = 0; k < 4; ++k) {
            const double own = 1 / (3 * std::pow(1 + weights[k], 2));
            const double first = own / (product - 1), total = own * product / (1 + own) / (product - 1);
            covered += found.inputs[k].first.low <= first && first <= found.inputs[k].first.high ? 1 : 0;
            covered += found.inputs[k].total.low <= total && total <= found.inputs[k].total.high ? 1 : 0;
            tried += 2;
        }
    }
    // Quasi-random rows are better than the independent ones that the bootstrap assumes, never much worse.
    CHECK(covered >= static_cast<int>(0.85 * tried));
    CHECK(tried == 320);
}

TEST_CASE("an output that does not vary has no indices, and a row with a failed point is left out")
{
    const auto constant = indices_of([](const Point&) { return 3.5; }, 2, 16);
    CHECK(constant.mean == 3.5);
    CHECK(std::isnan(constant.inputs[0].first.value));
    CHECK(std::isnan(constant.inputs[1].total.low));

    const SobolDesign design(3, 4096, 1);
    auto values = values_of(design, ishigami);
    values[17] = values[2 * 4096 + 30] = std::numeric_limits<double>::quiet_NaN();
    const auto found = sobol_indices(values, 3, {10, 0.9, 1});
    CHECK(found.rows == 4094);
    CHECK(found.inputs[1].total.value == near(0.4424, 0.02));
    CHECK_THROWS_AS(sobol_indices(std::vector<double>(7), 3, {}), DomainError);
}

TEST_CASE("the bound by derivatives lies above the total index, and is 12 / pi^2 of it for a straight line")
{
    // f = 3 u: V = 9/12, slope 3.
    CHECK(total_index_bound(std::vector<double>{3, 3}, 0.75) == near(12 / (std::numbers::pi * std::numbers::pi), 1e-5));
    // f = cos(pi u) is the function for which the bound is the index itself: V = 1/2, mean slope^2 = pi^2 / 2.
    std::vector<double> slopes;
    for (const auto& point : sobol_points(1, 1024, 1))
        slopes.push_back(-std::numbers::pi * std::sin(std::numbers::pi * point[0]));
    CHECK(total_index_bound(slopes, 0.5) == near(1, 1e-3));
    CHECK(std::isnan(total_index_bound({}, 1)));
}

TEST_CASE("effects of a linear function are its factors, without scatter")
{
    const auto found = effects_of([](const Point& u) { return 2 * u[0] - 3 * u[1] + 0 * u[2]; }, 3, 10);
    CHECK(found[0].strength.value == near(2, 1e-5));
    CHECK(found[1].strength.value == near(3, 1e-5));
    CHECK(found[1].mean == near(-3, 1e-5));
    CHECK(found[2].strength.value == 0);
    CHECK(found[0].deviation == near(0, 0, 1e-12));
    CHECK(found[1].strength.low == near(3, 1e-5));
    CHECK(found[1].strength.high == near(3, 1e-5));
}

TEST_CASE("effects of products and squares on the four levels are those worked out by hand")
{
    // u0 u1: the effect of u0 is u1, at levels 0, 1/3, 2/3, 1 alike: mean 1/2, deviation sqrt(5)/6.
    // u2^2: 2 u + 2/3 from the levels 0 and 1/3: mean 1, deviation 1/3.
    const auto found = effects_of([](const Point& u) { return u[0] * u[1] + u[2] * u[2]; }, 3, 4000);
    CHECK(found[0].strength.value == near(0.5, 0.03));
    CHECK(found[0].deviation == near(std::sqrt(5.0) / 6, 0.03));
    CHECK(found[2].strength.value == near(1, 0.03));
    CHECK(found[2].deviation == near(1.0 / 3, 0.03));
    // 4000 independent magnitudes of deviation 1/3: 90 % within 1.645 / 3 / sqrt(4000) = 0.0087.
    CHECK(found[2].strength.high - found[2].strength.low == near(2 * 0.0087, 0.2));
}
