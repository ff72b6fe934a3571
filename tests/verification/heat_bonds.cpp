/// Requirement: a bond with a conductance passes heat as a series of resistances does, whatever the meshes of its two
/// sides; without resistance it is a perfect bond, without conductance it insulates.
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

using namespace deadpoint;
using namespace verification;

namespace {

// Values of tests/verification/cases/bolted-bars.toml.
constexpr double flux = 2000, film = 100, conductivity = 45, bond = 3000;  // [W/m2], [W/m2/K], [W/m/K], [W/m2/K]
constexpr double lower = 0.1, upper = 0.15, area = 0.04 * 0.05;            // [m], [m2]

std::vector<std::string> with_bond(const std::string& conductance)
{
    return {"bonds.bolts.conductance=" + conductance};
}

/// Resistances in series under a flux q: T = T_air + q (1 / h_air + L / k + 1 / h + ...).
void check_series(const std::vector<std::string>& overrides, const std::string& meshes)
{
    const auto solved = solve("bolted-bars", overrides);
    REQUIRE(solved.machine.interfaces.size() == 1);
    CHECK(solved.machine.interfaces[0].name == "lower|upper");
    CHECK(solved.machine.bonds.size() == 1);
    const double top = 20 + flux / film, above = top + flux * upper / conductivity, below = above + flux / bond;
    // Fields that are linear in either part lie in the elements; what remains is the linear solver's.
    double worst = 0;
    for (const auto& [probe, exact] : {std::pair{"top", top}, std::pair{"above", above}, std::pair{"below", below},
                                       std::pair{"bottom", below + flux * lower / conductivity}})
        worst = std::max(worst, std::abs(solved.probe(probe) - exact));
    CAPTURE(meshes);
    CHECK(worst < 1e-8);
    CHECK(solved.side_a() - solved.side_b() == near(flux / bond, 1e-8));
    // What enters below crosses the bond and leaves above.
    CHECK(bond * area * (solved.side_a() - solved.side_b()) == near(flux * area, 1e-8));
    REQUIRE(solved.result.bonds.size() == 1);
    CHECK(solved.result.bonds[0].history.back() == near(flux * area, 1e-8));
    CHECK(solved.history().to_air.back() == near(flux * area, 1e-8));
}

}  // namespace

TEST_CASE("a bond with a conductance is a resistance in series, on meshes that match and on others")
{
    check_series({}, "meshes that do not match");
    check_series({"parts.lower.size=10 mm", "parts.upper.size=10 mm"}, "meshes that match");
    check_series({"parts.upper.tetrahedra=true", "numerics.order=2"}, "hexahedra on tetrahedra, second order");
}

TEST_CASE("a bond without resistance is a perfect bond")
{
    const auto perfect = solve([] {
        auto input = read("bolted-bars");
        input.bonds.clear();
        return input;
    }());
    CHECK(perfect.machine.interfaces.empty());
    for (const double h : {1e5, 1e7}) {
        const auto close = solve("bolted-bars", with_bond("{ value = \"" + std::to_string(h) + " W/m^2/K\" }"));
        const double jump = flux / h;
        CHECK(close.probe("above") == near(perfect.probe("above"), 1e-9));
        CHECK(close.probe("below") - perfect.probe("below") == near(jump, 1e-4));
    }
}

TEST_CASE("no heat passes an open bond")
{
    auto overrides = with_bond("{ value = \"0 W/m^2/K\" }");
    overrides.emplace_back("operation.0.duration=1 h");
    const auto solved = solve("bolted-bars", overrides);
    CHECK(solved.machine.interfaces.empty());
    REQUIRE(solved.machine.bonds.size() == 1);  // they still move together
    CHECK(solved.probe("above") == near(20, 1e-9));
    CHECK(solved.probe("top") == near(20, 1e-9));
    const auto part = solved.machine.parts[0].name == "lower" ? 0U : 1U;
    CHECK(solved.history().part_means[part].value.back() - zero_celsius ==
          near(20 + flux * 3600 / (7850 * 460 * lower), 1e-9));
}

TEST_CASE("the conductance of a bond may be a resistance, two sides or a law")
{
    const double by_value = solve("bolted-bars").probe("below");
    CHECK(solve("bolted-bars", with_bond("{ resistance = \"3.3333333333e-4 m^2 K/W\" }")).probe("below") ==
          near(by_value, 1e-9));
    CHECK(solve("bolted-bars", with_bond("{ side_a = \"4000 W/m^2/K\", side_b = \"12000 W/m^2/K\" }")).probe("below") ==
          near(by_value, 1e-9));
    // A film of oil: k / d = 0.14 / 50e-6 = 2800 W/m2/K.
    const auto oil = solve(
        "bolted-bars", with_bond("{ law = \"oil_film\", fluid_conductivity = \"0.14 W/m/K\", thickness = \"50 um\" }"));
    CHECK(oil.side_a() - oil.side_b() == near(flux / 2800, 1e-8));
    // Cooper, Mikic and Yovanovich without gas: h = 1.25 k m / s (P / H)^0.95.
    const auto rough = solve("bolted-bars", with_bond("{ law = \"cooper_mikic_yovanovich\", roughness = \"2 um\", "
                                                      "slope = 0.15, hardness = \"2.5 GPa\", pressure = \"5 MPa\", "
                                                      "fluid_conductivity = \"1e-9 W/m/K\" }"));
    const double h = 1.25 * conductivity * 0.15 / 2e-6 * std::pow(5e6 / 2.5e9, 0.95);
    CHECK(rough.side_a() - rough.side_b() == near(flux / h, 1e-5));  // 1e-9 W/m/K remain in the gap
}

TEST_CASE("a reduced run has the conductance of a bond as a parameter")
{
    Observer silent;
    const auto input = read("bolted-bars", {"operation.0.duration=4 h"});
    full::Press press(input);
    full::ReduceOptions options;
    options.build.sets = options.build.training_runs = 12;
    options.build.test_runs = 2;
    const auto reduced = press.reduce(options, silent).value().small;
    for (const char* value : {"3000", "5000"}) {
        const auto changed = read("bolted-bars", {"operation.0.duration=4 h", "bonds.bolts.conductance={ value = \"" +
                                                                                  std::string(value) + " W/m^2/K\" }"});
        const auto full = solve(changed);
        const auto small = twin::run_reduced(changed, reduced, {}, twin::ReducedDetail::figures, silent);
        // The error that the model states for its box, at most a twentieth of a kelvin.
        for (std::size_t probe = 0; probe < full.history().probes.size(); ++probe)
            CHECK(std::abs(small.thermal.probes.at(probe).value.back() - full.history().probes[probe].value.back()) <
                  0.05);
    }
}
