#include "deadpoint/calibration/fit.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <optional>

namespace deadpoint::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rough_step = 0.05;  // FitOptions::step while minima are sought

/// Largest distance of a point from a fit, in the fit's standard deviations.
double distance(const Fit& from, const VectorXd& theta)
{
    return (theta - from.theta).cwiseQuotient(from.covariance.diagonal().cwiseSqrt()).cwiseAbs().maxCoeff();
}

/// One descent.
class Descent {
public:
    Descent(const Problem& problem, VectorXd start, const FitOptions& options)
        : problem_(problem), options_(options), prior_(problem.sigmas().array().square().inverse())
    {
        result_.theta = clipped(std::move(start));
        take(evaluate(result_.theta));
    }

    Fit run()
    {
        for (int k = 0; k < options_.most_iterations && !result_.converged; ++k)
            iterate();
        const MatrixXd hessian = this->hessian();
        result_.covariance = hessian.llt().solve(MatrixXd::Identity(hessian.rows(), hessian.cols()));
        for (Index k = 0; k < result_.theta.size(); ++k) {
            const auto& parameter = problem_.parameters[static_cast<std::size_t>(k)];
            result_.at_limit.push_back(result_.theta[k] <= parameter.lower || result_.theta[k] >= parameter.upper);
        }
        return std::move(result_);
    }

private:
    struct Trial {
        VectorXd theta;
        Prediction prediction;
        Whitened white;
        double cost = 0;
    };

    [[nodiscard]] VectorXd clipped(VectorXd theta) const
    {
        for (Index k = 0; k < theta.size(); ++k) {
            const auto& parameter = problem_.parameters[static_cast<std::size_t>(k)];
            theta[k] = std::clamp(theta[k], parameter.lower, parameter.upper);
        }
        return theta;
    }
    Trial evaluate(const VectorXd& theta)
    {
        Trial trial{theta, problem_.model(theta, true), {}, 0};
        trial.white = whiten(problem_, trial.prediction);
        trial.cost = cost(problem_, trial.white, theta);
        ++result_.evaluations;
        if (!std::isfinite(trial.cost) || !trial.white.jacobian.allFinite())
            throw ConvergenceError("the model gives values that are not finite\n  help: narrow the limits of the "
                                   "parameters, and look at 'deadpoint run' of the case");
        return trial;
    }
    // Nothing where a step went so far that the model cannot be computed.
    std::optional<Trial> attempt(const VectorXd& theta)
    {
        try {
            return evaluate(theta);
        } catch (const Error&) {
            return std::nullopt;
        }
    }
    void take(Trial trial)
    {
        result_.theta = std::move(trial.theta);
        result_.prediction = std::move(trial.prediction);
        result_.white = std::move(trial.white);
        result_.cost = trial.cost;
    }
    [[nodiscard]] MatrixXd hessian() const
    {
        MatrixXd result = result_.white.jacobian.transpose() * result_.white.jacobian;
        result.diagonal() += prior_;
        return result;
    }
    // Those that are held, or lie at a limit beyond which the cost falls.
    [[nodiscard]] std::vector<bool> fixed(const VectorXd& slope) const
    {
        std::vector<bool> result(problem_.parameters.size(), false);
        for (std::size_t k = 0; k < result.size(); ++k) {
            const auto& parameter = problem_.parameters[k];
            const double theta = result_.theta[static_cast<Index>(k)], down = -slope[static_cast<Index>(k)];
            result[k] = (!options_.held.empty() && options_.held[k]) || (theta <= parameter.lower && down < 0) ||
                        (theta >= parameter.upper && down > 0);
        }
        return result;
    }
    void iterate()
    {
        MatrixXd matrix = hessian();
        VectorXd slope =
            -result_.white.jacobian.transpose() * result_.white.residual + prior_.cwiseProduct(result_.theta);
        const auto held = fixed(slope);
        for (std::size_t k = 0; k < held.size(); ++k)
            if (held[k]) {
                const auto at = static_cast<Index>(k);
                matrix.row(at).setZero();
                matrix.col(at).setZero();
                matrix(at, at) = 1;
                slope[at] = 0;
            }
        const VectorXd scale = matrix.diagonal().cwiseSqrt();
        matrix.diagonal() *= 1 + damping_;
        const VectorXd theta = clipped(result_.theta - matrix.llt().solve(slope));
        const double moved = (theta - result_.theta).cwiseProduct(scale).cwiseAbs().maxCoeff();
        if (moved < options_.step) {
            result_.converged = true;
            return;
        }
        auto trial = attempt(theta);
        if (trial && trial->cost < result_.cost) {
            result_.converged = result_.cost - trial->cost < 1e-6 * (1e-3 + trial->cost);
            take(*std::move(trial));
            result_.converged =
                result_.converged || (options_.known && distance(*options_.known, result_.theta) < same_minimum);
            damping_ = std::max(damping_ / 10, 1e-8);
        } else {
            damping_ = std::min(damping_ * 10, 1e8);
        }
    }

