#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/reference/element.hpp"
#include "deadpoint/fem/reference/matrix3.hpp"
#include "deadpoint/fem/reference/quadrature.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::fem;

namespace {

double factorial(int n) { return std::tgamma(n + 1); }

double integral(const Quadrature& rule, int a, int b, int c)
{
    double sum = 0;
    for (unsigned q = 0; q < rule.size(); ++q) {
        const auto& x = rule.points[q];
        sum += rule.weights[q] * std::pow(x[0], a) * std::pow(x[1], b) * std::pow(x[2], c);
    }
    return sum;
}

template <class Visitor>
void for_each_monomial(int degree, const Visitor& visit)
{
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b)
            for (int c = 0; a + b + c <= degree; ++c)
                visit(a, b, c);
}

}  // namespace

// Tables have 16 to 18 digits, and up to 64 terms are summed.
constexpr double rounding = 1e-14;

TEST_CASE("rule n integrates monomials up to degree 2 n - 1 exactly, and no higher degree")
{
    for (int n = 1; n <= 4; ++n) {
        CAPTURE(n);
        const auto cube = gauss_on_cube(static_cast<unsigned>(n)),
                   simplex = gauss_on_tetrahedron(static_cast<unsigned>(n));
        CHECK(cube.size() == static_cast<unsigned>(n * n * n));
        for_each_monomial(2 * n - 1, [&](int a, int b, int c) {
            CHECK(integral(cube, a, b, c) == near(1.0 / ((a + 1) * (b + 1) * (c + 1)), rounding));
            const double exact = factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3);
            CHECK(integral(simplex, a, b, c) == near(exact, 4 * rounding));
        });
        CHECK(integral(cube, 2 * n, 0, 0) != near(1.0 / (2 * n + 1), 1e-9));
        CHECK(integral(simplex, 2 * n, 0, 0) != near(factorial(2 * n) / factorial(2 * n + 3), 1e-9));
    }
}

TEST_CASE("points of rules lie within the cell, and their weights are positive")
{
    for (unsigned n = 1; n <= 4; ++n)
        for (const auto& rule : {gauss_on_cube(n), gauss_on_tetrahedron(n)})
            for (unsigned q = 0; q < rule.size(); ++q) {
                const auto& x = rule.points[q];
                CHECK(std::min({x[0], x[1], x[2], rule.weights[q]}) > 0);
                CHECK(std::max({x[0], x[1], x[2]}) < 1);
            }
}

TEST_CASE("shape function i is 1 at node i and 0 at the others; slopes are those of its values")
{
    for (const auto kind : {CellKind::hexahedron, CellKind::tetrahedron})
        for (const int degree : {1, 2}) {
            const ReferenceElement element(kind, degree);
            CHECK(element.size() == (element.is_cube() ? (degree == 1 ? 8U : 27U) : (degree == 1 ? 4U : 10U)));
            for (unsigned i = 0; i < element.size(); ++i) {
                for (unsigned j = 0; j < element.size(); ++j)
                    CHECK(element.value(i, element.nodes()[j]) == near(i == j ? 1 : 0, 1e-15, 1e-15));
                const Vec3 x{0.21, 0.34, 0.17};
                constexpr double h = 1e-4;  // central differences of polynomials of degree 2 in each variable are exact
                for (std::size_t c = 0; c < 3; ++c) {
                    Vec3 more = x, less = x;
                    more[c] += h;
                    less[c] -= h;
                    const double difference = (element.value(i, more) - element.value(i, less)) / (2 * h);
                    CHECK(element.slope(i, x)[c] == near(difference, 0, 1e-11));  // 1e-16 / h, rounded up
                }
            }
        }
}

TEST_CASE("a matrix times its inverse is one")
{
    const Matrix3 a{{{2, -1, 0.5}, {0.25, 3, 1}, {-0.5, 1, 4}}};
    CHECK(determinant(a) == near(2 * (12 - 1) + 1 * (1 + 0.5) + 0.5 * (0.25 + 1.5), 1e-15));  // by the first row
    const auto inverse = inverse_transposed(a);
    const Vec3 x{1, -2, 3}, back = times_transposed(inverse, times(a, x));
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(back[i] == near(x[i], 1e-14));
}
