#include "deadpoint/core/quantity.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>

using namespace deadpoint;
using D = Dimension;

namespace {

QuantityProblem problem(std::string_view text, Dimension dimension)
{
    const auto result = try_parse_quantity(text, dimension);
    REQUIRE(std::holds_alternative<QuantityProblem>(result));
    return std::get<QuantityProblem>(result);
}

}  // namespace

TEST_CASE("quantities are converted to SI")
{
    // Exact: the units' factors are powers of ten, defined conversions (inch, pound-force) or simple quotients.
    CHECK(parse_quantity("300 kN", D::force) == 300e3);
    CHECK(parse_quantity("29.8 mm", D::length) == 0.0298);
    CHECK(parse_quantity("1 in", D::length) == 0.0254);
    CHECK(parse_quantity("2 inch", D::length) == 0.0508);
    CHECK(parse_quantity("135 GPa", D::pressure) == 135e9);
    CHECK(parse_quantity("3 h", D::time) == 10800);
    CHECK(parse_quantity("30 min", D::time) == 1800);
    CHECK(parse_quantity("70 mm^2/s", D::kinematic_viscosity) == 70e-6);
    CHECK(parse_quantity("70 cSt", D::kinematic_viscosity) == near(70e-6, 1e-15));
    CHECK(parse_quantity("1.05e-5 1/K", D::expansion) == 1.05e-5);
    CHECK(parse_quantity("6.01e-6 m^2 K/W", D::thermal_resistance) == 6.01e-6);
    CHECK(parse_quantity("5 W/(m^2 K)", D::heat_transfer_coefficient) == 5);
    CHECK(parse_quantity("46 W/m/degC", D::conductivity) == 46);
    CHECK(parse_quantity("45.83 kg m^2", D::inertia) == 45.83);
    CHECK(parse_quantity("10 N s/m", D::damping) == 10);
    CHECK(parse_quantity("1 kW/m^2", D::heat_flux) == 1000);
    CHECK(parse_quantity("3600 um/h", D::velocity) == near(1e-6, 1e-15));
    CHECK(parse_quantity("  -485.6mm ", D::length) == -0.4856);
    CHECK(parse_quantity("+5 mm", D::length) == 0.005);
    CHECK(parse_quantity("0.5", D::none) == 0.5);
    CHECK(parse_quantity("0e99999999999 mm", D::length) == 0);  // zero whatever its exponent
}

TEST_CASE("angles and angular velocities")
{
    // 200 rpm = 200 * 2 pi / 60 rad/s
    CHECK(parse_quantity("200 rpm", D::angular_velocity) == near(20.943951023931955, 1e-15));
    CHECK(parse_quantity("180 deg", D::angle) == near(3.141592653589793, 1e-15));
    CHECK(parse_quantity("1.5 rad", D::angle) == 1.5);
    CHECK(parse_quantity("2 rad/s", D::angular_velocity) == 2);
    CHECK(problem("5 kg", D::angle).message == "'kg' is a mass, but this key needs an angle");
    CHECK(problem("5 %", D::angle).code == "unit-mismatch");
    CHECK(problem("5 Hz", D::angular_velocity).code == "unit-mismatch");
    CHECK(problem("5 rpm", D::angle).message == "'rpm' is an angular velocity, but this key needs an angle");
    CHECK(problem("5 deg", D::length).message == "'deg' is an angle, but this key needs a length");
}

TEST_CASE("temperatures have an origin, their differences do not")
{
    CHECK(parse_quantity("20 degC", D::temperature) == 293.15);
    CHECK(parse_quantity("68 degF", D::temperature) == near(293.15, 1e-15));
    CHECK(parse_quantity("293.15 K", D::temperature) == 293.15);
    CHECK(parse_quantity("20 \u00b0C", D::temperature) == 293.15);
    CHECK(parse_quantity("5 K", D::temperature_difference) == 5);
    for (const char* text : {"5 degC", "5 degF", "5 \u00b0C"}) {
        CAPTURE(text);
        CHECK(problem(text, D::temperature_difference).code == "unit-mismatch");
        CHECK(problem(text, D::temperature_difference).help.find("write K") == 0);
    }
}

TEST_CASE("what is not a quantity is refused with a remedy")
{
    CHECK(problem("200", D::length).code == "missing-unit");
    CHECK(problem("200", D::length).help == "write it like \"200 mm\"");
    CHECK(problem("200 kg", D::length).message == "'kg' is a mass, but this key needs a length");
    CHECK(problem("200 furlogs", D::length).code == "unknown-unit");
    CHECK(problem("20 W/m2K", D::heat_transfer_coefficient).code == "unknown-unit");
    CHECK(problem("mm", D::length).code == "not-a-quantity");
    CHECK(problem("", D::length).code == "not-a-quantity");
    CHECK(problem("nan mm", D::length).code == "not-finite");
    CHECK(problem("inf mm", D::length).code == "not-finite");
    CHECK(problem("1e400 mm", D::length).code == "not-finite");
    CHECK(problem("1e308 km", D::length).code == "not-finite");
    CHECK(problem("5 mm", D::none).code == "unit-mismatch");
    CHECK_THROWS_AS(parse_quantity("200 kg", D::length), InputError);
}

TEST_CASE("arithmetic and shifted origins of the unit library are refused")
{
    CHECK(problem("10 5 mm", D::length).code == "marks-in-number");
    CHECK(problem("5 m @ 3", D::length).code == "unknown-unit");
    CHECK(problem("5 K from 273", D::temperature).code == "unknown-unit");
    CHECK(problem("5 lg(re 1 m)", D::length).code == "unknown-unit");
    CHECK(problem("5 -m", D::length).code == "unknown-unit");
}

TEST_CASE("every example of the dimension table is a quantity of its own dimension")
{
    for (const auto& info : all_dimensions()) {
        CAPTURE(info.name);
        CHECK(&dimension_info(info.dimension) == &info);
        CHECK(std::holds_alternative<double>(try_parse_quantity(info.example, info.dimension)));
    }
}

TEST_CASE("written values read back bit by bit")
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-9, 12);
    std::uniform_real_distribution<double> mantissa(-10, 10);
    for (const auto& info : all_dimensions()) {
        CAPTURE(info.name);
        for (int i = 0; i < 50; ++i) {
            const double value = mantissa(random) * std::pow(10.0, exponent(random));
            const std::string text = format_quantity(value, info.dimension);
            CAPTURE(text);
            CHECK(parse_quantity(text, info.dimension) == value);
        }
    }
    CHECK(format_quantity(0.0298, D::length) == "29.8 mm");
    CHECK(format_quantity(293.15, D::temperature) == "20 degC");
    CHECK(format_quantity(parse_quantity("200 rpm", D::angular_velocity), D::angular_velocity) == "200 rpm");
    CHECK(format_quantity(0, D::force) == "0 kN");
    CHECK(format_number(1) == "1.0");
    CHECK(format_number(1e-10) == "1e-10");
}
