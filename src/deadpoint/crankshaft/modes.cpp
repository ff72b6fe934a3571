#include "deadpoint/crankshaft/modes.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/crankshaft/response/modal_basis.hpp"
#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace deadpoint::crankshaft {
namespace {

using Complex = std::complex<double>;

constexpr double planar_below = 1e-6;
constexpr double oscillates = 1e-9;      ///< imaginary part of an eigenvalue over its magnitude
constexpr double campbell_error = 1e-6;  ///< of an eigenvalue in campbell(), relative
constexpr int fewest_kept = 32;          ///< modes of the resting shaft

Whirl whirl_of(double circularity)
{
    if (std::abs(circularity) < planar_below)
        return Whirl::planar;
    return circularity > 0 ? Whirl::forward : Whirl::backward;
}

/// Forward circles have y = -i x.
double circularity_of(const Eigen::VectorXcd& q, int nodes)
{
    double circular = 0;
    double all = 0;
    for (int node = 0; node < nodes; ++node) {
        const Complex x = q[first_unknown(node)];
        const Complex y = q[first_unknown(node) + 1];
        circular += 2 * std::imag(x * std::conj(y));
        all += std::norm(x) + std::norm(y);
    }
    return all > 0 ? circular / all : 0;
}

/// Amplitudes per node, scaled so that the largest is 1 and real.
void set_shape(Mode& mode, const Eigen::VectorXcd& q, int nodes)
{
    Complex largest = 0;
    for (int node = 0; node < nodes; ++node)
        for (int direction = 0; direction < 2; ++direction)
            if (std::abs(q[first_unknown(node) + direction]) > std::abs(largest))
                largest = q[first_unknown(node) + direction];
    if (largest == Complex(0))
        largest = 1;
    for (int node = 0; node < nodes; ++node) {
        mode.x.push_back(q[first_unknown(node)] / largest);
        mode.y.push_back(q[first_unknown(node) + 1] / largest);
    }
}

/// A mode in the modes of the resting shaft: q = X p, p' = lambda p.
struct ModalMode {
    Complex lambda;
    Eigen::VectorXcd p;
};

struct Eigenpairs {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
};

template <class Solver>
std::optional<Eigenpairs> if_found(const Solver& solver)
{
    if (solver.info() != Eigen::Success)
        return std::nullopt;
    return Eigenpairs{solver.eigenvalues().template cast<Complex>(), solver.eigenvectors().template cast<Complex>()};
}

/// A skew matrix (no damping, no skew stiffness) is i times a Hermitian one, whose method always ends. That of real
/// matrices sometimes goes round in circles; the complex one takes other shifts.
/// @throws ConvergenceError
Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix)
{
    using Eigen::MatrixXcd;
    std::optional<Eigenpairs> found;
    if (matrix == -matrix.transpose()) {
        found = if_found(Eigen::SelfAdjointEigenSolver<MatrixXcd>(Complex(0, -1) * matrix));
        if (found)
            found->values *= Complex(0, 1);
    } else {
        found = if_found(Eigen::EigenSolver<Eigen::MatrixXd>(matrix));
    }
    if (!found)
        found = if_found(Eigen::ComplexEigenSolver<MatrixXcd>(matrix.cast<Complex>()));
    if (!found)
        throw ConvergenceError(
            "crankshaft: its modes were not found\n  help: look for extreme values among the bearings");
    return *std::move(found);
}

/// Oscillating modes, ascending, of the shaft reduced to the lowest `kept` modes of the resting shaft.
std::vector<ModalMode> modal_modes(const RestingModes& basis, const ModalMatrices& matrices, double speed, int count,
                                   Eigen::Index kept)
{
    const auto pairs = eigenpairs(first_order_inverse(basis, matrices, speed, 0, {0, kept}));
    std::vector<std::pair<double, Eigen::Index>> found;
    for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
        const Complex lambda = 1.0 / pairs.values[i];
        if (lambda.imag() > oscillates * std::abs(lambda))
            found.emplace_back(lambda.imag(), i);
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), static_cast<std::size_t>(std::max(count, 0))));
    std::vector<ModalMode> result;
    for (const auto& [omega, i] : found)
        result.push_back({1.0 / pairs.values[i], pairs.vectors.col(i).head(kept)});
    return result;
}

