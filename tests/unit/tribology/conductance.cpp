#include "deadpoint/tribology/conductance/conductance.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/conductance/bearing_conductance.hpp"
#include "deadpoint/tribology/conductance/fractal_contact.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double printed = 1e-9;  // the reference values carry ten digits

const nlohmann::json& oracle(const char* entry)
{
    static const nlohmann::json data = [] {
        std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/heat_oracle_contact_air.json");
        return nlohmann::json::parse(file);
    }();
    return data[entry];
}

double number(const nlohmann::json& row, const char* key) { return row[key].get<double>(); }

/// The equation that defines psi, as printed.
double extension_residual(double psi, double D)
{
    return std::pow(psi, (2 - D) / 2) - std::pow(1 + std::pow(psi, -D / 2), -(2 - D) / D) - (2 - D) / D;
}

FractalContact steel_pair(double dimension)
{
    return {.dimension = dimension,
            .roughness = 2e-10,
            .sample = 1e-3,
            .separation = 5e-6,
            .hardness = 2.1e9,
            .modulus = 8.838978976e10,
            .conductivity1 = 41,
            .conductivity2 = 46.05};
}

FractalContact of_row(const nlohmann::json& row)
{
    FractalContact contact{.dimension = number(row, "D"),
                           .roughness = number(row, "G"),
                           .sample = number(row, "Lu"),
                           .hardness = number(row, "H"),
                           .modulus = number(row, "E")};
    if (row.contains("z")) {
        contact.separation = number(row, "z");
        contact.conductivity1 = number(row, "k1");
        contact.conductivity2 = number(row, "k2");
    }
    return contact;
}

const GapFluid oil{0.14, 0};
const GapFluid air{0.026, 3.7e-7};

}  // namespace

TEST_CASE("domain extension: reference values, residual and limits")
{
    for (const auto& row : oracle("psi"))
        CHECK(domain_extension(number(row, "D")) == near(number(row, "psi"), printed));
    for (double D = 1.02; D < 2; D += 0.04) {
        INFO("D ", D);
        // Rounding of the terms, each of order one, over the slope of order 0.1 near D = 2.
        CHECK(std::abs(extension_residual(domain_extension(D), D)) < 1e-14);
    }
    const double golden = (1 + std::sqrt(5.0)) / 2;
    CHECK(domain_extension(1 + 1e-9) == near(golden * golden, 1e-8));
    CHECK(domain_extension(2 - 1e-9) == near(std::numbers::e - 1, 1e-8));
    CHECK_THROWS_AS((void)domain_extension(1), DomainError);
    CHECK_THROWS_AS((void)domain_extension(2), DomainError);
    CHECK_THROWS_AS((void)domain_extension(std::nan("")), DomainError);
}

TEST_CASE("fractal area: reference values")
{
    for (const auto& row : oracle("contact_area")) {
        INFO("D ", number(row, "D"), " P ", number(row, "P"));
        const ContactArea area = fractal_area(of_row(row), number(row, "P"));
        CHECK(area.share == near(number(row, "Ar"), printed));
        CHECK(std::exp(area.log_critical) == near(number(row, "a_c"), printed));
        if (area.plastic)
            CHECK(area.share == near(number(row, "Ar_plastic"), printed));
    }
}

TEST_CASE("fractal area satisfies both sums over the spots as written in the docstring")
{
    for (const double D : {1.42, 1.47, 1.5, 1.56, 1.7, 1.9}) {
        const FractalContact contact = steel_pair(D);
        const double P = 2e7;
        const ContactArea area = fractal_area(contact, P);
        REQUIRE_FALSE(area.plastic);
        const double a = area.largest_spot;
        const double ac = std::exp(area.log_critical);
        const double h = (2 - D) / 2;
        const double q = (3 - 2 * D) / 2;
        const double common = std::pow(domain_extension(D), h) * std::pow(a, D / 2);
        const double integral = q == 0 ? std::log(a / ac) : (std::pow(a, q) - std::pow(ac, q)) / q;
        const double force = common * (D / 2 * 4 / (3 * std::sqrt(2 * pi)) * contact.modulus *
                                           std::pow(contact.roughness, D - 1) * integral +
                                       contact.hardness * D / (2 - D) * std::pow(ac, h));
        const double touching = common * D / (2 - D) * ((std::pow(a, h) - std::pow(ac, h)) / 2 + std::pow(ac, h));
        INFO("D ", D);
        CHECK(force == near(P * 1e-6, 1e-12));
        CHECK(touching == near(area.share * 1e-6, 1e-12));
    }
}

