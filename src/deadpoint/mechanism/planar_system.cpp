#include "deadpoint/mechanism/planar_system.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/mechanism/planar_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::mechanism {
namespace {

bool is_finite(const Vec2& v) { return std::isfinite(v[0]) && std::isfinite(v[1]); }

void check_indices(const Linkage& linkage)
{
    const int bodies = static_cast<int>(linkage.bodies.size());
    const auto is_body = [&](int index) { return index >= 0 && index < bodies; };
    if (!is_body(linkage.ground) || !is_body(linkage.slide_body))
        throw InputError("linkage: the ground or the slide is not one of its bodies");
    if (linkage.slide_body == linkage.ground)
        throw InputError(fmt::format("linkage: '{}' is both ground and slide", linkage.bodies[linkage.ground]));
    for (const LinkageJoint& joint : linkage.joints) {
        if (!is_body(joint.body_a) || !is_body(joint.body_b) || joint.body_a == joint.body_b)
            throw InputError(fmt::format("joint '{}' must connect two different bodies of the linkage", joint.name));
        if (!is_finite(joint.centre) || !is_finite(joint.direction))
            throw InputError(fmt::format("joint '{}': its centre or direction is not finite", joint.name));
        if (joint.kind == LinkageJoint::Kind::slide && !(norm(joint.direction) > 0))
            throw InputError(fmt::format("joint '{}' has no direction of travel", joint.name));
    }
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

PlanarSystem::PlanarSystem(const Linkage& linkage) : linkage_(linkage)
{
    check_indices(linkage_);
    check_bodies_held(linkage_);
    length_ = extent(linkage_);
    const LinkageJoint& driver = linkage_.joints[linkage_.driver];
    driven_body_ = driver.body_a == linkage_.ground ? driver.body_b : driver.body_a;
    for (int body = 0; body < static_cast<int>(linkage_.bodies.size()); ++body) {
        first_unknown_.push_back(body == linkage_.ground ? -1 : unknowns_);
        if (body != linkage_.ground)
            unknowns_ += 3;
    }
    for (const LinkageJoint& joint : linkage_.joints) {
        first_equation_.push_back(equations_);
        equations_ += equations_of(joint);
    }
    ++equations_;  // the driver

    const std::vector<PlanarPose> start = assembled();
    const Algebra algebra{*this, start};
    const Algebra::Fault fault = algebra.fault(algebra.jacobian());
    if (!fault.text.empty())
        throw InputError(
            fmt::format("the joints do not determine the linkage: {}\n  help: {}", fault.text, fault.help));
}

std::vector<PlanarPose> PlanarSystem::assembled() const { return std::vector<PlanarPose>(linkage_.bodies.size()); }

PlanarPosition PlanarSystem::position(std::vector<PlanarPose> poses) const
{
    return Walk{*this}.located(std::move(poses));
}

PlanarPosition PlanarSystem::moved(const PlanarPosition& from, double to) const
{
    if (!std::isfinite(to))
        throw InputError("linkage: the driver's angle is not finite");
    const Walk walk{*this};
    PlanarPosition result = walk.furthest(from, to);
    if (result.angle != to)
        throw InputError(walk.obstacle(result, to));
    return result;
}

std::vector<PlanarPose> PlanarSystem::follow(std::vector<PlanarPose> poses, double from, double to,
                                             std::span<const CentreShift> shifts) const
{
    const Walk walk{*this, shifts};
    const Algebra algebra{*this, poses, shifts};
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
    const Algebra closed{*this, poses};
    const Algebra opened{*this, poses, shifts};
    const double angle = poses[driven_body_].angle;
    const Eigen::VectorXd opening = opened.residual(angle) - closed.residual(angle);
    return closed.spread(closed.factorised(closed.jacobian(), angle).solve(-opening));
}

PlanarMotion PlanarSystem::motion(const std::vector<PlanarPose>& poses, double speed, double acceleration) const
{
    return motion_at(position(poses), speed, acceleration);
}

PlanarReactions PlanarSystem::reactions(const PlanarPosition& position, std::span<const PlanarLoad> loads) const
{
    Eigen::VectorXd q(unknowns_);
    for (std::size_t body = 0; body < loads.size(); ++body) {
        const int k = first_unknown_[body];
        if (k >= 0)
            q.segment<3>(k) << loads[body].force[0], loads[body].force[1], loads[body].moment;
    }
    const Eigen::VectorXd lambda = position.factors->lu.transpose().solve(q);

    PlanarReactions result;
    const Algebra algebra{*this, position.poses};
    for (int j = 0; j < algebra.joints(); ++j) {
        const int row = first_equation_[j];
        const LinkageJoint& joint = linkage_.joints[j];
        const bool revolute = joint.kind == LinkageJoint::Kind::revolute;
        result.force.push_back(revolute ? Vec2{-lambda[row], -lambda[row + 1]} : -lambda[row] * algebra.at(j).normal);
        result.moment.push_back(!revolute && joint.guides_rotation ? -lambda[row + 1] : 0.0);
    }
    result.drive_torque = -lambda[equations_ - 1];
    return result;
}

Vec2 PlanarSystem::joint_centre(int joint, const std::vector<PlanarPose>& poses) const
{
    return place(poses[linkage_.joints[joint].body_a], linkage_.joints[joint].centre);
}

Vec2 PlanarSystem::slide_point() const
{
    Vec2 sum{};
    int count = 0;
    for (const LinkageJoint& joint : linkage_.joints) {
        if (joint.body_a != linkage_.slide_body && joint.body_b != linkage_.slide_body)
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
    const Algebra algebra{*this, poses};
    const Vec2 stroke = (1.0 / norm(linkage_.stroke_direction)) * linkage_.stroke_direction;
    const int slide = first_unknown_[linkage_.slide_body];
    Eigen::VectorXd by_unknowns = Eigen::VectorXd::Zero(unknowns_);
    by_unknowns[slide] = stroke[0];
    by_unknowns[slide + 1] = stroke[1];
    by_unknowns[slide + 2] = dot(stroke, turned(rotated(slide_point(), poses[linkage_.slide_body].angle)));

    // Shifts d_a and d_b open the constraints by d_a - d_b, so J dq = d_b - d_a and d(stroke) = lambda . (d_b - d_a).
    const Eigen::VectorXd lambda =
        algebra.factorised(algebra.jacobian().transpose(), poses[driven_body_].angle).solve(by_unknowns);
    std::vector<Vec2> weights;
    for (int j = 0; j < static_cast<int>(linkage_.joints.size()); ++j) {
        const int row = first_equation_[j];
        const bool revolute = linkage_.joints[j].kind == LinkageJoint::Kind::revolute;
        weights.push_back(revolute ? Vec2{lambda[row], lambda[row + 1]} : lambda[row] * algebra.at(j).normal);
    }
    return weights;
}

}  // namespace deadpoint::mechanism
