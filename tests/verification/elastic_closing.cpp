#include "../record.hpp"
#include "deadpoint/full/frame/chain_on_mesh.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "elastic_model.hpp"

#include <cmath>

// The displacement field with its joints closed again, against the adjoint.

using namespace deadpoint;
using verification::Elastic;

namespace {

casefile::Case shipped(const std::string& name)
{
    return casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/" + name + "/case.toml")
        .value;
}

/// Mean height by which a surface of a part rises with the deformation and its body's closing motion [m].
double rise_of(Elastic& press, const std::string& surface, const fem::Displacement& displacement,
               const std::vector<RigidMotion>& motions)
{
    auto mean = verification::mean_over(press.machine, surface, 1);
    double rise = press.model.evaluate({mean}, displacement)[0];
    for (const auto& point : mean.points)
        rise += point.weight[1] * rigid_displacement(motions[press.machine.faces[point.face].part], point.position)[1];
    return rise;
}

struct Closed {
    double adjoint = 0;  ///< E_SW by the adjoint [m]
    double gap = 0;      ///< rise of the slide's surface less that of the table's, in the closed field [m]
    double opening = 0;  ///< largest distance of two centres of a joint [m]
};

/// @param shares  of the growth of each crank bearing's play that count
Closed closed_press(const std::string& name, const std::vector<double>& shares)
{
    auto input = shipped(name);
    input.numerics.size *= 1.6;
    Elastic press(input);
    const press::ChainModel chain(input, press.machine);
    REQUIRE(static_cast<std::size_t>(chain.bearings()) == shares.size());
    press.model.support(press::surface_index(press.machine, input.chain->ground_surface));
    const auto adjoints = press.model.adjoints(chain.dimensions);
    const auto field = press.model.interpolate_field([](const Vec3& x) {
        return 293.15 + 20 * std::exp(-std::abs(x[1] + 0.1) / 0.4) + 8 * std::sin(4 * x[0] + 1) + 5 * x[2];
    });
    const auto displacement = press.model.displacement(field, 293.15);
    const auto closing = full::close_joints(press.machine, press.model, chain, displacement, shares);
    return {press.model.apply(full::gap_adjoint(chain, adjoints, shares), field, 293.15),
            rise_of(press, input.chain->slide_surface, displacement, closing.motions) -
                rise_of(press, input.chain->table_surface, displacement, closing.motions),
            closing.opening};
}

}  // namespace

TEST_CASE("the closed displacement field has coincident joint centres and the adjoint's gap")
{
    const auto closed = closed_press("starter", {1, 1});
    REQUIRE(std::abs(closed.adjoint) > 1e-6);
    const double tolerance = 1e-9 * std::abs(closed.adjoint);
    record({"gap of the closed displacement field", "adjoint", "m", closed.adjoint, tolerance,
            "both are the same linear algebra; rounding"},
           closed.gap);
    record({"largest distance of joint centres in the closed displacement field", "closed linkage", "m", 0, tolerance,
            "rounding"},
           closed.opening);
}

TEST_CASE("the closed half of a press has the adjoint's gap where one bearing's play ends before the other's")
{
    const auto closed = closed_press("slider-crank", {0.4, 1});
    REQUIRE(std::abs(closed.adjoint) > 1e-6);
    const double tolerance = 1e-9 * std::abs(closed.adjoint);  // rounding, as above
    CHECK(std::abs(closed.gap - closed.adjoint) <= tolerance);
    CHECK(closed.opening <= tolerance);
}

TEST_CASE("shifts of the frame's pivots move the slide by as much in the sum")
{
    const auto linkage = press::describe_linkage(shipped("jl75g-60"));
    const auto bottom = mechanism::bottom_dead_point(linkage);
    Vec2 sum{};
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        if (linkage.joints[j].body_b == linkage.ground)
            sum = sum + bottom.weight[j];
        if (linkage.joints[j].body_a == linkage.ground)
            sum = sum - bottom.weight[j];
    }
    record({"sensitivities to vertical shifts of crank centre, H and P18: sum", "the whole frame shifted", "", 1, 1e-12,
            "rounding"},
           sum[1]);
}
