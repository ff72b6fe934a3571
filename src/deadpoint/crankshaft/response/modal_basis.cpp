#include "deadpoint/crankshaft/response/modal_basis.hpp"

#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/crankshaft/shaft/held_shaft.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::crankshaft {
namespace {

/// Share of the fifth largest mu below which a shape follows the load: frequencies over 1e6 times the fifth lowest.
/// The four lowest may be those of a rigid shaft on soft bearings, any factor below. Rounding reaches 1e-14.
constexpr double no_inertia = 1e-12;
constexpr Eigen::Index rigid_modes = 4;
/// Share of the largest mu above which a mode is exact to 1e-10. The others are solved for without these.
constexpr double exact = 1e-6;
/// Share of the largest entry of the mass below which what is left of it is rounding.
constexpr double no_mass = 1e-12;
/// Largest force of dampers (at the lowest frequency) or skew stiffness between a shape without inertia and the rest,
/// relative to its stiffness: the error of leaving it out.
constexpr double no_coupling = 1e-4;

/// All modes of a mass on a stiffness, as RestingModes.
struct AllModes {
    Eigen::MatrixXd shapes;
    Eigen::VectorXd mu;
};

AllModes modes_of(const Eigen::LLT<Eigen::MatrixXd>& factor, const Eigen::MatrixXd& mass)
{
    const Eigen::MatrixXd half = factor.matrixL().solve(mass);
    const Eigen::MatrixXd scaled = factor.matrixL().solve(Eigen::MatrixXd(half.transpose()));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (scaled + scaled.transpose()));
    if (solver.info() != Eigen::Success)
        throw ConvergenceError("crankshaft: the modes of the resting shaft were not found\n"
                               "  help: look for sections of extreme size or density");
    return {factor.matrixU().solve(solver.eigenvectors()).rowwise().reverse(), solver.eigenvalues().reverse()};
}

/// Solves again for all modes that are not exact, in the shapes without any momentum in the exact ones. Returns the
/// number of modes with inertia.
Eigen::Index solve_again(const HeldShaft& held, const Eigen::MatrixXd& mass, AllModes& modes)
{
    const Eigen::Index known = (modes.mu.array() > exact * modes.mu[0]).count(), rest = modes.mu.size() - known;
    if (rest == 0)
        return known;
    const Eigen::HouseholderQR<Eigen::MatrixXd> momenta(mass * modes.shapes.leftCols(known));
    const Eigen::MatrixXd others =
        momenta.householderQ() * Eigen::MatrixXd::Identity(modes.mu.size(), modes.mu.size()).rightCols(rest);
    const Eigen::MatrixXd left = others.transpose() * mass * others;
    const auto again =
        modes_of(factor_of({others, others.transpose() * held.stiffness * others}), 0.5 * (left + left.transpose()));
    modes.shapes.rightCols(rest) = others * again.shapes;
    modes.mu.tail(rest) = again.mu;
    if (left.cwiseAbs().maxCoeff() < no_mass * mass.cwiseAbs().maxCoeff())
        return known;
    return known + (again.mu.array() > no_inertia * modes.mu[std::min(rigid_modes, modes.mu.size() - 1)]).count();
}

}  // namespace

RestingModes resting_modes(const ShaftSystem& system)
{
    const HeldShaft held = held_shaft(system);
    const auto factor = factor_of(held);
    const Eigen::MatrixXd mass = held.motions.transpose() * view(system.mass) * held.motions;
    auto modes = modes_of(factor, mass);
    if (!(modes.mu[0] > 0))
        throw InputError("crankshaft: it has no mass\n  help: give its sections a density, or add a disk");
    const Eigen::Index moving = solve_again(held, mass, modes);
    const Eigen::MatrixXd shapes = held.motions * modes.shapes;
    return {shapes.leftCols(moving), modes.mu.head(moving), shapes.rightCols(shapes.cols() - moving)};
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
    const Eigen::MatrixXd gyroscopic = x.transpose() * gyroscopic_x;
    // skew to the last bit, as modes() looks for
    return {x.transpose() * dampers_x, 0.5 * (gyroscopic - gyroscopic.transpose()), x.transpose() * skew_x};
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
