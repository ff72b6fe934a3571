#include "deadpoint/mechanism/planar_algebra.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/planar_layout.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::mechanism {
namespace {

// Reciprocal condition number below which reactions are meaningless; real presses stay above 1e-3.
constexpr double smallest_condition = 1e-8;

}  // namespace

Vec2 rotated(const Vec2& v, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

int equations_of(const LinkageJoint& joint)
{
    return joint.kind == LinkageJoint::Kind::revolute || joint.guides_rotation ? 2 : 1;
}

PlanarAlgebra::Joint PlanarAlgebra::at(int index) const
{
    const LinkageJoint& joint = layout.linkage.joints[index];
    const CentreShift shift = shifts.empty() ? CentreShift{} : shifts[index];
    const PlanarPose& a = poses[joint.body_a];
    const PlanarPose& b = poses[joint.body_b];
    const Vec2 arm_a = rotated(joint.centre + shift.in_a, a.angle);
    const Vec2 arm_b = rotated(joint.centre + shift.in_b, b.angle);
    const Vec2 across = turned((1.0 / norm(joint.direction)) * joint.direction);
    return {joint, a, b, arm_a, arm_b, arm_a + a.translation - arm_b - b.translation, rotated(across, b.angle)};
}

Eigen::VectorXd PlanarAlgebra::residual(double driver_angle) const
{
    Eigen::VectorXd r(layout.equations);
    for (int j = 0; j < joints(); ++j) {
        const Joint joint = at(j);
        const int row = layout.first_equation[j];
        if (joint.joint.kind == LinkageJoint::Kind::revolute) {
            r[row] = joint.open[0];
            r[row + 1] = joint.open[1];
        } else {
            r[row] = dot(joint.normal, joint.open);
            if (joint.joint.guides_rotation)
                r[row + 1] = joint.a.angle - joint.b.angle;
        }
    }
    r[layout.equations - 1] = poses[layout.driven_body].angle - driver_angle;
    return r;
}

Eigen::MatrixXd PlanarAlgebra::jacobian() const
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(layout.equations, layout.unknowns);
    for (int j = 0; j < joints(); ++j) {
        const Joint joint = at(j);
        fill(matrix, layout.first_equation[j], joint, true);
        fill(matrix, layout.first_equation[j], joint, false);
    }
    matrix(layout.equations - 1, layout.first_unknown[layout.driven_body] + 2) = 1;
    return matrix;
}

void PlanarAlgebra::fill(Eigen::MatrixXd& matrix, int row, const Joint& joint, bool first) const
{
    const int column = layout.first_unknown[first ? joint.joint.body_a : joint.joint.body_b];
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

Eigen::VectorXd PlanarAlgebra::gamma(const std::vector<PlanarPose>& v, double driver_acceleration) const
{
    Eigen::VectorXd g = Eigen::VectorXd::Zero(layout.equations);
    for (int j = 0; j < joints(); ++j) {
        const Joint joint = at(j);
        const int row = layout.first_equation[j];
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
    g[layout.equations - 1] = driver_acceleration;
    return g;
}

std::vector<PlanarPose> PlanarAlgebra::spread(const Eigen::VectorXd& q) const
{
    std::vector<PlanarPose> result(poses.size());
    for (std::size_t body = 0; body < poses.size(); ++body) {
        const int k = layout.first_unknown[body];
        if (k >= 0)
            result[body] = {{q[k], q[k + 1]}, q[k + 2]};
    }
    return result;
}

double PlanarAlgebra::opening(int index) const
{
    const Joint joint = at(index);
    return joint.joint.kind == LinkageJoint::Kind::revolute ? norm(joint.open)
                                                            : std::abs(dot(joint.normal, joint.open));
}

Eigen::PartialPivLU<Eigen::MatrixXd> PlanarAlgebra::factorised(const Eigen::MatrixXd& matrix, double driver_angle) const
{
    Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix);
    // A small pivot is a cheap indication; only then is the condition number estimated.
    const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
    const bool suspect = !(pivots.minCoeff() > 1e-6 * pivots.maxCoeff());
    if (suspect && !(lu.rcond() > smallest_condition))
        throw InputError(fmt::format("the linkage is singular {:.3f} degrees from its assembled position: {}\n  help: "
                                     "change the lengths so that the links do not line up there",
                                     driver_angle * 180.0 / std::numbers::pi, fault(matrix, 1).text));
    return lu;
}

}  // namespace deadpoint::mechanism
