#include "deadpoint/mechanism/planar_system.hpp"

#include "deadpoint/core/error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace deadpoint::mechanism {
namespace {

constexpr double longest_step = 2.0 * std::numbers::pi / 180.0;
constexpr double shortest_step = longest_step / 64.0;
constexpr double rank_tolerance = 1e-10;
constexpr double degrees = 180.0 / std::numbers::pi;

Vec2 rotated(const Vec2& v, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

/// A quarter turn counter-clockwise: the derivative of a rotated vector by its angle.
Vec2 turned(const Vec2& v) { return {-v[1], v[0]}; }

int equations_of(const LinkageJoint& joint)
{
    return joint.kind == LinkageJoint::Kind::revolute || joint.guides_rotation ? 2 : 1;
}

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
        if (joint.kind == LinkageJoint::Kind::slide && !(norm(joint.direction) > 0))
            throw InputError(fmt::format("joint '{}' has no direction of travel", joint.name));
    }
    if (!(norm(linkage.stroke_direction) > 0))
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

/// A joint in a given position: the arms from the bodies' origins to its centre, and what they leave open.
struct PlanarSystem::Algebra {
    const PlanarSystem& system;
    const std::vector<PlanarPose>& poses;
    std::span<const CentreShift> shifts = {};

    struct Joint {
        const LinkageJoint& joint;
        const PlanarPose& a;
        const PlanarPose& b;
        Vec2 arm_a;
        Vec2 arm_b;
        Vec2 open;    ///< p_a - p_b
        Vec2 normal;  ///< across the direction of travel
    };

    [[nodiscard]] Joint at(int index) const
    {
        const LinkageJoint& joint = system.linkage_.joints[index];
        const CentreShift shift = shifts.empty() ? CentreShift{} : shifts[index];
        const PlanarPose& a = poses[joint.body_a];
        const PlanarPose& b = poses[joint.body_b];
        const Vec2 arm_a = rotated(joint.centre + shift.in_a, a.angle);
        const Vec2 arm_b = rotated(joint.centre + shift.in_b, b.angle);
        const Vec2 across = turned((1.0 / norm(joint.direction)) * joint.direction);
        return {joint, a, b, arm_a, arm_b, arm_a + a.translation - arm_b - b.translation, rotated(across, b.angle)};
    }

    [[nodiscard]] Eigen::VectorXd residual(double driver_angle) const
    {
        Eigen::VectorXd r(system.equations_);
        for (int j = 0; j < static_cast<int>(system.linkage_.joints.size()); ++j) {
            const Joint joint = at(j);
            const int row = system.first_equation_[j];
            if (joint.joint.kind == LinkageJoint::Kind::revolute) {
                r[row] = joint.open[0];
                r[row + 1] = joint.open[1];
            } else {
                r[row] = dot(joint.normal, joint.open);
                if (joint.joint.guides_rotation)
                    r[row + 1] = joint.a.angle - joint.b.angle;
            }
        }
        r[system.equations_ - 1] = poses[system.driven_body_].angle - driver_angle;
        return r;
    }

    [[nodiscard]] Eigen::MatrixXd jacobian() const
    {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(system.equations_, system.unknowns_);
        for (int j = 0; j < static_cast<int>(system.linkage_.joints.size()); ++j) {
            const Joint joint = at(j);
            fill(matrix, system.first_equation_[j], joint, true);
            fill(matrix, system.first_equation_[j], joint, false);
        }
        matrix(system.equations_ - 1, system.first_unknown_[system.driven_body_] + 2) = 1;
        return matrix;
    }

    void fill(Eigen::MatrixXd& matrix, int row, const Joint& joint, bool first) const
    {
        const int column = system.first_unknown_[first ? joint.joint.body_a : joint.joint.body_b];
        if (column < 0)
            return;
        const double sign = first ? 1 : -1;
        const Vec2 by_angle = turned(first ? joint.arm_a : joint.arm_b);
        if (joint.joint.kind == LinkageJoint::Kind::revolute) {
            for (int k = 0; k < 2; ++k) {
                matrix(row + k, column + k) = sign;
                matrix(row + k, column + 2) = sign * by_angle[k];
            }
            return;
        }
        for (int k = 0; k < 2; ++k)
            matrix(row, column + k) = sign * joint.normal[k];
        matrix(row, column + 2) =
            sign * dot(joint.normal, by_angle) + (first ? 0.0 : dot(turned(joint.normal), joint.open));
        if (joint.joint.guides_rotation)
            matrix(row + 1, column + 2) = sign;
    }

