#include "deadpoint/crankshaft/response/periodic.hpp"

#include "deadpoint/crankshaft/response/modal_basis.hpp"
#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/response/periodic_methods.hpp"
#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>
#include <vector>

namespace deadpoint::crankshaft {
namespace {

using Complex = std::complex<double>;

constexpr double grows = 1e-9;     ///< real part of an eigenvalue over its magnitude
constexpr double resonant = 1e-9;  ///< |1 - exp(lambda T)| below which no periodic response is defined
/// Force of a mode on others, relative to their stiffness, below which it moves alone.
constexpr double uncoupled = 1e-3;
constexpr double worst_condition = 1e-10;  ///< reciprocal condition number of the matrix of complex modes

bool all_finite(const Matrix& m)
{
    return std::all_of(m.values.begin(), m.values.end(), [](double value) { return std::isfinite(value); });
}

void check(const ShaftSystem& system, const PeriodicLoad& load, const Readings& readings)
{
    if (load.patterns.rows != system.size() || load.patterns.cols != load.histories.cols || load.histories.rows < 3 ||
        load.histories.cols < 1)
        throw InputError(
            "crankshaft: a periodic load needs a pattern over all unknowns and at least 3 times per channel");
    if (readings.displacement.cols != system.size() || readings.velocity.cols != system.size() ||
        readings.displacement.rows != readings.velocity.rows)
        throw InputError("crankshaft: readings need one entry per unknown, for displacement and for velocity");
    if (!(load.period > 0) || !std::isfinite(load.period))
        throw InputError(fmt::format("crankshaft: the period of the load must be positive, not {:g} s", load.period));
    if (!all_finite(load.patterns) || !all_finite(load.histories))
        throw DomainError("crankshaft: the load over the turn is not finite");
    const bool dampers = std::any_of(system.damping.values.begin(), system.damping.values.end(),
                                     [](double value) { return value != 0; });
    if (!(system.modal_damping > 0) && !dampers)
        throw InputError(
            "crankshaft: nothing damps it, so its response over a turn is not bounded at resonance and not "
            "defined\n  help: give a modal damping ratio (2 % is common), or damping of the bearings");
}

/// The functions of exact integration for a load linear over a step, x = lambda h, without cancellation.
struct StepFunctions {
    Complex decay;       ///< e^x
    Complex from_start;  ///< phi1 - e^x: factor of the load at the start of the step
    Complex from_end;    ///< 1 - phi1: factor of the load at its end;  phi1 = (e^x - 1) / x