TEST_CASE("fractal area is smooth through D = 1.5 and through a_L = a_c")
{
    // Second differences over D across 1.5: ln A_r* has a curvature of about 30, here times the step squared.
    const double step = 1e-3;
    for (const double P : {3e5, 1e6, 1e7}) {
        const auto log_share = [P](double D) { return std::log(fractal_area(steel_pair(D), P).share); };
        for (double D = 1.49; D < 1.51; D += step) {
            INFO("D ", D, " P ", P);
            CHECK(std::abs(log_share(D + step) - 2 * log_share(D) + log_share(D - step)) < 5e-5);
        }
        CHECK(log_share(1.5 + 1e-9) == near(log_share(1.5), 1e-8));
        CHECK(log_share(1.5 - 1e-9) == near(log_share(1.5), 1e-8));
    }
    // At D = 1.4 the largest spot passes the critical one at some pressure: the share runs on there.
    const FractalContact contact = steel_pair(1.4);
    double low = 1e5;
    double high = 1e7;
    REQUIRE(fractal_area(contact, low).plastic);
    REQUIRE_FALSE(fractal_area(contact, high).plastic);
    while (high / low > 1 + 1e-13)
        (fractal_area(contact, std::sqrt(low * high)).plastic ? low : high) = std::sqrt(low * high);
    CHECK(fractal_area(contact, high).share == near(fractal_area(contact, low).share, 1e-11));
    CHECK(fractal_area(contact, high).largest_spot == near(fractal_area(contact, low).largest_spot, 1e-11));
}

TEST_CASE("fractal area grows with pressure; its slopes lie between the plastic and the elastic limit")
{
    for (double D = 1.05; D < 1.96; D += 0.05) {
        double before = 0;
        for (double P = 1e4; P < 3e7; P *= 1.7) {
            const double share = fractal_area(steel_pair(D), P).share;
            INFO("D ", D, " P ", P);
            CHECK(share > before);
            if (before > 0) {
                const double slope = std::log(share / before) / std::log(1.7);
                CHECK(slope > 0.99);
                CHECK(slope < 4.0 / 3 + 0.01);  // 2 / (3 - D) at D = 1.5, the steepest elastic power law
            }
            before = share;
        }
    }
    const ContactArea smooth = fractal_area(steel_pair(1.001), 1e6);  // a_c beyond any number
    CHECK(smooth.plastic);
    CHECK(smooth.share == near(1e6 / 2.1e9, 1e-15));
    CHECK(fractal_area(steel_pair(1.5), 0).share == 0);
}

TEST_CASE("fractal conductance: the five interfaces of Zheng et al. 2018, Table 3")
{
    for (const auto& row : oracle("table3_tcr")) {
        INFO(row["name"].get<std::string>());
        const FractalContact contact = of_row(row);
        const GapFluid fluid{number(row, "kf"), 0};
        const double P = number(row, "P");
        const ContactConductance result = fractal_conductance(contact, fluid, P);
        CHECK(result.in_range);
        CHECK(result.notes.empty());
        CHECK(result.resistance() == near(number(row, "R"), printed));
        CHECK(fractal_area(contact, P).share == near(number(row, "Ar"), printed));
        CHECK(fractal_conductance(contact, fluid, 2 * P).resistance() == near(number(row, "R_P2"), printed));
        CHECK(fractal_conductance(contact, fluid, P / 2).resistance() == near(number(row, "R_Phalf"), printed));
        const double z = fractal_separation(contact, fluid, P, 1 / number(row, "R"));
        CHECK(z == near(number(row, "z"), printed));
        // Air conducts less than oil; with little solid contact (the guides) it resists three to five times as much.
        const double in_air = fractal_conductance(contact, air, P).resistance() / result.resistance();
        CHECK(in_air > (fractal_area(contact, P).share < 1e-3 ? 3 : 1.3));
        CHECK(in_air < 5);
    }
}