    /// Right-hand side of J q'' = gamma: all terms of the second derivative of the constraints without q''.
    [[nodiscard]] Eigen::VectorXd gamma(const std::vector<PlanarPose>& v, double driver_acceleration) const
    {
        Eigen::VectorXd g = Eigen::VectorXd::Zero(system.equations_);
        for (int j = 0; j < static_cast<int>(system.linkage_.joints.size()); ++j) {
            const Joint joint = at(j);
            const int row = system.first_equation_[j];
            const PlanarPose& va = v[joint.joint.body_a];
            const PlanarPose& vb = v[joint.joint.body_b];
            const Vec2 centripetal = va.angle * va.angle * joint.arm_a - vb.angle * vb.angle * joint.arm_b;
            if (joint.joint.kind == LinkageJoint::Kind::revolute) {
                g[row] = centripetal[0];
                g[row + 1] = centripetal[1];
            } else {
                const Vec2 slip =
                    va.translation + va.angle * turned(joint.arm_a) - vb.translation - vb.angle * turned(joint.arm_b);
                g[row] = dot(joint.normal, centripetal) - 2 * vb.angle * dot(turned(joint.normal), slip) +
                         vb.angle * vb.angle * dot(joint.normal, joint.open);
            }
        }
        g[system.equations_ - 1] = driver_acceleration;
        return g;
    }

    [[nodiscard]] std::vector<PlanarPose> spread(const Eigen::VectorXd& q) const
    {
        std::vector<PlanarPose> result(poses.size());
        for (std::size_t body = 0; body < poses.size(); ++body) {
            const int k = system.first_unknown_[body];
            if (k >= 0)
                result[body] = {{q[k], q[k + 1]}, q[k + 2]};
        }
        return result;
    }

    /// "joint 'x' by 0.3 mm" for the equation that is furthest from closed.
    [[nodiscard]] std::string widest_opening() const
    {
        double widest = 0;
        std::string text = "the driver";
        for (int j = 0; j < static_cast<int>(system.linkage_.joints.size()); ++j) {
            const Joint joint = at(j);
            const double open = joint.joint.kind == LinkageJoint::Kind::revolute
                                    ? norm(joint.open)
                                    : std::abs(dot(joint.normal, joint.open));
            if (open > widest) {
                widest = open;
                text = fmt::format("joint '{}' by {:.4g} mm", joint.joint.name, 1e3 * open);
            }
        }
        return text;
    }

    [[nodiscard]] std::string joints_in(const Eigen::MatrixXd& null_space) const
    {
        std::vector<std::string> names;
        for (std::size_t j = 0; j < system.linkage_.joints.size(); ++j) {
            const LinkageJoint& joint = system.linkage_.joints[j];
            if (null_space.middleRows(system.first_equation_[j], equations_of(joint)).norm() > 1e-6)
                names.push_back("'" + joint.name + "'");
        }
        if (null_space.bottomRows(1).norm() > 1e-6)
            names.emplace_back("the driver");
        return fmt::format("{}", fmt::join(names, ", "));
    }

    [[nodiscard]] std::string bodies_in(const Eigen::MatrixXd& null_space) const
    {
        std::vector<std::string> names;
        for (std::size_t body = 0; body < poses.size(); ++body) {
            const int k = system.first_unknown_[body];
            if (k >= 0 && null_space.middleRows(k, 3).norm() > 1e-6)
                names.push_back("'" + system.linkage_.bodies[body] + "'");
        }
        return fmt::format("{}", fmt::join(names, ", "));
    }