    const Problem& problem_;
    const FitOptions& options_;
    VectorXd prior_;
    Fit result_;
    double damping_ = 1e-3;
};

}  // namespace

Fit fit(const Problem& problem, const VectorXd& start, const FitOptions& options)
{
    return Descent(problem, start, options).run();
}

std::vector<VectorXd> prior_points(const Problem& problem, int count)
{
    const auto size = problem.parameters.size();
    boost::random::sobol sequence(size);
    const boost::math::normal normal;
    const auto range = static_cast<double>(boost::random::sobol::max()) + 1;
    std::vector<VectorXd> result;
    for (int k = 0; k < count; ++k) {
        VectorXd point(static_cast<Index>(size));
        for (std::size_t j = 0; j < size; ++j) {
            const auto& parameter = problem.parameters[j];
            const double share = (static_cast<double>(sequence()) + 0.5) / range;
            const double within = std::clamp(share, 1e-6, 1 - 1e-6);
            point[static_cast<Index>(j)] =
                std::clamp(parameter.sigma * quantile(normal, within), parameter.lower, parameter.upper);
        }
        result.push_back(std::move(point));
    }
    return result;
}

std::vector<Fit> fit_from_many(const Problem& problem, const Problem& search, int points, const FitOptions& options)
{
    const VectorXd centre = VectorXd::Zero(static_cast<Index>(problem.parameters.size()));
    if (points == 0)
        return {fit(problem, centre, options)};
    FitOptions others = options;
    others.step = rough_step;
    std::vector<Fit> minima{fit(search, centre, others)};
    const Fit first = minima.front();
    int evaluations = first.evaluations;
    others.known = &first;
    for (const auto& start : prior_points(problem, points)) {
        auto found = fit(search, start, others);
        evaluations += found.evaluations;
        if (std::ranges::all_of(minima, [&](const Fit& other) { return distance(other, found.theta) > same_minimum; }))
            minima.push_back(std::move(found));
    }
    std::vector<Fit> result;
    for (const auto& minimum : minima) {
        result.push_back(fit(problem, minimum.theta, options));
        evaluations += result.back().evaluations;
    }
    std::ranges::stable_sort(result, {}, &Fit::cost);
    result.front().evaluations = evaluations;
    return result;
}

std::vector<Fit> other_minima(const std::vector<Fit>& fits)
{
    std::vector<Fit> result;
    for (std::size_t k = 1; k < fits.size(); ++k)
        if (distance(fits.front(), fits[k].theta) > same_minimum)
            result.push_back(fits[k]);
    return result;
}

namespace {

// From the fit in one direction until the cost has risen, or a limit is met. @return whether it has risen
bool walk(const Problem& problem, const Fit& best, std::size_t parameter, double sign, double rise,
          ProfileInterval& result, double& crossing)
{
    constexpr int most_steps = 8;
    const auto at = static_cast<Index>(parameter);
    const double step = 0.7 * std::sqrt(best.covariance(at, at));
    FitOptions options;
    options.held.assign(problem.parameters.size(), false);
    options.held[parameter] = true;
    VectorXd theta = best.theta;
    double before = 0, place = best.theta[at];
    for (int k = 1; k <= most_steps; ++k) {
        const double next = std::clamp(best.theta[at] + sign * k * step, problem.parameters[parameter].lower,
                                       problem.parameters[parameter].upper);
        if (next == place)
            break;
        theta[at] = next;
        const auto found = fit(problem, theta, options);
        const double above = std::max(found.cost - best.cost, 0.0);
        result.points.emplace_back(next, 2 * above);
        if (above >= rise) {
            const double low = std::sqrt(before), high = std::sqrt(above);
            crossing = place + (next - place) * (std::sqrt(rise) - low) / (high - low);
            return true;
        }
        theta = found.theta;
        before = above;
        place = next;
    }
    crossing = place;
    return false;
}

}  // namespace

ProfileInterval profile(const Problem& problem, const Fit& best, std::size_t parameter, double rise)
{
    ProfileInterval result;
    result.points.emplace_back(best.theta[static_cast<Index>(parameter)], 0.0);
    result.open_below = !walk(problem, best, parameter, -1, rise, result, result.lower);
    result.open_above = !walk(problem, best, parameter, 1, rise, result, result.upper);
    std::ranges::sort(result.points);
    return result;
}

}  // namespace deadpoint::calibration
