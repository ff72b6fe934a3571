#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/planar_algebra.hpp"
#include "deadpoint/mechanism/planar_layout.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace deadpoint::mechanism {
namespace {

constexpr double longest_step = 2.0 * std::numbers::pi / 180.0;
constexpr double shortest_step = longest_step / 64.0;

void add(std::vector<PlanarPose>& poses, double factor, const std::vector<PlanarPose>& change)
{
    for (std::size_t body = 0; body < poses.size(); ++body) {
        poses[body].translation = poses[body].translation + factor * change[body].translation;
        poses[body].angle += factor * change[body].angle;
    }
}

}  // namespace

PlanarPosition PlanarWalk::located(std::vector<PlanarPose> poses) const
{
    PlanarPosition result;
    result.poses = std::move(poses);
    result.angle = result.poses[layout.driven_body].angle;
    const PlanarAlgebra algebra{layout, result.poses, shifts};
    PlanarPosition::Factors factors{algebra.factorised(algebra.jacobian(), result.angle), 1};
    const auto& lu = factors.lu;
    const long negative = (lu.matrixLU().diagonal().array() < 0).count();
    factors.determinant_sign = static_cast<int>(lu.permutationP().determinant()) * (negative % 2 == 0 ? 1 : -1);
    result.slopes = algebra.spread(lu.solve(Eigen::VectorXd::Unit(layout.equations, layout.equations - 1)));
    result.curvatures = algebra.spread(lu.solve(algebra.gamma(result.slopes, 0)));
    result.factors = std::make_shared<const PlanarPosition::Factors>(std::move(factors));
    return result;
}

bool PlanarWalk::close(std::vector<PlanarPose>& guess, double angle, Eigen::PartialPivLU<Eigen::MatrixXd> lu) const
{
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < 30; ++iteration) {
        const PlanarAlgebra algebra{layout, guess, shifts};
        const Eigen::VectorXd correction = lu.solve(-algebra.residual(angle));
        const double size = correction.lpNorm<Eigen::Infinity>() / layout.length;
        if (!std::isfinite(size) || size > 1)
            return false;
        add(guess, 1, algebra.spread(correction));
        // The second condition: rounding prevents a further decrease.
        if (size < 1e-14 || (size < 1e-11 && size > 0.5 * last))
            return true;
        if (size > 0.05 * last)
            lu.compute(algebra.jacobian());
        last = size;
    }
    return false;
}

std::optional<PlanarPosition> PlanarWalk::stepped(const PlanarPosition& from, double to, bool far) const
{
    const double step = to - from.angle;
    std::vector<PlanarPose> guess = from.poses;
    add(guess, step, from.slopes);
    add(guess, 0.5 * step * step, from.curvatures);
    const PlanarAlgebra guessed{layout, guess, shifts};
    if (!close(guess, to, far ? Eigen::PartialPivLU<Eigen::MatrixXd>(guessed.jacobian()) : from.factors->lu))
        return std::nullopt;
    PlanarPosition result = located(std::move(guess));
    result.angle = to;
    return result;
}

PlanarPosition PlanarWalk::furthest(PlanarPosition from, double to) const
{
    double step = longest_step;
    while (from.angle != to) {
        const double next = std::abs(to - from.angle) <= step ? to : from.angle + std::copysign(step, to - from.angle);
        std::optional<PlanarPosition> there = stepped(from, next, false);
        if (there && there->factors->determinant_sign == from.factors->determinant_sign) {
            from = std::move(*there);
            step = std::min(longest_step, 4 * step);
        } else if (step > shortest_step) {
            step /= 4;
        } else if (stepped(from, from.angle + std::copysign(longest_step, to - from.angle), true)) {
            // The linkage closes beyond this point, so its range does not end here; two ways of closing cross.
            const PlanarAlgebra here{layout, from.poses, shifts};
            throw InputError(
                fmt::format("the linkage is singular near {:.2f} degrees from its assembled position, where it could "
                            "go on in two ways: {}\n  help: change the lengths so that the links do not line up there",
                            next * degrees, here.fault(here.jacobian(), 1).text));
        } else {
            break;
        }
    }
    return from;
}

