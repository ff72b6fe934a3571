/// Requirement: a case states an oil by a table, by two points of its data sheet, or by Vogel's formula.
#include "deadpoint/press/laws/viscosity.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;

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
    oil.law = casefile::Lubricant::Law::walther;
    oil.viscosity = {{zero_celsius + 40, zero_celsius + 100}, {32e-6, 5.4e-6}};
    const auto law = press::viscosity_law(with_oil(oil), "oil");
    CHECK(law(zero_celsius + 40).value == near(32e-6, 1e-12));
    CHECK(law(zero_celsius + 100).value == near(5.4e-6, 1e-12));
    // by hand: log10 log10 (nu + 0.7) linear in log10 T
    const auto w = [](double nu) { return std::log10(std::log10(nu + 0.7)); };
    const double share = (std::log10(zero_celsius + 70) - std::log10(zero_celsius + 40)) /
                         (std::log10(zero_celsius + 100) - std::log10(zero_celsius + 40));
    const double nu = std::pow(10, std::pow(10, w(32) + share * (w(5.4) - w(32)))) - 0.7;
    CHECK(law(zero_celsius + 70).value == near(nu * 1e-6, 1e-12));
    // The shipped grade is the same oil, tabulated every 5 K.
    oil = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml", {"lubricants.oil.library=ISO-VG-32"})
              .value.lubricants.at("oil");
    CHECK(press::viscosity_law(with_oil(oil), "oil")(zero_celsius + 70).value == near(nu * 1e-6, 1e-4));
    CHECK(law(zero_celsius + 70).in_range);
    CHECK(!law(zero_celsius - 30).in_range);
}

TEST_CASE("Vogel's formula")
{
    casefile::Lubricant oil;
    oil.law = casefile::Lubricant::Law::vogel;
    oil.vogel_factor = 0.1387e-6;
    oil.vogel_b = 736.48;
    const auto law = press::viscosity_law(with_oil(oil), "oil");
    CHECK(law(zero_celsius + 50).value == near(0.1387e-6 * std::exp(736.48 / 145), 1e-12));
    CHECK(law(zero_celsius + 50).slope < 0);
}

TEST_CASE("an oil that grows stiffer as it warms is named")
{
    casefile::Lubricant oil;
    oil.law = casefile::Lubricant::Law::walther;
    oil.viscosity = {{zero_celsius + 40, zero_celsius + 100}, {5.4e-6, 32e-6}};
    CHECK_THROWS_WITH_AS(press::viscosity_law(with_oil(oil), "oil"), doctest::Contains("lubricants.oil: "), InputError);
}

TEST_CASE("an oil's law ends where nothing flows, and says which oil and where")
{
    casefile::Lubricant oil;
    // Ten times stiffer per kelvin: 1 degC below 60 degC, and at 20 degC 1e42 mm2/s.
    oil.viscosity = {{zero_celsius + 59, zero_celsius + 60}, {1e-3, 1e-4}};
    const auto law = press::viscosity_law(with_oil(oil), "oil");
    CHECK(law(zero_celsius + 57).value == near(0.1, 1e-9));
    CHECK_THROWS_WITH_AS(law(zero_celsius + 20),
                         "lubricants.oil: viscosity: at 20.0 degC the end slope of its table gives 1e+42 mm2/s, and "
                         "what lubricates has 0.1 to 1e+06 mm2/s\n  help: state the oil near that temperature too "
                         "(`viscosity`), or check why a joint gets there",
                         DomainError);
    CHECK_THROWS_AS(law(zero_celsius + 70), DomainError);  // 1e-8 mm2/s
    oil.law = casefile::Lubricant::Law::walther;
    oil.viscosity = {{zero_celsius + 40, zero_celsius + 100}, {32e-6, 5.4e-6}};
    const auto line = press::viscosity_law(with_oil(oil), "oil");
    CHECK(line(zero_celsius - 30).value < tribology::stiffest_oil);
    CHECK_THROWS_AS(line(zero_celsius - 120), DomainError);
    oil.law = casefile::Lubricant::Law::vogel;
    oil.vogel_factor = 6e-8;
    oil.vogel_b = 900;
    const auto formula = press::viscosity_law(with_oil(oil), "oil");
    CHECK(formula(zero_celsius - 20).value < tribology::stiffest_oil);
    CHECK_THROWS_AS(formula(zero_celsius - 90), DomainError);
    // stated points are believed
    oil.law = casefile::Lubricant::Law::table;
    oil.viscosity = {{zero_celsius, zero_celsius + 20}, {2, 1.5}};
    CHECK(press::viscosity_law(with_oil(oil), "oil")(zero_celsius + 10).value > tribology::stiffest_oil);
}