/// Relative change of lambda that the modes beyond the kept ones would bring, to second order: they take part by
/// w = (lambda (C - omega G) + K_skew) p, each against its own 1 + lambda^2 mu.
double left_out(const RestingModes& basis, const ModalMatrices& matrices, double speed, const ModalMode& mode)
{
    const Eigen::Index kept = mode.p.size();
    const Eigen::Index rest = matrices.modes() - kept;
    const Eigen::MatrixXd d = matrices.dampers.leftCols(kept) - speed * matrices.gyroscopic.leftCols(kept);
    const Eigen::VectorXcd w =
        mode.lambda * (d.bottomRows(rest) * mode.p) + matrices.skew.bottomLeftCorner(rest, kept) * mode.p;
    double change = 0;
    for (Eigen::Index i = 0; i < rest; ++i)
        change += std::norm(w[i]) / std::abs(1.0 + mode.lambda * mode.lambda * basis.mu[kept + i]);
    const Eigen::VectorXcd slope =
        2.0 * mode.lambda * basis.mu.head(kept).cast<Complex>().cwiseProduct(mode.p) + d.topRows(kept) * mode.p;
    return change / std::abs(mode.lambda * mode.p.dot(slope));
}

/// As modal_modes, with as many modes of the resting shaft as `campbell_error` asks for.
std::vector<ModalMode> lowest_modes(const RestingModes& basis, const ModalMatrices& matrices, double speed, int count)
{
    const Eigen::Index all = matrices.modes();
    for (Eigen::Index kept = std::max(4 * count, fewest_kept); 4 * kept < 3 * all; kept *= 2) {
        auto result = modal_modes(basis, matrices, speed, count, kept);
        double error = 0;
        for (const auto& mode : result)
            error = std::max(error, left_out(basis, matrices, speed, mode));
        if (static_cast<int>(result.size()) == count && error < campbell_error)
            return result;
    }
    return modal_modes(basis, matrices, speed, count, all);
}

std::vector<Mode> in_nodes(const ShaftSystem& system, const RestingModes& basis, double speed,
                           const std::vector<ModalMode>& found)
{
    const int nodes = static_cast<int>(system.nodes.size());
    std::vector<Mode> result;
    for (const auto& [lambda, p] : found) {
        const Eigen::VectorXcd q = basis.moving.leftCols(p.size()).cast<Complex>() * p;
        Mode mode;
        mode.frequency = lambda.imag() / (2 * std::numbers::pi);
        mode.damping_ratio = -lambda.real() / std::abs(lambda);
        mode.circularity = circularity_of(q, nodes) * (speed < 0 ? -1 : 1);
        mode.whirl = speed == 0 ? Whirl::planar : whirl_of(mode.circularity);
        set_shape(mode, q, nodes);
        result.push_back(std::move(mode));
    }
    return result;
}

}  // namespace

std::vector<Mode> modes(const ShaftSystem& system, double speed, int count)
{
    const RestingModes basis = resting_modes(system);
    const ModalMatrices matrices = modal_matrices(system, basis);
    return in_nodes(system, basis, speed, modal_modes(basis, matrices, speed, count, matrices.modes()));
}

std::vector<std::vector<Mode>> campbell(const ShaftSystem& system, std::span<const double> speeds, int count)
{
    const RestingModes basis = resting_modes(system);
    const ModalMatrices matrices = modal_matrices(system, basis);
    std::vector<std::vector<Mode>> table;
    for (const double speed : speeds)
        table.push_back(in_nodes(system, basis, speed, lowest_modes(basis, matrices, speed, count)));
    return table;
}

std::vector<CriticalSpeed> critical_speeds(const ShaftSystem& system, double per_turn, int count)
{
    if (!(per_turn > 0) || !std::isfinite(per_turn))
        throw InputError("crankshaft: critical speeds need a positive number of cycles per turn");
    const RestingModes basis = resting_modes(system);
    Eigen::MatrixXcd inverse = (Complex(0, 1) / per_turn) *
                               (basis.moving.transpose() * view(system.gyroscopic) * basis.moving).cast<Complex>();
    inverse.diagonal() += basis.mu.cast<Complex>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(inverse);
    const int nodes = static_cast<int>(system.nodes.size());
    std::vector<CriticalSpeed> result;
    for (Eigen::Index i = inverse.cols() - 1; i >= 0 && static_cast<int>(result.size()) < count; --i) {
        const double value = solver.eigenvalues()[i];
        if (!(value > basis.mu[basis.mu.size() - 1]))
            break;
        const Eigen::VectorXcd q = basis.moving.cast<Complex>() * solver.eigenvectors().col(i);
        result.push_back({1 / (std::sqrt(value) * per_turn), whirl_of(circularity_of(q, nodes))});
    }
    return result;
}

}  // namespace deadpoint::crankshaft
