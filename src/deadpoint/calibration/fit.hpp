#pragma once

#include "deadpoint/calibration/problem.hpp"

#include <vector>

/// The likeliest parameters of a problem. Shows Eigen.
namespace deadpoint::calibration {

struct Fit {
    Eigen::VectorXd theta;
    Prediction prediction;
    Whitened white;
    double cost = 0;             ///< cost() at theta
    Eigen::MatrixXd covariance;  ///< (J^T J + Sigma^-1)^-1 of the whitened Jacobian and the prior
    int evaluations = 0;
    bool converged = false;
    std::vector<bool> at_limit;  ///< by parameter
};

struct FitOptions {
    int most_iterations = 40;
    double step = 1e-3;          ///< converged: no parameter moves by more than this share of its standard deviation
    std::vector<bool> held;      ///< parameters that stay where they start; empty: none
    const Fit* known = nullptr;  ///< a descent that comes as near to it as same_minimum ends there
};

/// Largest distance of fits that count as one, in standard deviations of a parameter.
inline constexpr double same_minimum = 0.3;

/// Levenberg and Marquardt's method with projection onto the limits (Nocedal, Wright, Numerical Optimization, ch. 10).
/// Steps to values at which the model cannot be computed are shortened.
/// @throws Error if it cannot be computed at the start
Fit fit(const Problem& problem, const Eigen::VectorXd& start, const FitOptions& options = {});

/// Minima that are found from the prior's centre and from Sobol' points of the prior; the best first. A descent that
/// comes to the minimum of the first one ends there. Fit::evaluations of the first counts all.
/// @param search  a quicker model of the same unknowns and curves, on which the descents run; from each of its minima
/// one
///                fit leads to that of the problem
/// @param points  beside the centre
std::vector<Fit> fit_from_many(const Problem& problem, const Problem& search, int points,
                               const FitOptions& options = {});

/// Points of the prior: a Sobol' sequence through the quantile of the normal distribution, within the limits.
std::vector<Eigen::VectorXd> prior_points(const Problem& problem, int count);

/// Fits that are not at the same_minimum as the first.
std::vector<Fit> other_minima(const std::vector<Fit>& fits);

/// Where a profile of the likelihood crosses.
struct ProfileInterval {
    double lower = 0, upper = 0;                    ///< of theta
    bool open_below = false, open_above = false;    ///< a limit, or the end of the search, came first
    std::vector<std::pair<double, double>> points;  ///< theta, twice the cost above the least, ascending theta
};
/// Values of a parameter at which the least cost over all others is `rise` above that of the fit; 1.353 = 2.706 / 2
/// for 90 %. In steps of 0.7 standard deviations up to five of them, between which the root of the rise is linear.
ProfileInterval profile(const Problem& problem, const Fit& best, std::size_t parameter, double rise = 1.353);

}  // namespace deadpoint::calibration
