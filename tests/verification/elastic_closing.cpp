#include "../record.hpp"
#include "deadpoint/study/chain_model.hpp"
#include "deadpoint/study/translate_linkage.hpp"
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

}  // namespace

TEST_CASE("the closed displacement field has coincident joint centres and the adjoint's gap")
{
    auto input = shipped("starter");
    input.numerics.size *= 1.6;
    Elastic press(input);
    const study::ChainModel chain(input, press.machine);
    press.model.support(study::surface_index(press.machine, input.chain->ground_surface));
    const auto adjoints = press.model.adjoints(chain.dimensions);
    const auto field = press.model.interpolate_field([](const Vec3& x) {
        return 293.15 + 20 * std::exp(-std::abs(x[1] + 0.1) / 0.4) + 8 * std::sin(4 * x[0] + 1) + 5 * x[2];
    });
    const auto displacement = press.model.displacement(field, 293.15);
    const std::vector<double> shares(static_cast<std::size_t>(chain.bearings()), 1.0);
    const auto closing = study::close_joints(press.machine, press.model, chain, displacement, shares);
    const double adjoint = press.model.apply(study::gap_adjoint(chain, adjoints, shares), field, 293.15);
    REQUIRE(std::abs(adjoint) > 1e-6);
    record({"gap of the closed displacement field", "adjoint", "m", adjoint, 1e-9 * std::abs(adjoint),
            "both are the same linear algebra; rounding"},
           rise_of(press, input.chain->slide_surface, displacement, closing.motions) -
               rise_of(press, input.chain->table_surface, displacement, closing.motions));
    record({"largest distance of joint centres in the closed displacement field", "closed linkage", "m", 0,
            1e-9 * std::abs(adjoint), "rounding"},
           closing.opening);
}

TEST_CASE("shifts of the frame's pivots move the slide by as much in the sum")
{
    const auto linkage = study::describe_linkage(shipped("jl75g-60"));
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
