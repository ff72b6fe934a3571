#include "../record.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numbers>

// Closed solutions of bodies that meet in a film.

using namespace verification;

namespace {

struct BarTarget {
    const char* resistance;
    double conductance;
    double first;
    double second;
    double flux;
};
constexpr BarTarget bar_targets[] = {{"1e-3 m^2 K/W", 1e3, 88.23529, 29.41176, 58823.53},
                                     {"1e-4 m^2 K/W", 1e4, 75, 62.5, 125000},
                                     {"6.01e-6 m^2 K/W", 1 / 6.01e-6, 71.67179, 70.82053, 141641.05}};

const std::string resistance = "joints.contact.interfaces.0.conductance.resistance=";

void check_bars(const SolvedCase& solved, const BarTarget& target, const std::string& mesh, double tolerance = 1e-5)
{
    // The field is linear in either bar, and the two sides of the film uniform: the elements are exact on any meshes.
    const std::string name = std::string("K1 two bars, R = ") + target.resistance + ", " + mesh + ": ";
    const std::string reason = "linear fields are exact; the target has seven digits";
    record({name + "hot side", "closed form", "degC", target.first, tolerance, reason}, solved.side_a());
    record({name + "cold side", "closed form", "degC", target.second, tolerance, reason}, solved.side_b());
    record({name + "flux", "closed form", "W/m2", target.flux, 1e-6 * target.flux, reason},
           target.conductance * (solved.side_a() - solved.side_b()));
}

}  // namespace

TEST_CASE("two bars with a contact: matching meshes")
{
    for (const auto& target : bar_targets)
        check_bars(solve("two-bars", {resistance + target.resistance}), target, "matching meshes");
}

TEST_CASE("two bars with a contact: meshes that do not match")
{
    for (const auto& target : bar_targets)
        check_bars(solve("two-bars",
                         {resistance + target.resistance, "parts.first_bar.size=3 mm", "parts.second_bar.size=2.3 mm"}),
                   target, "meshes that do not match");
}

TEST_CASE("two bars with a contact: hexahedra against tetrahedra")
{
    check_bars(solve("two-bars", {"parts.second_bar.tetrahedra=true", "parts.second_bar.size=4 mm"}), bar_targets[0],
               "hexahedra against tetrahedra");
    check_bars(solve("two-bars", {"parts.first_bar.tetrahedra=true", "parts.second_bar.tetrahedra=true",
                                  "parts.second_bar.size=4 mm", "numerics.order=2"}),
               bar_targets[0], "tetrahedra of second order");
}

TEST_CASE("two bars with a contact: elements of first against second order, of either shape")
{
    for (const bool tetrahedra : {false, true})
        for (const std::string bar : {"first", "second"})
            // The contact's points integrate products of second degree on triangles: not quite the traces of
            // second-order hexahedra, of fourth degree, which leaves 3e-5 K.
            check_bars(solve("two-bars", {std::string("parts.second_bar.tetrahedra=") + (tetrahedra ? "true" : "false"),
                                          "parts.second_bar.size=4 mm", "parts." + bar + "_bar.order=2"}),
                       bar_targets[0],
                       "the " + bar + " of second order" + (tetrahedra ? ", the second of tetrahedra" : ""),
                       tetrahedra && bar == "first" ? 1e-4 : 1e-5);
}

TEST_CASE("two bars with a contact: along y and along z")
{
    const auto bars = read("two-bars", {"parts.first_bar.size=3 mm", "parts.second_bar.size=2.3 mm"});
    check_bars(solve(with_axes(bars, {1, 2, 0})), bar_targets[0], "along y");
    check_bars(solve(with_axes(bars, {2, 0, 1})), bar_targets[0], "along z");
    check_bars(solve(with_axes(bars, {1, 0, 2})), bar_targets[0], "along y, mirrored");
}

TEST_CASE("two bars with a contact: sides swapped")
{
    const auto solved =
        solve("two-bars", {"joints.contact.interfaces.0.a=end_of_second", "joints.contact.interfaces.0.b=end_of_first",
                           "parts.second_bar.size=2.3 mm"});
    record({"K1 two bars, sides swapped: cold side", "closed form", "degC", bar_targets[0].second, 1e-5,
            "linear fields are exact; the target has seven digits"},
           solved.side_a());
    CHECK(std::abs(solved.side_b() - bar_targets[0].first) < 1e-5);
}

