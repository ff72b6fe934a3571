#include "deadpoint/full/frame/chain_on_mesh.hpp"

#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/chain_series.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::full {
namespace {

// Where the deformation moves the joints' centres in their bodies.
std::vector<mechanism::CentreShift> shifts(const press::ChainModel& chain, const std::vector<double>& centre_values,
                                           double play)
{
    std::vector<mechanism::CentreShift> result;
    for (std::size_t j = 0; j < chain.linkage.joints.size(); ++j)
        result.push_back(
            {{centre_values[4 * j], centre_values[4 * j + 1]}, {centre_values[4 * j + 2], centre_values[4 * j + 3]}});
    auto& crank = result[chain.description.crank_joint];
    auto& ground =
        chain.linkage.joints[chain.description.crank_joint].body_b == chain.linkage.ground ? crank.in_b : crank.in_a;
    ground = ground + play * chain.description.pressed;
    return result;
}

// Rigid motions of the mechanism's bodies, by part of the machine.
std::vector<RigidMotion> motions_by_part(const Machine& machine, const Linkage& linkage,
                                         const std::vector<PlanarPose>& motion)
{
    std::vector<RigidMotion> result(machine.parts.size());
    for (std::size_t p = 0; p < machine.parts.size(); ++p) {
        const auto body = std::find(linkage.bodies.begin(), linkage.bodies.end(), machine.parts[p].body);
        if (body == linkage.bodies.end() || body - linkage.bodies.begin() == linkage.ground)
            continue;
        const auto& pose = motion[static_cast<std::size_t>(body - linkage.bodies.begin())];
        result[p] = {pose.translation, pose.angle, {0, 0}};
    }
    return result;
}

// Largest distance between the two centres of a joint once the bodies have moved.
double largest_opening(const press::ChainModel& chain, const std::vector<mechanism::CentreShift>& shifts,
                       const std::vector<PlanarPose>& motion)
{
    double largest = 0;
    for (std::size_t j = 0; j < chain.linkage.joints.size(); ++j) {
        const auto& joint = chain.linkage.joints[j];
        const auto moved = [&](int body, const Vec2& shift) {
            const auto& m = motion[body];
            const Vec2& c = joint.centre;
            return shift + m.translation + m.angle * Vec2{-c[1], c[0]};
        };
        const Vec2 opening = moved(joint.body_a, shifts[j].in_a) - moved(joint.body_b, shifts[j].in_b);
        if (joint.kind == LinkageJoint::Kind::revolute)
            largest = std::max(largest, norm(opening));
        else
            largest = std::max(largest, std::abs(dot(opening, Vec2{-joint.direction[1], joint.direction[0]})));
    }
    return largest;
}

}  // namespace

fem::Adjoint gap_adjoint(const press::ChainModel& chain, const std::vector<fem::Adjoint>& adjoints,
                         const std::vector<double>& shares)
{
    fem::Adjoint result = adjoints[drift::gap];
    const auto factors = press::play_factors(chain.figures(), shares);
    for (std::size_t b = 0; b < factors.size(); ++b) {
        const auto& growth = adjoints[drift::dimension_count + b].owned;
        for (std::size_t i = 0; i < growth.size(); ++i)
            result.owned[i] += factors[b] * growth[i];
    }
    result.name = "E_SW";
    return result;
}

std::vector<double> play_growths(const press::ChainModel& chain, fem::Model& model,
                                 const std::vector<fem::Adjoint>& adjoints, const fem::Field& field, double reference)
{
    std::vector<double> growths;
    for (int b = 0; b < chain.bearings(); ++b)
        growths.push_back(
            model.apply(adjoints[static_cast<std::size_t>(drift::dimension_count + b)], field, reference));
    return growths;
}

std::vector<double> play_growths(const press::ChainModel& chain, fem::Model& model,
                                 const fem::Displacement& displacement)
{
    return model.evaluate({chain.dimensions.begin() + drift::dimension_count, chain.dimensions.end()}, displacement);
}

Closing close_joints(const Machine& machine, fem::Model& model, const press::ChainModel& chain,
                     const fem::Displacement& displacement, const std::vector<double>& shares)
{
    const auto centres = model.evaluate(chain.centres, displacement);
    const auto growths = play_growths(chain, model, displacement);
    const double gap =
        model.evaluate({chain.dimensions[drift::gap]}, displacement)[0] + chain.play_travel(shares, growths);
    const auto moved = shifts(chain, centres, press::mean_play(shares, growths));
    const auto motion = chain.system.closing_motion(chain.system.assembled(), moved);
    return {motions_by_part(machine, chain.linkage, motion), gap, largest_opening(chain, moved, motion)};
}

}  // namespace deadpoint::full
