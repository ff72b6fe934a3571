#include "deadpoint/crankshaft/modes.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/crankshaft/modal_basis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

using Complex = std::complex<double>;

constexpr double planar_below = 1e-6;
constexpr double oscillates = 1e-9;  ///< imaginary part of an eigenvalue over its magnitude

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

std::vector<Mode> modes_of(const ShaftSystem& system, const RestingModes& basis, double speed, int count)
{
    const FirstOrder form = first_order(system, basis, speed, 0);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(form.inverse);
    if (solver.info() != Eigen::Success)
        throw ConvergenceError(
            "crankshaft: its modes were not found\nhelp: look for extreme values among the bearings");
    std::vector<std::pair<double, Eigen::Index>> found;
    for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i) {
        const Complex lambda = 1.0 / solver.eigenvalues()[i];
        if (lambda.imag() > oscillates * std::abs(lambda))
            found.emplace_back(lambda.imag(), i);
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), static_cast<std::size_t>(std::max(count, 0))));
    const int nodes = static_cast<int>(system.nodes.size());
    std::vector<Mode> result;
    for (const auto& [omega, i] : found) {
        const Complex lambda = 1.0 / solver.eigenvalues()[i];
        const Eigen::VectorXcd q =
            basis.moving.cast<Complex>() * solver.eigenvectors().col(i).head(basis.moving.cols());
        Mode mode;
        mode.frequency = omega / (2 * std::numbers::pi);
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
    return modes_of(system, resting_modes(system), speed, count);
}

std::vector<std::vector<Mode>> campbell(const ShaftSystem& system, std::span<const double> speeds, int count)
{
    const RestingModes basis = resting_modes(system);
    std::vector<std::vector<Mode>> table;
    for (const double speed : speeds)
        table.push_back(modes_of(system, basis, speed, count));
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
