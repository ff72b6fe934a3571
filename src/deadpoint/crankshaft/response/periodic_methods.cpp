#include "deadpoint/crankshaft/response/periodic_methods.hpp"

#include "deadpoint/crankshaft/response/dynamic_stiffness.hpp"
#include "deadpoint/crankshaft/response/modal_basis.hpp"
#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

using Complex = std::complex<double>;

/// exp(i 2 pi n / N), so that k n is reduced exactly.
std::vector<Complex> unit_circle(int samples)
{
    std::vector<Complex> circle;
    for (int n = 0; n < samples; ++n)
        circle.push_back(std::polar(1.0, 2 * std::numbers::pi * n / samples));
    return circle;
}

std::size_t place_on_circle(int k, int n, int samples)
{
    return static_cast<std::size_t>(static_cast<long long>(k) * n % samples);
}

/// Amplitude of the k-th harmonic of every channel, h(t) = Re(c e^(i k omega t)).
Eigen::VectorXcd harmonic_of(const Matrix& histories, int k, const std::vector<Complex>& circle)
{
    const int samples = histories.rows;
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(histories.cols);
    for (int n = 0; n < samples; ++n)
        sum += std::conj(circle[place_on_circle(k, n, samples)]) * view(histories).row(n).transpose().cast<Complex>();
    if (k == 0)
        return sum / samples;
    const double a = std::numbers::pi * k / samples;
    return sum * (2.0 / samples * std::pow(std::sin(a) / a, 2));
}

}  // namespace

Matrix harmonic_balance_response(const ShaftSystem& system, double speed, const PeriodicLoad& load,
                                 const Readings& readings, const PeriodicSettings& settings)
{
    if (settings.harmonics < 0)
        throw InputError(fmt::format("crankshaft: the number of harmonics is {}, below zero", settings.harmonics));
    const Eigen::MatrixXd velocity = velocity_matrix(system, speed);
    const int samples = load.histories.rows;
    const std::vector<Complex> circle = unit_circle(samples);
    Matrix result(samples, readings.displacement.rows);
    for (int k = 0; k <= settings.harmonics; ++k) {
        const double omega = 2 * std::numbers::pi * k / load.period;
        const Eigen::VectorXcd force = view(load.patterns).cast<Complex>() * harmonic_of(load.histories, k, circle);
        const Eigen::VectorXcd q = dynamic_stiffness(system, velocity, omega).partialPivLu().solve(force);
        const Eigen::RowVectorXcd y = ((view(readings.displacement).cast<Complex>() +
                                        Complex(0, omega) * view(readings.velocity).cast<Complex>()) *
                                       q)
                                          .transpose();
        for (int n = 0; n < samples; ++n)
            view(result).row(n) += (y * circle[place_on_circle(k, n, samples)]).real();
    }
    return result;
}

Matrix newmark_response(const ShaftSystem& system, double speed, const PeriodicLoad& load, const Readings& readings,
                        const PeriodicSettings& settings)
{
    if (settings.steps_per_sample < 1 || settings.longest_run < 2)
        throw InputError("crankshaft: Newmark needs at least one step per sample and two turns");
    const int samples = load.histories.rows;
    const int parts = settings.steps_per_sample;
    const double dt = load.period / samples / parts;
    const Eigen::MatrixXd m = view(system.mass);
    const Eigen::MatrixXd c = velocity_matrix(system, speed);
    const Eigen::PartialPivLU<Eigen::MatrixXd> effective(view(system.stiffness) + 2 / dt * c + 4 / (dt * dt) * m);
    const Eigen::MatrixXd patterns = view(load.patterns);
    const auto history = view(load.histories);

    Eigen::VectorXd q = view(system.stiffness).partialPivLu().solve(patterns * history.row(0).transpose());
    Eigen::VectorXd v = Eigen::VectorXd::Zero(q.size());
    Eigen::VectorXd a = v;
    const auto advance = [&](const Eigen::VectorXd& force) {
        const Eigen::VectorXd inertia = 4 / (dt * dt) * q + 4 / dt * v + a;
        const Eigen::VectorXd damping = 2 / dt * q + v;
        const Eigen::VectorXd next = effective.solve(force + m * inertia + c * damping);
        const Eigen::VectorXd change = next - q;
        a = 4 / (dt * dt) * change - 4 / dt * v - a;
        v = 2 / dt * change - v;
        q = next;
    };
    Matrix last;
    Matrix result(samples, readings.displacement.rows);
    double drift = 0;
    for (int turn = 0; turn < settings.longest_run; ++turn) {
        last = result;
        for (int n = 0; n < samples; ++n) {
            view(result).row(n) = (view(readings.displacement) * q + view(readings.velocity) * v).transpose();
            const Eigen::VectorXd begin = history.row(n).transpose();
            const Eigen::VectorXd end = history.row((n + 1) % samples).transpose();
            for (int part = 1; part <= parts; ++part)
                advance(patterns * (begin + (end - begin) * part / parts));
        }
        drift = (view(result) - view(last)).cwiseAbs().maxCoeff();
        if (turn > 0 && drift <= settings.newmark_repeat * view(result).cwiseAbs().maxCoeff())
            return result;
    }
    throw ConvergenceError(fmt::format("crankshaft: after {} turns Newmark's method still changes by {:.3g} per turn\n"
                                       "  help: give more damping or turns, or use the modal method",
                                       settings.longest_run, drift));
}

}  // namespace deadpoint::crankshaft