    explicit StepFunctions(Complex x) : decay(std::exp(x))
    {
        Complex growth;  // phi1 - 1 = x / 2 + x^2 / 6 + ...
        if (std::abs(x) < 0.5) {
            Complex term = 1;
            for (int k = 2; k < 20; ++k) {
                term *= x / static_cast<double>(k);
                growth += term;
            }
            from_start = growth - x * (1.0 + growth);
        } else {
            growth = (decay - 1.0) / x - 1.0;
            from_start = growth + 1.0 - decay;
        }
        from_end = -growth;
    }
};

/// The uncoupled equations a' = lambda (a - e(t)) of the complex modes, conjugate pairs taken once.
struct ComplexModes {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd load;      ///< modes x channels: e per unit of a channel
    Eigen::MatrixXcd readings;  ///< readings x modes, twice for one of a pair
};

void check_growth(const Eigen::VectorXcd& lambda)
{
    for (const Complex& value : lambda)
        if (value.real() > grows * std::abs(value))
            throw DomainError(
                fmt::format("crankshaft: its motion at {:.4g} Hz grows by itself\n  help: look for skew or "
                            "cross-coupled stiffness of bearings, or give more damping",
                            std::abs(value.imag()) / (2 * std::numbers::pi)));
}

// Complex modes within a range of the resting shaft's modes, as if its others did not move.
ComplexModes complex_modes(const ShaftSystem& system, const RestingModes& basis, const ModalMatrices& matrices,
                           ModeRange range, double speed, const PeriodicLoad& load, const Readings& readings)
{
    const Eigen::Index m = range.count;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(
        first_order_inverse(basis, matrices, speed, system.modal_damping, range));
    if (solver.info() != Eigen::Success)
        throw ConvergenceError("crankshaft: its complex modes were not found\n"
                               "  help: look for extreme values among the bearings, or use another method");
    const Eigen::VectorXcd lambda = solver.eigenvalues().cwiseInverse();
    check_growth(lambda);
    const Eigen::MatrixXcd shapes = solver.eigenvectors();
    const Eigen::PartialPivLU<Eigen::MatrixXcd> to_modes(shapes);
    if (!(to_modes.rcond() > worst_condition))
        throw ConvergenceError("crankshaft: two of its modes coincide (critical damping), so they do not separate\n"
                               "  help: change a damping value slightly, or use harmonic balance");
    const auto moving = basis.moving.middleCols(range.first, m);
    Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(2 * m, load.patterns.cols);
    rest.topRows(m) = (Eigen::MatrixXd::Identity(m, m) + matrices.skew.block(range.first, range.first, m, m))
                          .partialPivLu()
                          .solve(moving.transpose() * view(load.patterns));
    const Eigen::MatrixXcd rest_in_modes = to_modes.solve(rest.cast<Complex>());
    const Eigen::VectorXd frequencies = basis.mu.segment(range.first, m).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd read(readings.displacement.rows, 2 * m);
    read << view(readings.displacement) * moving, view(readings.velocity) * moving * frequencies.asDiagonal();
    const Eigen::MatrixXcd read_modes = read.cast<Complex>() * shapes;

    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < lambda.size(); ++i)
        if (lambda[i].imag() >= 0)
            kept.push_back(i);
    ComplexModes result{lambda(kept), rest_in_modes(kept, Eigen::all), read_modes(Eigen::all, kept)};
    for (Eigen::Index i = 0; i < result.lambda.size(); ++i)
        if (result.lambda[i].imag() > 0)
            result.readings.col(i) *= 2.0;
    return result;
}

// The lowest modes among which forces of dampers, gyroscopes and skew stiffness matter. A mode's coupling is the sum of
// |force between it and another one| at the frequency of that one, or the highest of the load where that is lower,
// relative to the stiffness, which is 1 for each mode.
Eigen::Index coupled_modes(const RestingModes& basis, const ModalMatrices& matrices, double speed, double highest)
{
    const Eigen::VectorXd frequencies = basis.mu.cwiseSqrt().cwiseInverse().cwiseMin(highest);
    Eigen::MatrixXd force = (matrices.dampers - speed * matrices.gyroscopic).cwiseAbs() * frequencies.asDiagonal();
    force += matrices.skew.cwiseAbs();
    force.diagonal().setZero();
    const Eigen::VectorXd coupling = force.rowwise().sum() + force.colwise().sum().transpose();
    Eigen::Index count = coupling.size();
    while (count > 0 && coupling[count - 1] < uncoupled)
        --count;
    return count;
}

// The coupled modes together, all others each alone.
std::vector<ModeRange> mode_ranges(Eigen::Index coupled, Eigen::Index all)
{
    std::vector<ModeRange> ranges;
    if (coupled > 0)
        ranges.push_back({0, coupled});
    for (Eigen::Index i = coupled; i < all; ++i)
        ranges.push_back({i, 1});
    return ranges;
}

/// One mode over the turn: from rest for the state after one period, then again from the state that repeats.
void march(Complex lambda, double period, const Eigen::VectorXcd& load, Eigen::Ref<Eigen::VectorXd> real,
           Eigen::Ref<Eigen::VectorXd> imaginary)
{
    const Eigen::Index steps = load.size();
    const StepFunctions step(lambda * (period / static_cast<double>(steps)));
    const auto advance = [&](Complex state, Eigen::Index n) {
        return step.decay * state + step.from_start * load[n] + step.from_end * load[n + 1 < steps ? n + 1 : 0];
    };
    Complex state = 0;
    for (Eigen::Index n = 0; n < steps; ++n)
        state = advance(state, n);
    const StepFunctions turn(lambda * period);
    const Complex remains = turn.from_start + turn.from_end;  // 1 - exp(lambda T)
    if (std::abs(remains) < resonant)
        throw DomainError(
            fmt::format("crankshaft: its mode at {:.4g} Hz is in resonance with a multiple of the speed and "
                        "hardly damped\n  help: give a modal damping ratio (2 % is common)",
                        lambda.imag() / (2 * std::numbers::pi)));
    state /= remains;
    for (Eigen::Index n = 0; n < steps; ++n) {
        real[n] = state.real();
        imaginary[n] = state.imag();
        state = advance(state, n);
    }
}

ComplexModes joined(const std::vector<ComplexModes>& groups)
{
    Eigen::Index count = 0;
    for (const auto& group : groups)
        count += group.lambda.size();
    ComplexModes all{Eigen::VectorXcd(count), Eigen::MatrixXcd(count, groups.front().load.cols()),
                     Eigen::MatrixXcd(groups.front().readings.rows(), count)};
    Eigen::Index first = 0;
    for (const auto& group : groups) {
        const auto size = group.lambda.size();
        all.lambda.segment(first, size) = group.lambda;
        all.load.middleRows(first, size) = group.load;
        all.readings.middleCols(first, size) = group.readings;
        first += size;
    }
    return all;
}

// Readings over the times of the load, times x readings. A few modes at a time stay in the cache; products of real
// matrices take a quarter of the operations of complex ones.
Eigen::MatrixXd response_of(const ComplexModes& modes, const PeriodicLoad& load)
{
    constexpr Eigen::Index at_a_time = 8;
    const auto histories = view(load.histories);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(histories.rows(), modes.readings.rows());
    Eigen::MatrixXd real(histories.rows(), at_a_time), imaginary = real, real_load = real, imaginary_load = real;
    Eigen::VectorXcd of_mode(histories.rows());
    for (Eigen::Index first = 0; first < modes.lambda.size(); first += at_a_time) {
        const Eigen::Index count = std::min(at_a_time, modes.lambda.size() - first);
        const auto loads = modes.load.middleRows(first, count);
        const auto readings = modes.readings.middleCols(first, count);
        real_load.leftCols(count).noalias() = histories * loads.real().transpose();
        imaginary_load.leftCols(count).noalias() = histories * loads.imag().transpose();
        for (Eigen::Index i = 0; i < count; ++i) {
            of_mode.real() = real_load.col(i);
            of_mode.imag() = imaginary_load.col(i);
            march(modes.lambda[first + i], load.period, of_mode, real.col(i), imaginary.col(i));
        }
        result.noalias() += real.leftCols(count) * readings.real().transpose();
        result.noalias() -= imaginary.leftCols(count) * readings.imag().transpose();
    }
    return result;
}

Matrix modal_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings)
{
    const RestingModes basis = resting_modes(system);
    const ModalMatrices matrices = modal_matrices(system, basis);
    const auto histories = view(load.histories);
    const double highest = std::numbers::pi * static_cast<double>(load.histories.rows) / load.period;
    const auto coupled = coupled_modes(basis, matrices, speed, highest);
    std::vector<ComplexModes> groups;
    for (const auto& range : mode_ranges(coupled, matrices.modes()))
        groups.push_back(complex_modes(system, basis, matrices, range, speed, load, readings));
    Matrix result(load.histories.rows, readings.displacement.rows);
    view(result) = response_of(joined(groups), load);
    if (basis.following.cols() > 0)
        view(result) += histories * (view(readings.displacement) * basis.following * basis.following.transpose() *
                                     view(load.patterns))
                                        .transpose();
    return result;
}

}  // namespace

Matrix periodic_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings,
                         const PeriodicSettings& settings)
{
    check(system, load, readings);
    Matrix result;
    switch (settings.method) {
    case PeriodicMethod::modal:
        result = modal_response(system, speed, load, readings);
        break;
    case PeriodicMethod::harmonic_balance:
        result = harmonic_balance_response(system, speed, load, readings, settings);
        break;
    case PeriodicMethod::newmark:
        result = newmark_response(system, speed, load, readings, settings);
        break;
    }
    if (!all_finite(result))
        throw DomainError("crankshaft: the response over the turn is not finite\n"
                          "  help: look for extreme values among sections and bearings");
    return result;
}

}  // namespace deadpoint::crankshaft
