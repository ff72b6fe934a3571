#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <functional>

/// Samples of a probability density. Shows Eigen.
namespace deadpoint::calibration {

struct SampleOptions {
    std::size_t count = 10000;  ///< samples that are kept
    std::size_t burn_in = 2000;
    unsigned seed = 1;
};

struct Samples {
    Eigen::MatrixXd theta;  ///< a column for each sample
    double accepted = 0;    ///< share of steps that moved, at either stage
};

/// Delayed rejection and adaptive Metropolis (Haario, Laine, Mira, Saksman, Statistics and Computing 16 (2006)). The
/// proposal has 2.38^2 / d times the covariance of the chain so far, from the given one in the first steps; a proposal
/// that is rejected is tried again with a fifth of its size.
/// @param log_density  -infinity where it is zero
/// @param covariance   of the first proposals, times 2.38^2 / d
Samples sample(const std::function<double(const Eigen::VectorXd&)>& log_density, const Eigen::VectorXd& start,
               const Eigen::MatrixXd& covariance, const SampleOptions& options);

}  // namespace deadpoint::calibration
