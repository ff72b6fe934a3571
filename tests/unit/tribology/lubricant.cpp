#include "deadpoint/tribology/friction/lubricant.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double zero_celsius = 273.15;

double central_slope(const ViscosityLaw& law, double temperature)
{
    constexpr double h = 1e-3;
    return (law(temperature + h).value - law(temperature - h).value) / (2 * h);
}

}  // namespace

TEST_CASE("viscosity: ISO VG grades by ASTM D341 from 40 and 100 degC")
{
    // Reference figures from an independent program, as printed; half a unit of the last digit.
    struct Row {
        int grade;
        double at_20, tolerance_20, at_70;
    };
    for (const Row& row : {Row{32, 86.28, 0.005, 11.19}, {68, 214.8, 0.05, 20.12}, {100, 341.8, 0.05, 27.18}}) {
        const Lubricant oil = iso_vg_oil(row.grade);
        CHECK(std::abs(oil.viscosity(zero_celsius + 20).value * 1e6 - row.at_20) < row.tolerance_20);
        CHECK(std::abs(oil.viscosity(zero_celsius + 70).value * 1e6 - row.at_70) < 0.005);
    }
}

TEST_CASE("viscosity: every grade meets its two points, falls with temperature, and is thinner than the next grade")
{
    const ViscosityLaw* thinner = nullptr;
    std::vector<ViscosityLaw> laws;
    laws.reserve(iso_vg_grades().size());
    for (const IsoVgGrade& grade : iso_vg_grades()) {
        CHECK(grade.at_40 * 1e6 == near(grade.grade, 1e-12));
        laws.push_back(iso_vg_oil(grade.grade).viscosity);
        const ViscosityLaw& law = laws.back();
        CHECK(law(zero_celsius + 40).value == near(grade.at_40, 1e-11));
        CHECK(law(zero_celsius + 100).value == near(grade.at_100, 1e-11));
        for (double celsius = -20; celsius <= 140; celsius += 5) {
            const LawValue nu = law(zero_celsius + celsius);
            CHECK(nu.slope < 0);
            CHECK(nu.slope == near(central_slope(law, zero_celsius + celsius), 1e-6));
            if (thinner != nullptr)
                CHECK((*thinner)(zero_celsius + celsius).value < nu.value);
        }
        thinner = &law;
    }
}

TEST_CASE("viscosity: Vogel's formula, its derivative, and a fit of published points")
{
    // Vogel-Cameron through the points of Zheng et al. 2018 from 30 to 70 degC: within 0.7 % is what a fit reaches
    // there.
    const ViscosityLaw law = vogel_viscosity({0.13870e-6, 736.48});
    CHECK(law(zero_celsius + 40).value == near(0.13870e-6 * std::exp(736.48 / 135), 1e-12));
    const double points[] = {50, 32.5, 22.5, 16, 12};
    for (int i = 0; i < 5; ++i)
        CHECK(std::abs(law(zero_celsius + 30 + 10 * i).value * 1e6 / points[i] - 1) < 0.01);
    for (const double temperature : {280.0, 320.0, 380.0})
        CHECK(law(temperature).slope == near(central_slope(law, temperature), 1e-7));
    CHECK_THROWS_AS(law(178.0), DomainError);
}

TEST_CASE("density and dynamic viscosity")
{
    const DensityLaw density = linear_density({870, 288.15, 7e-4});
    CHECK(density(288.15).value == near(870, 1e-15));
    CHECK(density(338.15).value == near(870 * (1 - 0.035), 1e-14));
    CHECK(density(338.15).slope == near(-0.609, 1e-14));
    const Lubricant oil = iso_vg_oil(32);
    const ViscosityLaw eta = dynamic_viscosity(oil);
    for (const double temperature : {290.0, 313.15, 350.0}) {
        CHECK(eta(temperature).value == near(oil.density(temperature).value * oil.viscosity(temperature).value, 1e-14));
        CHECK(eta(temperature).slope == near(central_slope(eta, temperature), 1e-7));
    }
}

TEST_CASE("lubricants: what is outside the tested range is computed and flagged")
{
    const ViscosityLaw oil = iso_vg_oil(32).viscosity;
    CHECK(oil(zero_celsius + 60).in_range);
    CHECK_FALSE(oil(zero_celsius - 40).in_range);
    CHECK_FALSE(oil(zero_celsius + 170).in_range);
    CHECK_FALSE(iso_vg_oil(10).viscosity(zero_celsius + 145).in_range);  // below 2 mm2/s
    CHECK_FALSE(linear_density({870})(600).in_range);
    CHECK_THROWS_AS(oil(0), DomainError);
    CHECK_THROWS_AS(oil(60), DomainError);  // overflows
}

TEST_CASE("lubricants that mean nothing are refused")
{
    CHECK_THROWS_AS(walther_through({313.15, 32e-6}, {313.15, 5e-6}), InputError);
    CHECK_THROWS_AS(walther_through({313.15, 5e-6}, {373.15, 32e-6}), InputError);
    CHECK_THROWS_AS(walther_through({313.15, 0}, {373.15, 5e-6}), InputError);
    CHECK_THROWS_AS(walther_through({313.15, 32e-6}, {373.15, 0.2e-6}), InputError);
    CHECK_THROWS_AS(vogel_viscosity({1e-7, 700, 300, {}}), InputError);
    CHECK_THROWS_AS(linear_density({-1}), InputError);
    CHECK_THROWS_WITH_AS(iso_vg_oil(50), doctest::Contains("10, 15, 22, 32, 46, 68, 100"), InputError);
    CHECK_THROWS_AS(dynamic_viscosity({}), InputError);
    // Either order of the two points gives the same line.
    const Walther forth = walther_through({313.15, 32e-6}, {373.15, 5.4e-6});
    const Walther back = walther_through({373.15, 5.4e-6}, {313.15, 32e-6});
    CHECK(forth.b == near(back.b, 1e-13));
}