TEST_CASE("a film that conducts nothing parts the bars, a perfect one joins them")
{
    const auto parted = solve("two-bars", {resistance + "1e9 m^2 K/W", "parts.second_bar.size=2.3 mm"});
    // Steady long before the end, except for what leaks: h L / k = 2e-13.
    record({"K1 two bars, h -> 0: hot side", "limit", "degC", 100, 1e-6, "h L / k = 2e-13"}, parted.side_a());
    CHECK(std::abs(parted.side_b() - 0) < 1e-6);
    // Exact: (100 k1 + 0 k2) / (k1 + k2); the film takes another 1.4e-5 K.
    const auto joined = solve("two-bars", {resistance + "1e-10 m^2 K/W", "parts.second_bar.size=2.3 mm"});
    record({"K1 two bars, h -> infinity: hot side", "limit", "degC", 500.0 / 7, 1e-4, "1.4e-5 K remain in the film"},
           joined.side_a());
    CHECK(std::abs(joined.side_b() - 500.0 / 7) < 1e-4);
}

namespace {

// Heat through the film of the rings per metre, and the two sides.
void check_rings(const SolvedCase& solved, double tolerance, const std::string& mesh)
{
    const double q = 5000 * 2 * std::numbers::pi * 0.03 * (solved.side_a() - solved.side_b());
    const std::string reason = "chords in place of arcs, logarithm in few cells";
    record({"K3 rings, " + mesh + ": heat per metre", "closed form", "W", 9228.060, 2 * tolerance * 9228.060, reason},
           q);
    record({"K3 rings, " + mesh + ": inner side", "closed form", "degC", 48.089938, 40 * tolerance, reason},
           solved.side_a());
    record({"K3 rings, " + mesh + ": outer side", "closed form", "degC", 38.298663, 40 * tolerance, reason},
           solved.side_b());
    // The contact's area is that of the cylinder, not of its facets.
    CHECK(std::abs(solved.machine.interfaces[0].area / (2 * std::numbers::pi * 0.03 * 0.01) - 1) < 1e-9);
}

}  // namespace

TEST_CASE("two rings with a film: matching meshes")
{
    // Faceted circles: with cells of 2 mm a chord stays (h / r)^2 / 8 = 0.06 to 0.12 % of r inside the arc, and the
    // logarithmic profile over five cells is good to about as much.
    check_rings(solve("two-rings"), 1e-3, "matching meshes");
}

TEST_CASE("two rings with a film: meshes that do not match")
{
    check_rings(solve("two-rings", {"parts.inner_ring.size=1.7 mm", "parts.outer_ring.size=2.9 mm"}), 2e-3,
                "meshes that do not match");
}

TEST_CASE("two rings with a film: the error falls with the square of the cell size")
{
    const auto error = [](const SolvedCase& solved) { return std::abs(solved.side_a() - 48.089938); };
    const double coarse = error(solve("two-rings", {}, 2)), fine = error(solve("two-rings", {}, 1));
    MESSAGE("errors " << coarse << " K and " << fine << " K");
    CHECK(fine < 0.4 * coarse);  // a quarter, less the rounding of cell counts to whole numbers
}

TEST_CASE("two rings with a film: a joint that turns gives the same axisymmetric field")
{
    const auto still = solve("two-rings", {"parts.outer_ring.size=2.9 mm"});
    const auto turning = solve("two-rings", {"parts.outer_ring.size=2.9 mm", "joints.fit.turns_fully=true"});
    check_rings(turning, 2e-3, "turning");
    // Both are axisymmetric but for the facets, whose ripple around the circumference is of second order.
    CHECK(std::abs(turning.side_a() - still.side_a()) < 1e-3);
    CHECK(std::abs(turning.side_b() - still.side_b()) < 1e-3);
}

TEST_CASE("two slabs: interface temperatures over time")
{
    struct Target {
        double time, steel, aluminium;
    };
    constexpr Target targets[] = {{5, 21.314609, 20.247901},
                                  {20, 37.756304, 25.636585},
                                  {80, 46.589610, 28.860730},
                                  {36080, 46.666667, 28.888889}};
    for (const auto& overrides : {std::vector<std::string>{}, {"parts.aluminium_slab.size=0.8 mm"}}) {
        const auto solved = solve("two-slabs", overrides);
        // Cells of 0.5 mm: the front has travelled sqrt(alpha t) = 8 mm at 5 s, (h / 8 mm)^2 of 80 K is 0.3 K at the
        // hot end and a tenth of the local rise of 1 K per hundred here.
        for (const auto& target : targets) {
            CAPTURE(target.time);
            const auto name = "K7 two slabs" + std::string(overrides.empty() ? "" : ", meshes that do not match") +
                              ", " + std::to_string(std::lround(target.time)) + " s: ";
            const std::string reason = "cells of 0.5 mm against a front 8 mm deep";
            record({name + "steel side", "series", "degC", target.steel, 0.005, reason}, solved.side_a(target.time));
            record({name + "aluminium side", "series", "degC", target.aluminium, 0.002, reason},
                   solved.side_b(target.time));
        }
        CHECK(std::abs(solved.side_a() - 46.666667) < 1e-5);  // the steady field is linear: exact
        CHECK(std::abs(solved.side_b() - 28.888889) < 1e-5);
    }
}