TEST_CASE("fractal conductance grows with pressure at every dimension, and its separation inverts it")
{
    for (double D = 1.1; D < 1.95; D += 0.05) {
        for (const auto& fluid : {oil, air, GapFluid{0, 0}}) {
            double before = fluid.conductivity > 0 ? fractal_conductance(steel_pair(D), fluid, 0).conductance : 0;
            for (double P = 1e4; P < 2e7; P *= 3) {
                FractalContact contact = steel_pair(D);
                contact.separation = 1e-4;
                INFO("D ", D, " P ", P, " k_f ", fluid.conductivity);
                if (P == 1e4 && fluid.conductivity > 0)
                    before = fractal_conductance(contact, fluid, 0).conductance;
                const double h = fractal_conductance(contact, fluid, P).conductance;
                CHECK(h > before);
                before = h;
                CHECK(fractal_separation(contact, fluid, P, h) == near(1e-4, 1e-11));
            }
        }
    }
    FractalContact contact = steel_pair(1.5);
    CHECK(fractal_conductance(contact, oil, 0).conductance == near(0.14 / 1e-5, 1e-14));
}

TEST_CASE("fractal contact refuses what has no meaning and flags what is not meant")
{
    FractalContact contact = steel_pair(1.5);
    contact.separation = 1e-9;
    CHECK_THROWS_WITH_AS((void)fractal_conductance(contact, oil, 1e7),
                         doctest::Contains("must exceed the depth of the largest spot"), DomainError);
    CHECK_THROWS_AS((void)fractal_area(steel_pair(1.3), 3e9), DomainError);
    CHECK_THROWS_AS((void)fractal_area(steel_pair(1.5), -1), DomainError);
    CHECK_THROWS_AS((void)fractal_conductance(steel_pair(1.5), {0, 0}, 0), DomainError);
    contact.separation = 1e-4;
    const ContactConductance hard = fractal_conductance(contact, oil, 3e8);
    CHECK_FALSE(hard.in_range);
    CHECK(hard.notes.size() == 1);
}

TEST_CASE("Cooper, Mikic and Yovanovich: reference values and the published case")
{
    for (const auto& row : oracle("cmy")) {
        const RoughContact contact{number(row, "sigma"), number(row, "m"), number(row, "Hc"), number(row, "k1"),
                                   number(row, "k2")};
        const GapFluid fluid{number(row, "kg"), number(row, "M")};
        const double P = number(row, "P");
        CHECK(rough_conductance(contact, fluid, P).resistance() == near(number(row, "R"), printed));
        CHECK(rough_conductance(contact, {0, 0}, P).conductance == near(number(row, "h_c"), printed));
        CHECK(slope_of_roughness(number(row, "sigma")) == near(number(row, "m"), 1e-12));
    }
    // k 43, slope 0.1, sigma 1 um, P 10 MPa, H 2.5 GPa, no fluid: 28335.80 W/m2/K (seven digits).
    const ContactConductance known = rough_conductance({1e-6, 0.1, 2.5e9, 43, 43}, {0, 0}, 1e7);
    CHECK(known.conductance == near(28335.80, 2e-7));
    CHECK(known.in_range);
}

TEST_CASE("Cooper, Mikic and Yovanovich reproduces Table 3 of Zheng et al. 2018 with oil in the gaps")
{
    // The roughness with which the law gives the printed resistance, to three digits; slope by slope_of_roughness().
    const double roughness[] = {0.388e-6, 0.397e-6, 0.274e-6, 0.271e-6, 0.543e-6};
    for (std::size_t i = 0; i < 5; ++i) {
        const auto& row = oracle("table3_tcr")[i];
        const RoughContact contact{roughness[i], slope_of_roughness(roughness[i]), number(row, "H"), number(row, "k1"),
                                   number(row, "k2")};
        const double P = number(row, "P");
        CHECK(rough_conductance(contact, oil, P).resistance() == near(number(row, "R"), 2e-3));
        const double in_air = rough_conductance(contact, air, P).resistance();
        CHECK(in_air > 1.9e-5);
        CHECK(in_air < 4.7e-5);
    }
}

