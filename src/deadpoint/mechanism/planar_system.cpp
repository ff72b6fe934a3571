#include "deadpoint/mechanism/planar_system.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/mechanism/planar_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::mechanism {
namespace {

void check_indices(const Linkage& linkage)
{
    const int bodies = static_cast<int>(linkage.bodies.size());
    const auto is_body = [&](int index) { return index >= 0 && index < bodies; };
    if (!is_body(linkage.ground) || !is_body(linkage.slide_body))
        throw InputError("linkage: the ground or the slide is not one of its bodies");
    if (linkage.slide_body == linkage.ground)
        throw InputError(fmt::format("linkage: '{}' is both ground and slide", linkage.bodies[linkage.ground]));
    Mistakes mistakes;
    for (const LinkageJoint& joint : linkage.joints) {
        const std::string path = "joints." + joint.name;
        if (!is_body(joint.body_a) || !is_body(joint.body_b) || joint.body_a == joint.body_b)
            mistakes.add(path, fmt::format("joint '{}' must connect two different bodies of the linkage", joint.name));
        if (!is_finite(joint.centre) || !is_finite(joint.direction))
            mistakes.add(path, fmt::format("joint '{}': its centre or direction is not finite", joint.name));
        if (joint.kind == LinkageJoint::Kind::slide && !(norm(joint.direction) > 0))
            mistakes.add(path + ".direction", fmt::format("joint '{}' has no direction of travel", joint.name));
    }
    mistakes.raise();
    if (!is_finite(linkage.stroke_direction) || !(norm(linkage.stroke_direction) > 0))
        throw InputError("linkage: the stroke has no direction");
    if (linkage.driver < 0 || linkage.driver >= static_cast<int>(linkage.joints.size()))
        throw InputError("linkage: no joint is the driver; mark the crank's bearing with driver = true");
    const LinkageJoint& driver = linkage.joints[linkage.driver];
    if (driver.kind != LinkageJoint::Kind::revolute ||
        (driver.body_a != linkage.ground && driver.body_b != linkage.ground))
        throw InputError(fmt::format("the driver '{}' must be a revolute joint on the ground '{}'", driver.name,
                                     linkage.bodies[linkage.ground]));
}

void check_bodies_held(const Linkage& linkage)
{
    std::vector<std::string> loose;
    for (int body = 0; body < static_cast<int>(linkage.bodies.size()); ++body) {
        const bool held = std::any_of(linkage.joints.begin(), linkage.joints.end(), [&](const LinkageJoint& joint) {
            return joint.body_a == body || joint.body_b == body;
        });
        if (!held)
            loose.push_back("'" + linkage.bodies[body] + "'");
    }
    if (!loose.empty())
        throw InputError(
            fmt::format("held by no joint: {}; connect it, or leave it out of the linkage", fmt::join(loose, ", ")));
}

double extent(const Linkage& linkage)
{
    double largest = 0;
    for (const LinkageJoint& joint : linkage.joints)
        largest = std::max(largest, norm(joint.centre - linkage.joints.front().centre));
    return largest > 0 ? largest : 1.0;
}

}  // namespace

Vec2 place(const PlanarPose& pose, const Vec2& point) { return rotated(point, pose.angle) + pose.translation; }

Vec2 velocity_of(const PlanarPose& pose, const PlanarPose& velocity, const Vec2& point)
{
    return velocity.translation + velocity.angle * turned(rotated(point, pose.angle));
}

Vec2 acceleration_of(const PlanarPose& pose, const PlanarPose& velocity, const PlanarPose& acceleration,
                     const Vec2& point)
{
    const Vec2 arm = rotated(point, pose.angle);
    return acceleration.translation + acceleration.angle * turned(arm) - velocity.angle * velocity.angle * arm;
}

PlanarLoad load_of(const PlanarPose& pose, const Vec2& force, const Vec2& point)
{
    return {force, dot(turned(point - pose.translation), force)};
}

PlanarMotion motion_at(const PlanarPosition& position, double speed, double acceleration)
{
    PlanarMotion result{position.poses, position.slopes, position.curvatures};
    for (std::size_t body = 0; body < position.poses.size(); ++body) {
        const PlanarPose& slope = position.slopes[body];
        const PlanarPose& curvature = position.curvatures[body];
        result.velocities[body] = {speed * slope.translation, speed * slope.angle};
        result.accelerations[body] = {speed * speed * curvature.translation + acceleration * slope.translation,
                                      speed * speed * curvature.angle + acceleration * slope.angle};
    }
    return result;
}

PlanarSystem::PlanarSystem(const Linkage& linkage)
{
    layout_.linkage = linkage;
    check_indices(layout_.linkage);
    check_bodies_held(layout_.linkage);
    layout_.length = extent(layout_.linkage);
    const LinkageJoint& driver = layout_.linkage.joints[layout_.linkage.driver];
    layout_.driven_body = driver.body_a == layout_.linkage.ground ? driver.body_b : driver.body_a;
    for (int body = 0; body < static_cast<int>(layout_.linkage.bodies.size()); ++body) {
        layout_.first_unknown.push_back(body == layout_.linkage.ground ? -1 : layout_.unknowns);
        if (body != layout_.linkage.ground)
            layout_.unknowns += 3;
    }
    for (const LinkageJoint& joint : layout_.linkage.joints) {
        layout_.first_equation.push_back(layout_.equations);
        layout_.equations += equations_of(joint);
    }
    ++layout_.equations;  // the driver's equation

    const std::vector<PlanarPose> start = assembled();
    const PlanarAlgebra algebra{layout_, start};
    const PlanarAlgebra::Fault fault = algebra.fault(algebra.jacobian());
    if (!fault.text.empty())
        throw InputError(
            fmt::format("the joints do not determine the linkage: {}\n  help: {}", fault.text, fault.help));
}

