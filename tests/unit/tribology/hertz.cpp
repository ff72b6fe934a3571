#include "deadpoint/tribology/friction/hertz.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;

/// Complete elliptic integrals by the midpoint rule over the period: exact to rounding for these moduli.
EllipticIntegrals by_quadrature(double complementary)
{
    constexpr int count = 4000;
    const double k_squared = 1 - complementary * complementary;
    EllipticIntegrals sum;
    for (int i = 0; i < count; ++i) {
        const double sine = std::sin((i + 0.5) / count * pi / 2);
        const double root = std::sqrt(1 - k_squared * sine * sine);
        sum.first += pi / 2 / count / root;
        sum.second += pi / 2 / count * root;
    }
    return sum;
}

}  // namespace

TEST_CASE("elliptic integrals: limits, a published value and quadrature")
{
    CHECK(elliptic_integrals(1).first == near(pi / 2, 1e-15));
    CHECK(elliptic_integrals(1).second == near(pi / 2, 1e-15));
    // k^2 = 0.5 (Abramowitz and Stegun, Table 17.1)
    CHECK(elliptic_integrals(std::sqrt(0.5)).first == near(1.854074677301372, 1e-14));
    CHECK(elliptic_integrals(std::sqrt(0.5)).second == near(1.350643881047675, 1e-14));
    for (const double ratio : {0.9, 0.3, 0.05, 0.01}) {
        CHECK(elliptic_integrals(ratio).first == near(by_quadrature(ratio).first, 1e-12));
        CHECK(elliptic_integrals(ratio).second == near(by_quadrature(ratio).second, 1e-12));
    }
    CHECK(elliptic_integrals(1e-8).second == near(1, 1e-13));
    CHECK_THROWS_AS(elliptic_integrals(0), DomainError);
    CHECK_THROWS_AS(elliptic_integrals(1.01), DomainError);
}

TEST_CASE("contact ellipse: the published table of a*, b*, delta* over the curvature difference (Harris)")
{
    struct Row {
        double difference, major, minor, approach;
    };
    const Row table[] = {{0, 1, 1, 1},
                         {0.1075, 1.0760, 0.9318, 0.9974},
                         {0.3204, 1.2623, 0.8114, 0.9761},
                         {0.4795, 1.4556, 0.7278, 0.9429},
                         {0.5916, 1.6440, 0.6687, 0.9077},
                         {0.6716, 1.8258, 0.6245, 0.8733},
                         {0.7332, 2.011, 0.5881, 0.8394},
                         {0.7948, 2.265, 0.5480, 0.7961},
                         {0.83495, 2.494, 0.5186, 0.7602},
                         {0.87366, 2.800, 0.4863, 0.7169},
                         {0.90999, 3.233, 0.4499, 0.6636},
                         {0.93657, 3.738, 0.4166, 0.6112},
                         {0.95738, 4.395, 0.3830, 0.5551},
                         {0.97290, 5.267, 0.3490, 0.4960},
                         {0.983797, 6.448, 0.3150, 0.4352},
                         {0.990902, 8.062, 0.2814, 0.3745},
                         {0.995112, 10.222, 0.2497, 0.3176},
                         {0.997300, 12.789, 0.2232, 0.2705},
                         {0.9981847, 14.839, 0.2072, 0.2427},
                         {0.9989156, 17.974, 0.18822, 0.2106},
                         {0.9994785, 23.55, 0.16442, 0.17167},
                         {0.9998527, 37.38, 0.13050, 0.11995}};
    for (const Row& row : table) {
        CAPTURE(row.difference);
        const ContactShape shape = contact_shape(row.difference);
        // The table's differences are rounded and steep at the end, its numbers come from older quadrature: 0.1 %.
        CHECK(shape.major == near(row.major, 1e-3));
        CHECK(shape.minor == near(row.minor, 1e-3));
        CHECK(shape.approach == near(row.approach, 1e-3));
    }
}

TEST_CASE("contact ellipse: the shape satisfies its equation and is smooth towards the round contact")
{
    for (const double difference : {1e-7, 1e-5, 1e-3, 0.2, 0.9, 0.9999}) {
        const ContactShape shape = contact_shape(difference);
        const double squared = shape.axis_ratio * shape.axis_ratio;
        const auto [first, second] = elliptic_integrals(shape.axis_ratio);
        // b*, a*, delta* by their own formulas, from the axis ratio.
        CHECK(shape.minor == near(std::cbrt(2 * shape.axis_ratio * second / pi), 1e-12));
        CHECK(shape.approach == near(2 * first / pi * std::cbrt(pi * squared / (2 * second)), 1e-12));
        if (difference >= 1e-3)
            CHECK(((1 + squared) * second - 2 * squared * first) / ((1 - squared) * second) == near(difference, 1e-9));
        else  // F = 3/8 k^2
            CHECK(1 - squared == near(difference * 8 / 3, 1e-4));
    }
    CHECK_THROWS_AS(contact_shape(1), DomainError);
    CHECK_THROWS_AS(contact_shape(-0.1), DomainError);
}

TEST_CASE("contact of a ball on a plane: the closed form")
{
    constexpr double radius = 0.01;
    constexpr double load = 500;
    const double compliance = contact_compliance(208e9, 0.3, 110e9, 0.34);
    const double a = std::cbrt(3 * load * radius * compliance / 4);
    const ContactEllipse contact = contact_ellipse({2 / radius, 0}, compliance, load);
    CHECK(contact.major == near(a, 1e-13));
    CHECK(contact.minor == near(a, 1e-13));
    CHECK(contact.approach == near(a * a / radius, 1e-13));
    CHECK(contact.pressure == near(1.5 * load / (pi * a * a), 1e-13));
    CHECK(contact_ellipse({2 / radius, 0}, compliance, 0).major == 0.0);
    CHECK_THROWS_AS(contact_ellipse({2 / radius, 0}, compliance, -1), InputError);
    CHECK_THROWS_AS(contact_ellipse({0, 0}, compliance, 1), DomainError);
    CHECK_THROWS_AS(contact_compliance(0, 0.3, 1, 0.3), InputError);
    CHECK_THROWS_AS(contact_compliance(1, 0.6, 1, 0.3), InputError);
}