TEST_CASE("Cooper, Mikic and Yovanovich: grows with pressure, P^0.95 without fluid, flags and refusals")
{
    const RoughContact contact{1e-6, 0.1, 2.5e9, 43, 43};
    double before = rough_conductance(contact, oil, 0).conductance;
    for (double P = 1e2; P < 1e9; P *= 2) {
        const ContactConductance now = rough_conductance(contact, oil, P);
        CHECK(now.conductance > before);
        CHECK(now.in_range == (P >= 2.5e4 && P <= 5e7));
        before = now.conductance;
    }
    const double ratio =
        rough_conductance(contact, {0, 0}, 2e7).conductance / rough_conductance(contact, {0, 0}, 1e7).conductance;
    CHECK(ratio == near(std::pow(2, 0.95), 1e-13));
    CHECK_THROWS_AS((void)rough_conductance(contact, oil, 2.5e9), DomainError);
    CHECK_THROWS_AS((void)rough_conductance(contact, {0, 0}, 0), DomainError);
    CHECK_THROWS_AS((void)rough_conductance({0, 0.1, 2.5e9, 43, 43}, oil, 1e6), DomainError);
    // Air at 20 C, accommodation 0.9 on both sides: 2 * 1.1/0.9 * 2.8 / (0.7 * 2.4) * 68 nm = 0.277 um.
    CHECK(gas_jump(6.8e-8, 0.9, 0.9, 1.4, 0.7) == near(2.77037037e-7, 1e-8));
    CHECK_THROWS_AS((void)gas_jump(6.8e-8, 0, 0.9, 1.4, 0.7), DomainError);
}

TEST_CASE("direct values and films")
{
    CHECK(direct_conductance(250).resistance() == near(0.004, 1e-15));
    CHECK_THROWS_AS((void)direct_conductance(0), DomainError);
    // 50 um of oil: 2800 W/m2/K.
    CHECK(film_conductance(oil, 50e-6).conductance == near(2800, 1e-14));
    CHECK(film_conductance(air, 1e-6).conductance == near(0.026 / 1.37e-6, 1e-14));
    CHECK_FALSE(film_conductance(oil, 5e-3).in_range);
    CHECK_THROWS_AS((void)film_conductance(oil, 0), DomainError);

    // The eccentric journal against the sum over its circumference (periodic, so the sum converges geometrically).
    const double e = 0.8;
    double mean = 0;
    for (int i = 0; i < 400; ++i)
        mean += 0.14 / (40e-6 * (1 + e * std::cos(2 * pi * i / 400))) / 400;
    CHECK(journal_film_conductance(0.14, 40e-6, e).conductance == near(mean, 1e-13));
    CHECK_FALSE(journal_film_conductance(0.14, 40e-6, 0.99).in_range);
    CHECK_THROWS_AS((void)journal_film_conductance(0.14, 40e-6, 1), DomainError);
}

TEST_CASE("helpers of the solids")
{
    CHECK(harmonic_conductivity(41, 46.05) == near(2 * 41 * 46.05 / 87.05, 1e-15));
    CHECK(harmonic_conductivity(30, 30) == near(30, 1e-15));
    CHECK(contact_modulus(210e9, 0.3, 210e9, 0.3) == near(105e9 / 0.91, 1e-14));
    CHECK_THROWS_AS((void)contact_modulus(210e9, 0.7, 210e9, 0.3), DomainError);
}

