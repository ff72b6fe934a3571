#include "deadpoint/study/chain_model.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/study/translate_linkage.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::study {
namespace {

// Where the deformation moves the joints' centres in their bodies.
std::vector<mechanism::CentreShift> shifts(const ChainModel& chain, const std::vector<double>& centre_values,
                                           double growth_value)
{
    std::vector<mechanism::CentreShift> result;
    for (std::size_t j = 0; j < chain.linkage.joints.size(); ++j)
        result.push_back(
            {{centre_values[4 * j], centre_values[4 * j + 1]}, {centre_values[4 * j + 2], centre_values[4 * j + 3]}});
    auto& crank = result[chain.description.crank_joint];
    auto& ground =
        chain.linkage.joints[chain.description.crank_joint].body_b == chain.linkage.ground ? crank.in_b : crank.in_a;
    ground = ground + growth_value * chain.description.pressed;
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
double largest_opening(const ChainModel& chain, const std::vector<mechanism::CentreShift>& shifts,
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

ChainModel::ChainModel(const casefile::Case& input, const Machine& machine)
    : linkage(describe_linkage(input)), system(linkage), sensitivity(mechanism::bottom_dead_point(linkage)),
      description(describe_chain(input, machine, linkage)),
      dimensions(drift::chain_functionals(machine, linkage, sensitivity, description))
{
    if (std::abs(sensitivity.crank_angle) > 1e-3)
        throw InputError(
            fmt::format("the case's joints are not placed at bottom dead point: the crank would have to turn by {:.3f} "
                        "degrees to get there; give all coordinates at bottom dead point",
                        sensitivity.crank_angle * 57.29577951308232));
    for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j) {
        auto fitted = drift::joint_centres(machine, linkage, sensitivity, j, description.joints[j]);
        for (auto& centre : {fitted.in_a, fitted.in_b})
            for (const auto& component : centre)
                centres.push_back(component);
    }
    growth = drift::clearance_growth(machine, sensitivity, description);
}

Closing close_joints(const Machine& machine, fem::Model& model, const ChainModel& chain,
                     const fem::Displacement& displacement)
{
    auto wanted = chain.centres;
    wanted.push_back(chain.growth);
    wanted.push_back(chain.dimensions[drift::gap]);
    auto values = model.evaluate(wanted, displacement);
    const double gap = values.back();
    values.pop_back();
    const double growth = values.back();
    values.pop_back();
    const auto moved = shifts(chain, values, growth);
    const auto motion = chain.system.closing_motion(chain.system.assembled(), moved);
    return {motions_by_part(machine, chain.linkage, motion), gap, largest_opening(chain, moved, motion)};
}

DriftSeries drift_series(const ThermalHistory& history)
{
    DriftSeries drift;
    drift.time = history.time;
    const auto& f = history.functionals;
    drift.bearing_to_ground = f[drift::bearing_to_ground];
    drift.table_to_ground = f[drift::table_to_ground];
    drift.clearance = f[drift::clearance];
    drift.gap = f[drift::gap];
    drift.crank_to_slide = f[drift::bearing_to_ground];
    for (auto values : {&Series::value, &Series::rate})
        for (std::size_t i = 0; i < history.time.size(); ++i)
            (drift.crank_to_slide.*values)[i] -= (f[drift::clearance].*values)[i] + (f[drift::slide_height].*values)[i];
    drift.by_part = history.contributions;
    return drift;
}

}  // namespace deadpoint::study