/// The joint to open so that all others can close: a joint that carries the force that jams the linkage.
int PlanarWalk::jammed_joint(const PlanarPosition& last) const
{
    const PlanarAlgebra algebra{layout, last.poses, shifts};
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(algebra.jacobian(), Eigen::ComputeFullU);
    const Eigen::VectorXd forces = svd.matrixU().rightCols(1);
    std::vector<double> sizes;
    for (int j = 0; j < algebra.joints(); ++j) {
        const bool revolute = layout.linkage.joints[j].kind == LinkageJoint::Kind::revolute;
        const bool eligible = revolute && j != layout.linkage.driver;
        sizes.push_back(eligible ? forces.segment(layout.first_equation[j], 2).norm() : 0.0);
    }
    const double largest = *std::max_element(sizes.begin(), sizes.end());
    const auto first =
        std::find_if(sizes.begin(), sizes.end(), [&](double size) { return size >= 0.99 * largest && size > 0; });
    return first == sizes.end() ? -1 : static_cast<int>(first - sizes.begin());
}

/// Where on the way this joint stays open furthest when all others close: damped least squares in which it counts
/// little.
PlanarWalk::Miss PlanarWalk::miss(const PlanarPosition& last, double to, int joint) const
{
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(layout.equations);
    weights.segment(layout.first_equation[joint], 2).setConstant(1e-3);
    std::vector<PlanarPose> poses = last.poses;
    const auto weighted = [&](const std::vector<PlanarPose>& at, double angle) -> Eigen::VectorXd {
        return weights.cwiseProduct(PlanarAlgebra{layout, at, shifts}.residual(angle)) / layout.length;
    };
    Miss widest;
    const int steps = 2 * static_cast<int>(std::ceil(0.5 * std::abs(to - last.angle) / longest_step));
    for (int step = 1; step <= steps; ++step) {
        const double angle = last.angle + (to - last.angle) * step / steps;
        Eigen::VectorXd error = weighted(poses, angle);
        double damping = 1e-9;
        for (int iteration = 0; iteration < 60 && damping < 1e3; ++iteration) {
            const PlanarAlgebra algebra{layout, poses, shifts};
            const Eigen::MatrixXd slope = weights.asDiagonal() * algebra.jacobian() / layout.length;
            Eigen::MatrixXd normal = slope.transpose() * slope;
            normal.diagonal().array() += damping;
            const Eigen::VectorXd change = normal.ldlt().solve(-slope.transpose() * error);
            std::vector<PlanarPose> trial = poses;
            add(trial, 1, algebra.spread(change));
            const Eigen::VectorXd left = weighted(trial, angle);
            if (!(left.norm() < error.norm())) {
                damping *= 10;
                continue;
            }
            poses = std::move(trial);
            error = left;
            damping = std::max(1e-12, damping / 10);
            if (change.lpNorm<Eigen::Infinity>() < 1e-9)
                break;
        }
        const double opening = PlanarAlgebra{layout, poses, shifts}.opening(joint);
        if (opening > widest.opening)
            widest = {angle, opening};
    }
    return widest;
}

std::string PlanarWalk::obstacle(const PlanarPosition& last, double to) const
{
    const double way = to < last.angle ? -1 : 1;
    double end = last.angle;
    if (shifts.empty()) {
        try {  // from the assembled position in the other direction
            const PlanarPosition other = furthest(located(layout.assembled()), last.angle - way * full_turn);
            end = other.angle + way * full_turn;
        } catch (const InputError&) {
            // Singular in that direction: state only where it stops in this one.
        }
    }
    const bool both = end - last.angle != 0;
    const auto [from, until] = std::minmax(last.angle, end);
    std::string text = both ? fmt::format("the linkage cannot close from {:.2f} to {:.2f} degrees from its assembled "
                                          "position",
                                          from * degrees, until * degrees)
                            : fmt::format("the linkage cannot close beyond {:.2f} degrees from its assembled position",
                                          last.angle * degrees);
    const int joint = jammed_joint(last);
    if (joint >= 0) {
        const LinkageJoint& jammed = layout.linkage.joints[joint];
        const auto& bodies = layout.linkage.bodies;
        const Miss widest = miss(last, both ? end : to, joint);
        text += fmt::format(
            ": with all others closed, joint '{}' of '{}' and '{}' misses by {:.4g} mm at {:.2f} degrees", jammed.name,
            bodies[jammed.body_a], bodies[jammed.body_b], 1e3 * widest.opening, widest.angle * degrees);
    }
    return text + "\n  help: check the lengths of the links and the places of the joints, or how far the driver turns";
}

}  // namespace deadpoint::mechanism