TEST_CASE("contact spot at rest: circle, capacity of the ellipse by its integral, long ellipse")
{
    CHECK(spot_conductance({1e-3, 1e-3}, 46) == near(4 * 46 * 1e-3, 1e-14));
    // Twice as large at the same shape conducts twice as well; which axis is across does not matter at rest.
    CHECK(spot_conductance({2e-3, 4e-4}, 46) == near(2 * spot_conductance({1e-3, 2e-4}, 46), 1e-14));
    CHECK(spot_conductance({2e-4, 1e-3}, 46) == spot_conductance({1e-3, 2e-4}, 46));
    // K(e)/a = integral of d phi / sqrt(a^2 cos^2 + b^2 sin^2), 0..pi/2, by the trapezoidal rule (periodic).
    const double a = 2e-3;
    const double b = 3e-4;
    double integral = 0;
    for (int i = 0; i < 400; ++i)
        integral += pi / 2 / 400 / std::hypot(a * std::cos(pi * i / 400), b * std::sin(pi * i / 400));
    CHECK(spot_conductance({a, b}, 46) == near(2 * pi * 46 / integral, 1e-12));
    // A roller as long as thick, d = L = 2 a = 20 mm, b = 0.1 mm: ln(2 d/b) / (pi k L), within K's (b/a)^2 term.
    const double roller = pi * 46 * 0.02 / std::log(2 * 0.02 / 1e-4);
    CHECK(spot_conductance({0.01, 1e-4}, 46) == near(roller, 1e-4));
}

TEST_CASE("passing contact spot: the strips summed one by one")
{
    const SolidHeat steel{46, 7850, 460};
    const double a = 2e-3;
    const double b = 2e-4;
    const double v = 3;
    double sum = 0;
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
        const double x = -1 + 2 * (i + 0.5) / n;
        const double length = 2 * b * std::sqrt(1 - x * x);
        const double alpha = 46.0 / (7850 * 460);
        sum += 2 * 46 / std::sqrt(pi * alpha * length / v) * length * 2 * a / n;
    }
    // Midpoint rule with quarter-power ends.
    CHECK(passing_spot_conductance({a, b}, steel, v) == near(sum, 1e-6));
    CHECK(passing_spot_conductance({a, b}, steel, -4 * v) == near(2 * sum, 1e-6));
    CHECK(passing_spot_conductance({a, b}, steel, 0) == 0);
}

TEST_CASE("bearing: elements in parallel, rings and contacts in series")
{
    BearingPath path;
    path.element_diameter = 0.02;
    path.element = path.ring = {46, 7850, 460};
    path.elements.assign(20, {{1e-3, 1e-3}, {2e-3, 2e-3}});
    // Each side 4 k a: inner contacts 20 * 2 k a = 1.84, outer 3.68 W/K.
    const BearingConductance plain = bearing_conductance(path);
    CHECK(plain.inner == near(1.84, 1e-13));
    CHECK(plain.outer == near(3.68, 1e-13));
    CHECK(plain.total == near(1 / (1 / 1.84 + 1 / 3.68), 1e-13));
    CHECK(plain.per_area(0.05).conductance == near(plain.total / 0.05, 1e-15));
    CHECK(plain.in_range);

    BearingPath ringed = path;
    ringed.inner_ring = {0.17, 0.19, 0.042};
    const double shell = std::log(0.19 / 0.17) / (2 * pi * 46 * 0.042);
    CHECK(1 / bearing_conductance(ringed).inner == near(1 / 1.84 + shell, 1e-13));

    BearingPath oiled = path;
    oiled.film_thickness = 1e-6;
    oiled.film_conductivity = 0.14;
    const double one = 1 / (2 * 46 * 1e-3) + 1e-6 / (0.14 * pi * 1e-6);
    CHECK(bearing_conductance(oiled).inner == near(20 / one, 1e-13));

    BearingPath turning = path;
    turning.rolling_speed = 1;
    CHECK(bearing_conductance(turning).total > 2 * plain.total);
    turning.rolling_speed = 1e-9;  // a bearing that hardly turns is one at rest
    CHECK(bearing_conductance(turning).total == near(plain.total, 1e-6));

    path.elements.assign(3, {{1e-3, 3e-3}, {1e-3, 3e-3}});
    CHECK_FALSE(bearing_conductance(path).in_range);
    path.elements.clear();
    CHECK_THROWS_WITH_AS((void)bearing_conductance(path), doctest::Contains("loaded elements"), DomainError);
}