std::vector<PlanarPose> PlanarSystem::assembled() const { return layout_.assembled(); }

PlanarPosition PlanarSystem::position(std::vector<PlanarPose> poses) const
{
    return PlanarWalk{layout_}.located(std::move(poses));
}

PlanarPosition PlanarSystem::moved(const PlanarPosition& from, double to) const
{
    if (!std::isfinite(to))
        throw InputError("linkage: the driver's angle is not finite");
    const PlanarWalk walk{layout_};
    PlanarPosition result = walk.furthest(from, to);
    if (result.angle != to)
        throw InputError(walk.obstacle(result, to));
    return result;
}

std::vector<PlanarPose> PlanarSystem::follow(std::vector<PlanarPose> poses, double from, double to,
                                             std::span<const CentreShift> shifts) const
{
    const PlanarWalk walk{layout_, shifts};
    const PlanarAlgebra algebra{layout_, poses, shifts};
    const auto lu = algebra.factorised(algebra.jacobian(), from);
    if (!walk.close(poses, from, lu))
        throw InputError("the linkage cannot close with its joint centres shifted this far; check the shifts");
    const PlanarPosition result = walk.furthest(walk.located(std::move(poses)), to);
    if (std::abs(result.angle - to) > 1e-12)
        throw InputError(walk.obstacle(result, to));
    return result.poses;
}

std::vector<PlanarPose> PlanarSystem::closing_motion(const std::vector<PlanarPose>& poses,
                                                     std::span<const CentreShift> shifts) const
{
    const PlanarAlgebra closed{layout_, poses};
    const PlanarAlgebra opened{layout_, poses, shifts};
    const double angle = poses[layout_.driven_body].angle;
    const Eigen::VectorXd opening = opened.residual(angle) - closed.residual(angle);
    return closed.spread(closed.factorised(closed.jacobian(), angle).solve(-opening));
}

PlanarMotion PlanarSystem::motion(const std::vector<PlanarPose>& poses, double speed, double acceleration) const
{
    return motion_at(position(poses), speed, acceleration);
}

PlanarReactions PlanarSystem::reactions(const PlanarPosition& position, std::span<const PlanarLoad> loads) const
{
    Eigen::VectorXd q(layout_.unknowns);
    for (std::size_t body = 0; body < loads.size(); ++body) {
        const int k = layout_.first_unknown[body];
        if (k >= 0)
            q.segment<3>(k) << loads[body].force[0], loads[body].force[1], loads[body].moment;
    }
    const Eigen::VectorXd lambda = position.factors->lu.transpose().solve(q);

    PlanarReactions result;
    const PlanarAlgebra algebra{layout_, position.poses};
    for (int j = 0; j < algebra.joints(); ++j) {
        const int row = layout_.first_equation[j];
        const LinkageJoint& joint = layout_.linkage.joints[j];
        const bool revolute = joint.kind == LinkageJoint::Kind::revolute;
        result.force.push_back(revolute ? Vec2{-lambda[row], -lambda[row + 1]} : -lambda[row] * algebra.at(j).normal);
        result.moment.push_back(!revolute && joint.guides_rotation ? -lambda[row + 1] : 0.0);
    }
    result.drive_torque = -lambda[layout_.equations - 1];
    return result;
}

Vec2 PlanarSystem::joint_centre(int joint, const std::vector<PlanarPose>& poses) const
{
    return place(poses[layout_.linkage.joints[joint].body_a], layout_.linkage.joints[joint].centre);
}

Vec2 PlanarSystem::slide_point() const
{
    Vec2 sum{};
    int count = 0;
    for (const LinkageJoint& joint : layout_.linkage.joints) {
        if (joint.body_a != layout_.linkage.slide_body && joint.body_b != layout_.linkage.slide_body)
            continue;
        if (joint.kind == LinkageJoint::Kind::slide)
            return joint.centre;
        sum = sum + joint.centre;
        ++count;
    }
    return (1.0 / count) * sum;
}

std::vector<Vec2> PlanarSystem::slide_weights(const std::vector<PlanarPose>& poses) const
{
    const PlanarAlgebra algebra{layout_, poses};
    const Vec2 stroke = (1.0 / norm(layout_.linkage.stroke_direction)) * layout_.linkage.stroke_direction;
    const int slide = layout_.first_unknown[layout_.linkage.slide_body];
    Eigen::VectorXd by_unknowns = Eigen::VectorXd::Zero(layout_.unknowns);
    by_unknowns[slide] = stroke[0];
    by_unknowns[slide + 1] = stroke[1];
    by_unknowns[slide + 2] = dot(stroke, turned(rotated(slide_point(), poses[layout_.linkage.slide_body].angle)));

    // Shifts d_a and d_b open the constraints by d_a - d_b, so J dq = d_b - d_a and d(stroke) = lambda . (d_b - d_a).
    const Eigen::VectorXd lambda =
        algebra.factorised(algebra.jacobian().transpose(), poses[layout_.driven_body].angle).solve(by_unknowns);
    std::vector<Vec2> weights;
    for (int j = 0; j < static_cast<int>(layout_.linkage.joints.size()); ++j) {
        const int row = layout_.first_equation[j];
        const bool revolute = layout_.linkage.joints[j].kind == LinkageJoint::Kind::revolute;
        weights.push_back(revolute ? Vec2{lambda[row], lambda[row + 1]} : lambda[row] * algebra.at(j).normal);
    }
    return weights;
}

}  // namespace deadpoint::mechanism
