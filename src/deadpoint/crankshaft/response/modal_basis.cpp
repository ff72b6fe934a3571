#include "deadpoint/crankshaft/response/modal_basis.hpp"

#include "deadpoint/crankshaft/eigen_views.hpp"
#include "deadpoint/crankshaft/system.hpp"
#include "deadpoint/error.hpp"

#include <cmath>

namespace deadpoint::crankshaft {
namespace {

/// Of mu below which a shape follows the load: frequencies over 1e6 times the lowest. Rounding reaches 1e-14.
constexpr double no_inertia = 1e-12;
/// Largest force of dampers (at the lowest frequency) or skew stiffness between a shape without inertia and the rest,
/// relative to its stiffness: the error of leaving it out.
constexpr double no_coupling = 1e-4;

}  // namespace

RestingModes resting_modes(const ShaftSystem& system)
{
    const Eigen::MatrixXd k = 0.5 * (view(system.stiffness) + view(system.stiffness).transpose());
    const Eigen::LLT<Eigen::MatrixXd> factor(k);
    if (factor.info() != Eigen::Success)
        throw InputError("crankshaft: its bearings do not hold it, or it buckles under its axial load\n"
                         "  help: give every bearing stiffness in both directions, or less compression");
    const Eigen::MatrixXd half = factor.matrixL().solve(Eigen::MatrixXd(view(system.mass)));
    const Eigen::MatrixXd scaled = factor.matrixL().solve(Eigen::MatrixXd(half.transpose()));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (scaled + scaled.transpose()));
    if (solver.info() != Eigen::Success)
        throw ConvergenceError("crankshaft: the modes of the resting shaft were not found\n"
                               "  help: look for sections of extreme size or density");
    const Eigen::VectorXd mu = solver.eigenvalues().reverse();
    if (!(mu[0] > 0))
        throw InputError("crankshaft: it has no mass\n  help: give its sections a density, or add a disk");
    const Eigen::MatrixXd shapes = factor.matrixU().solve(solver.eigenvectors()).rowwise().reverse();
    const Eigen::Index moving = (mu.array() > no_inertia * mu[0]).count();
    return {shapes.leftCols(moving), mu.head(moving), shapes.rightCols(mu.size() - moving)};
}

Eigen::MatrixXd modal_damping_matrix(const ShaftSystem& system, const RestingModes& basis)
{
    const Eigen::MatrixXd k = 0.5 * (view(system.stiffness) + view(system.stiffness).transpose());
    const Eigen::MatrixXd kx = k * basis.moving;
    const Eigen::VectorXd values = 2 * system.modal_damping * basis.mu.cwiseSqrt();
    return kx * values.asDiagonal() * kx.transpose();
}

ModalMatrices modal_matrices(const ShaftSystem& system, const RestingModes& basis)
{
    const Eigen::MatrixXd& x = basis.moving;
    const Eigen::MatrixXd skew = 0.5 * (view(system.stiffness) - view(system.stiffness).transpose());
    const Eigen::MatrixXd skew_x = skew * x;
    const Eigen::MatrixXd dampers_x = view(system.damping) * x;
    if (basis.following.cols() > 0) {
        const double by_stiffness = (basis.following.transpose() * skew_x).cwiseAbs().maxCoeff();
        const double by_damping =
            (basis.following.transpose() * dampers_x).cwiseAbs().maxCoeff() / std::sqrt(basis.mu[0]);
        if (by_stiffness > no_coupling || by_damping > no_coupling)
            throw InputError(
                "crankshaft: a bearing with damping or cross-coupled stiffness acts on a part without mass\n"
                "  help: give the section there a density, or the housing a mass");
    }
    const Eigen::MatrixXd gyroscopic_x = view(system.gyroscopic) * x;
    return {x.transpose() * dampers_x, x.transpose() * gyroscopic_x, x.transpose() * skew_x};
}

Eigen::MatrixXd first_order_inverse(const RestingModes& basis, const ModalMatrices& matrices, double speed,
                                    double modal_damping, ModeRange modes)
{
    const auto [first, m] = modes;
    const auto of_modes = [first = first, m = m](const Eigen::MatrixXd& all) { return all.block(first, first, m, m); };
    const Eigen::VectorXd root = basis.mu.segment(first, m).cwiseSqrt();
    Eigen::MatrixXd d = of_modes(matrices.dampers) - speed * of_modes(matrices.gyroscopic);
    d.diagonal() += 2 * modal_damping * root;
    const Eigen::PartialPivLU<Eigen::MatrixXd> stiffness(Eigen::MatrixXd::Identity(m, m) + of_modes(matrices.skew));
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(2 * m, 2 * m);
    inverse.topLeftCorner(m, m) = -stiffness.solve(d);
    inverse.topRightCorner(m, m) = -stiffness.solve(Eigen::MatrixXd(root.asDiagonal()));
    inverse.bottomLeftCorner(m, m) = root.asDiagonal();
    if (!inverse.allFinite())
        throw DomainError("crankshaft: the equations of motion are not finite\n"
                          "  help: look for an extreme stiffness or damping of a bearing");
    return inverse;
}

}  // namespace deadpoint::crankshaft
