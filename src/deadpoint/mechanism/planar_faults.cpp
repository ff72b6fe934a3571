#include "deadpoint/mechanism/planar_algebra.hpp"
#include "deadpoint/mechanism/planar_layout.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::mechanism {
namespace {

constexpr double rank_tolerance = 1e-10;
// Least share of a joint or body in a null space of orthonormal columns; more where the space is not quite null.
constexpr double exact_share = 1e-6;
constexpr double near_share = 0.02;

}  // namespace

std::string PlanarAlgebra::joints_in(const Eigen::MatrixXd& null_space, double share) const
{
    std::vector<std::string> names;
    for (int j = 0; j < joints(); ++j) {
        const LinkageJoint& joint = layout.linkage.joints[j];
        if (null_space.middleRows(layout.first_equation[j], equations_of(joint)).norm() > share)
            names.push_back("'" + joint.name + "'");
    }
    if (null_space.bottomRows(1).norm() > share)
        names.emplace_back("the driver");
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string PlanarAlgebra::bodies_in(const Eigen::MatrixXd& null_space, double share) const
{
    std::vector<std::string> names;
    for (std::size_t body = 0; body < poses.size(); ++body) {
        const int k = layout.first_unknown[body];
        if (k >= 0 && null_space.middleRows(k, 3).norm() > share)
            names.push_back("'" + layout.linkage.bodies[body] + "'");
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Equations can go without losing rank where they take part in the left null space. A slide's hold on the rotation is
/// the one that a designer gives up first; else a whole joint.
std::string PlanarAlgebra::what_to_free(const Eigen::MatrixXd& null_space, double share) const
{
    std::vector<std::string> slides;
    for (int j = 0; j < joints(); ++j) {
        const LinkageJoint& joint = layout.linkage.joints[j];
        if (joint.kind == LinkageJoint::Kind::slide && joint.guides_rotation &&
            null_space.row(layout.first_equation[j] + 1).norm() > share)
            slides.push_back("'" + joint.name + "'");
    }
    const auto surplus = static_cast<std::size_t>(null_space.cols());
    const std::string too_many = fmt::format("{} equation{} too many: ", surplus, surplus == 1 ? "" : "s");
    if (slides.size() < surplus)
        return too_many + "remove one of these joints";
    const std::string count = slides.size() == surplus ? "" : fmt::format("{} of ", surplus);
    return fmt::format("{}let {}{} turn (guides_rotation = false), or remove a joint", too_many, count,
                       fmt::join(slides, ", "));
}

PlanarAlgebra::Fault PlanarAlgebra::fault(const Eigen::MatrixXd& matrix, long missing) const
{
    if (missing == 0 && layout.unknowns == layout.equations &&
        Eigen::PartialPivLU<Eigen::MatrixXd>(matrix).rcond() > 1e-8)
        return {};
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const auto& values = svd.singularValues();
    const long found = (values.array() > rank_tolerance * values[0]).count();
    const long rank = std::min<long>(found, values.size() - missing);

    const double share = missing > 0 ? near_share : exact_share;
    Fault result;
    if (rank < layout.unknowns)
        result.text += fmt::format("\n  free to move although the driver is held: {}",
                                   bodies_in(svd.matrixV().rightCols(layout.unknowns - rank), share));
    if (rank < layout.equations) {
        const Eigen::MatrixXd surplus = svd.matrixU().rightCols(layout.equations - rank);
        result.text += fmt::format("\n  hold the same motion more than once: {}", joints_in(surplus, share));
        result.help = what_to_free(surplus, share);
    }
    if (result.text.empty())
        return {};
    if (rank < layout.unknowns && rank < layout.equations)
        result.help = "check which joints hold these bodies, or assemble the linkage elsewhere in its turn";
    else if (rank < layout.unknowns)
        result.help = "add the joints or guides that are missing";
    result.text =
        fmt::format("{} unknowns, {} equations, rank {}{}", layout.unknowns, layout.equations, rank, result.text);
    return result;
}

}  // namespace deadpoint::mechanism
