#include "deadpoint/crankshaft/shaft/held_shaft.hpp"

#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <fmt/format.h>
#include <vector>

namespace deadpoint::crankshaft {
namespace {

constexpr Eigen::Index rigid_motions = 4;
/// Share of the beams' stiffness from which the bearings keep their digits beside it: all but three of sixteen.
constexpr double firmly = 1e-3;

// The unknowns but for those of the first node, then the motions x, y, ty, tz of the rigid shaft about that node.
Eigen::MatrixXd motions_of(const ShaftSystem& system)
{
    const Eigen::Index elastic = system.size() - rigid_motions;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(system.size(), system.size());
    result.bottomLeftCorner(elastic, elastic).setIdentity();
    for (int node = 0; node < static_cast<int>(system.nodes.size()); ++node) {
        auto rigid = result.block<4, rigid_motions>(first_unknown(node), elastic);
        const double distance = system.nodes[static_cast<std::size_t>(node)] - system.nodes.front();
        rigid.setIdentity();
        rigid(1, 2) = -distance;  // ty = -dy/ds
        rigid(0, 3) = distance;   // tz = dx/ds
    }
    return result;
}

// The least of the stiffnesses that hold the rigid shaft, as of bearings that far from the first node as it is long,
// over the largest of its beams.
double held_share(const ShaftSystem& system, const Eigen::MatrixXd& motions)
{
    const double length = system.nodes.back() - system.nodes.front();
    const Eigen::MatrixXd rigid =
        motions.rightCols(rigid_motions) * Eigen::Vector4d(1, 1, 1 / length, 1 / length).asDiagonal();
    const Eigen::Matrix4d restoring = rigid.transpose() * view(system.restoring) * rigid;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(0.5 * (restoring + restoring.transpose()),
                                                                Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] / view(system.bending).cwiseAbs().maxCoeff();
}

}  // namespace

HeldShaft held_shaft(const ShaftSystem& system)
{
    const Eigen::Index elastic = system.size() - rigid_motions;
    HeldShaft result{motions_of(system), {}};
    if (held_share(system, result.motions) > firmly)
        return {Eigen::MatrixXd::Identity(system.size(), system.size()), view(system.stiffness)};
    result.stiffness = result.motions.transpose() * view(system.restoring) * result.motions;
    result.stiffness.topLeftCorner(elastic, elastic) += view(system.bending).bottomRightCorner(elastic, elastic);
    return result;
}

Eigen::LLT<Eigen::MatrixXd> factor_of(const HeldShaft& held)
{
    Eigen::LLT<Eigen::MatrixXd> factor(0.5 * (held.stiffness + held.stiffness.transpose()));
    if (factor.info() != Eigen::Success)
        throw InputError("crankshaft: its bearings do not hold it, or it buckles under its axial load\n"
                         "  help: give every bearing stiffness in both directions, or less compression");
    return factor;
}

std::vector<double> static_displacement(const ShaftSystem& system, std::span<const double> load)
{
    if (static_cast<int>(load.size()) != system.size())
        throw InputError(
            fmt::format("crankshaft: the load has {} entries for {} unknowns", load.size(), system.size()));
    const Eigen::Map<const Eigen::VectorXd> f(load.data(), static_cast<Eigen::Index>(load.size()));
    const HeldShaft held = held_shaft(system);
    factor_of(held);
    const Eigen::VectorXd q = held.motions * held.stiffness.partialPivLu().solve(held.motions.transpose() * f);
    if (!q.allFinite())
        throw DomainError("crankshaft: the static displacement is not finite");
    return {q.begin(), q.end()};
}

}  // namespace deadpoint::crankshaft
