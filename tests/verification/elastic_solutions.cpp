#include "../record.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "elastic_model.hpp"
#include "near.hpp"

#include <cmath>

using namespace deadpoint;
using verification::Elastic;
using verification::mean_over;

namespace {

Observer silent;

}  // namespace

TEST_CASE("a free bar of two bonded blocks stretches by alpha dT L")
{
    Elastic bar(verification::read("bar"));
    const auto top = mean_over(bar.machine, "top", 1);
    const auto bottom = mean_over(bar.machine, "bottom", 1);
    const auto u = bar.values("", bar.model.constant_field(293.15 + 50), {top, bottom});
    // 1.04 m with the caps; exact in the finite-element space and through the ties, so only rounding remains
    record({"free bar, 50 K: stretch of 1.04 m", "alpha dT L", "m", 1.2e-5 * 50 * 1.04, 1e-9 * 6.24e-4,
            "linear displacements are exact through ties too; rounding"},
           u[0] - u[1]);
    // free of supports: the mean displacement is zero, so both ends move apart evenly
    CHECK(u[0] == near(-u[1], 1e-6));
}

TEST_CASE("a free bar whose parts have elements of different order and shape stretches alike")
{
    for (const char* order : {"parts.lower.order=2", "parts.upper.order=2"})
        for (const char* shape : {"parts.upper.tetrahedra=false", "parts.upper.tetrahedra=true"}) {
            CAPTURE(order);
            CAPTURE(shape);
            Elastic bar(verification::read("bar", {order, shape}));
            const auto u = bar.values("", bar.model.constant_field(293.15 + 50),
                                      {mean_over(bar.machine, "top", 1), mean_over(bar.machine, "bottom", 1)});
            CHECK(u[0] - u[1] == near(1.2e-5 * 50 * 1.04, 1e-9));
        }
}

TEST_CASE("a bar clamped at both ends is stressed by -126 MPa and bulges by (1 + nu) alpha dT")
{
    Elastic bar(verification::read("bar"));
    // Caps held in height at all their faces; the bar between them is a uniaxial state away from nothing: u_y = 0.
    const auto u = bar.values("both_caps", bar.model.constant_field(293.15 + 50),
                              {mean_over(bar.machine, "right_side", 0), mean_over(bar.machine, "left_side", 0),
                               mean_over(bar.machine, "right_side", 1)});
    const double lateral = (u[0] - u[1]) / 0.1;
    // Ties carry a uniform stress exactly, so only the solver remains.
    CHECK(lateral == near(1.3 * 1.2e-5 * 50, 1e-8));
    CHECK(std::abs(u[2]) < 1e-8 * 1.2e-5 * 50);
    const double youngs = 210e9, poisson = 0.3, free_strain = 1.2e-5 * 50;
    // Hooke with strain_y = 0 and equal strains across: sigma_y from both lateral strains
    const double bulk = youngs / ((1 + poisson) * (1 - 2 * poisson));
    const double stress = bulk * (2 * poisson * lateral) - youngs / (1 - 2 * poisson) * free_strain;
    record({"clamped bar, 50 K: stress from the bulging", "E alpha dT", "Pa", -126e6, 1.3,
            "a uniform stress passes ties between meshes that do not match exactly; solver"},
           stress);
}

namespace {

void check_adjoint(const std::vector<std::string>& overrides)
{
    Elastic bar(verification::read("bar", overrides));
    const auto field = bar.model.interpolate_field(
        [](const Vec3& x) { return 293.15 + 40 * x[0] / 0.1 * x[1] + 30 * std::sin(9 * x[2]); });
    auto stretch = mean_over(bar.machine, "top", 1);
    drift::add(stretch, -1, mean_over(bar.machine, "bottom", 1));
    const auto direct = bar.values("", field, {stretch});
    const auto adjoint = bar.model.adjoints({stretch});
    // both are the same linear algebra, solved to 1e-10
    CHECK(bar.model.apply(adjoint[0], field, 293.15) == near(direct[0], 1e-9));
}

}  // namespace

TEST_CASE("adjoint and direct deformation agree on a field that bends the bar")
{
    check_adjoint({});
    check_adjoint({"parts.upper.order=2", "parts.lower.tetrahedra=true"});
}

TEST_CASE("warming the whole press evenly opens the gap by alpha dT L_SW")
{
    std::vector<std::string> overrides;
    for (const char* material : {"40Cr", "45", "HT200", "HT300", "QT600-3"})
        overrides.push_back(std::string("materials.") + material + ".expansion=1.1e-5 1/K");
    const auto input =
        casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/jl75g-60/case.toml", overrides)
            .value;
    const auto machine = full::prepare_machine(input, 2.5, silent);
    const auto linkage = press::describe_linkage(input);
    const auto sensitivity = mechanism::bottom_dead_point(linkage);
    const auto chain = press::describe_chain(input, machine, linkage);
    const auto dimensions = drift::chain_functionals(machine, linkage, sensitivity, chain);
    fem::Model model(machine, press::describe_materials(input, machine), 1, silent);
    model.support(press::surface_index(machine, input.chain->ground_surface));
    const auto adjoints = model.adjoints(dimensions);
    const auto warm = model.constant_field(293.15 + 10);
    const auto value = [&](drift::Dimension d) { return model.apply(adjoints[d], warm, 293.15); };
    const double per_metre = 1.1e-5 * 10;
    // A uniform expansion is a linear displacement, which elements, ties and circle fits reproduce: what is left is
    // coordinates that the case rounds to 0.1 um, and the solver.
    CHECK(value(drift::gap) == near(per_metre * 0.3, 1e-5));
    CHECK(value(drift::bearing_to_ground) == near(per_metre * 2.7134324, 1e-6));
    CHECK(value(drift::table_to_ground) == near(per_metre * 1.005, 1e-6));
    REQUIRE(adjoints.size() == drift::dimension_count + 4);
    for (std::size_t bearing = drift::dimension_count; bearing < adjoints.size(); ++bearing)
        CHECK(std::abs(model.apply(adjoints[bearing], warm, 293.15)) < 1e-6 * per_metre * 0.3);
}

TEST_CASE("a force between the ends of a bar of bonded blocks opens it by L / (E A)")
{
    for (const std::vector<std::string>& changes :
         {std::vector<std::string>{}, {"parts.upper.tetrahedra=true"}, {"parts.lower.order=2"}}) {
        Elastic bar(verification::read("bar", changes));
        auto opening = mean_over(bar.machine, "top", 1);
        drift::add(opening, -1, mean_over(bar.machine, "bottom", 1));
        // A force spread evenly over both ends: a uniform stress, which elements and ties pass exactly.
        const auto under_force = bar.model.deformation_adjoint(opening);
        CHECK(bar.model.evaluate({opening}, under_force)[0] == near(1.04 / (210e9 * 0.1 * 0.08), 1e-7));
    }
}
