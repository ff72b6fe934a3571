/// Requirement: a case states an oil by a table, by two points of its data sheet, or by Vogel's formula.
#include "deadpoint/casefile/read.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/study/viscosity.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using doctest::Approx;

namespace {

constexpr double zero_celsius = 273.15;

casefile::Case with_oil(const casefile::Lubricant& oil)
{
    casefile::Case input;
    input.lubricants["oil"] = oil;
    return input;
}

}  // namespace

TEST_CASE("two points of a data sheet give the line of ASTM D341")
{
    casefile::Lubricant oil;
    oil.law = "walther";
    oil.viscosity = {{zero_celsius + 40, zero_celsius + 100}, {32e-6, 5.4e-6}};
    const auto law = study::viscosity_law(with_oil(oil), "oil");
    CHECK(law(zero_celsius + 40).value == Approx(32e-6).epsilon(1e-12));
    CHECK(law(zero_celsius + 100).value == Approx(5.4e-6).epsilon(1e-12));
    // by hand: log10 log10 (nu + 0.7) linear in log10 T
    const auto w = [](double nu) { return std::log10(std::log10(nu + 0.7)); };
    const double share = (std::log10(zero_celsius + 70) - std::log10(zero_celsius + 40)) /
                         (std::log10(zero_celsius + 100) - std::log10(zero_celsius + 40));
    const double nu = std::pow(10, std::pow(10, w(32) + share * (w(5.4) - w(32)))) - 0.7;
    CHECK(law(zero_celsius + 70).value == Approx(nu * 1e-6).epsilon(1e-12));
    // The shipped grade is the same oil, tabulated every 5 K.
    oil = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml", {"lubricants.oil.library=ISO-VG-32"})
              .value.lubricants.at("oil");
    CHECK(study::viscosity_law(with_oil(oil), "oil")(zero_celsius + 70).value == Approx(nu * 1e-6).epsilon(1e-4));
    CHECK(law(zero_celsius + 70).in_range);
    CHECK(!law(zero_celsius - 30).in_range);
}

TEST_CASE("Vogel's formula")
{
    casefile::Lubricant oil;
    oil.law = "vogel";
    oil.vogel_factor = 0.1387e-6;
    oil.vogel_b = 736.48;
    const auto law = study::viscosity_law(with_oil(oil), "oil");
    CHECK(law(zero_celsius + 50).value == Approx(0.1387e-6 * std::exp(736.48 / 145)).epsilon(1e-12));
    CHECK(law(zero_celsius + 50).slope < 0);
}

TEST_CASE("an oil that grows stiffer as it warms is named")
{
    casefile::Lubricant oil;
    oil.law = "walther";
    oil.viscosity = {{zero_celsius + 40, zero_celsius + 100}, {5.4e-6, 32e-6}};
    CHECK_THROWS_WITH_AS(study::viscosity_law(with_oil(oil), "oil"), doctest::Contains("lubricants.oil: "), InputError);
}