    /// Empty if the constraints determine the position, else what is wrong with them.
    [[nodiscard]] std::string fault(const Eigen::MatrixXd& matrix) const
    {
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const auto& values = svd.singularValues();
        const long rank = (values.array() > rank_tolerance * values[0]).count();
        std::string text;
        if (rank < system.unknowns_)
            text += fmt::format("\n  free to move although the driver is held: {}",
                                bodies_in(svd.matrixV().rightCols(system.unknowns_ - rank)));
        if (rank < system.equations_)
            text += fmt::format("\n  hold the same motion more than once: {}",
                                joints_in(svd.matrixU().rightCols(system.equations_ - rank)));
        if (text.empty())
            return text;
        return fmt::format("{} unknowns, {} equations, rank {}{}", system.unknowns_, system.equations_, rank, text);
    }

    [[nodiscard]] Eigen::PartialPivLU<Eigen::MatrixXd> factorised(const Eigen::MatrixXd& matrix,
                                                                  double driver_angle) const
    {
        Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
        if (!(lu.rcond() > 1e-12))
            throw InputError(fmt::format("the linkage is singular {:.3f} degrees from its assembled position: {}",
                                         driver_angle * degrees, fault(matrix)));
        return lu;
    }
};

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
    const std::string fault = algebra.fault(algebra.jacobian());
    if (fault.empty())
        return;
    const char* remedy = equations_ > unknowns_ ? "remove a joint, or let a slide turn (guides_rotation = false)"
                         : equations_ < unknowns_
                             ? "add the joints or guides that are missing"
                             : "check which joints hold these bodies, or assemble the linkage elsewhere in its turn";
    throw InputError(fmt::format("the joints do not determine the linkage: {}\n  help: {}", fault, remedy));
}

std::vector<PlanarPose> PlanarSystem::assembled() const { return std::vector<PlanarPose>(linkage_.bodies.size()); }

std::vector<PlanarPose> PlanarSystem::follow(std::vector<PlanarPose> poses, double from, double to,
                                             std::span<const CentreShift> shifts) const
{
    const auto close = [&](std::vector<PlanarPose>& guess, double angle) {
        for (int iteration = 0; iteration < 12; ++iteration) {
            const Algebra algebra{*this, guess, shifts};
            const Eigen::VectorXd correction =
                algebra.factorised(algebra.jacobian(), angle).solve(-algebra.residual(angle));
            const std::vector<PlanarPose> delta = algebra.spread(correction);
            for (std::size_t body = 0; body < guess.size(); ++body) {
                guess[body].translation = guess[body].translation + delta[body].translation;
                guess[body].angle += delta[body].angle;
            }
            const double size = correction.lpNorm<Eigen::Infinity>() / length_;
            if (!std::isfinite(size) || size > 1)
                return false;
            if (size < 1e-14 || (iteration > 3 && size < 1e-12))
                return true;
        }
        return false;
    };

    double angle = from;
    double step = longest_step;
    do {
        const double next = std::abs(to - angle) <= step ? to : angle + std::copysign(step, to - angle);
        const Algebra algebra{*this, poses, shifts};
        const Eigen::VectorXd tangent =
            algebra.factorised(algebra.jacobian(), angle).solve(Eigen::VectorXd::Unit(equations_, equations_ - 1));
        const std::vector<PlanarPose> slope = algebra.spread(tangent);
        std::vector<PlanarPose> guess = poses;
        for (std::size_t body = 0; body < guess.size(); ++body) {
            guess[body].translation = guess[body].translation + (next - angle) * slope[body].translation;
            guess[body].angle += (next - angle) * slope[body].angle;
        }
        const std::vector<PlanarPose> predicted = guess;
        if (close(guess, next)) {
            poses = guess;
            angle = next;
            step = longest_step;
        } else if (step > shortest_step) {
            step /= 4;
        } else {
            throw InputError(
                fmt::format("the linkage cannot close {:.2f} degrees from its assembled position: it misses {}; "
                            "check the lengths of the links, or a driver that cannot turn this far",
                            next * degrees, Algebra{*this, predicted, shifts}.widest_opening()));
        }
    } while (angle != to);
    return poses;
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
    const Algebra algebra{*this, poses};
    const auto lu = algebra.factorised(algebra.jacobian(), poses[driven_body_].angle);
    PlanarMotion result;
    result.poses = poses;
    result.velocities = algebra.spread(lu.solve(speed * Eigen::VectorXd::Unit(equations_, equations_ - 1)));
    result.accelerations = algebra.spread(lu.solve(algebra.gamma(result.velocities, acceleration)));
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
