#pragma once

#include "deadpoint/calibration/problem.hpp"

#include <string>
#include <vector>

/// What data can tell of parameters. Shows Eigen.
namespace deadpoint::calibration {

/// A combination of parameters, in standard deviations of the prior.
struct Combination {
    double singular_value = 0;  ///< of the whitened Jacobian times sigma; below 1 the prior says more than the data
    Eigen::VectorXd direction;  ///< of theta / sigma, unit length
    bool by_data = false;       ///< singular_value >= 1
    std::string words;          ///< "A", "A x B", "A / B": what the combination is
};

struct Identifiability {
    std::vector<Combination> combinations;  ///< the best determined first; as many as parameters
    Eigen::MatrixXd covariance;             ///< (J^T J + Sigma^-1)^-1
    Eigen::VectorXd shrinkage;              ///< 1 - posterior over prior variance, by parameter
    Eigen::VectorXd influence;              ///< length of the column of J times sigma, by parameter
};

/// @param jacobian  whitened
Identifiability identify(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& jacobian);

/// Expected information of further values: 1/2 ln det(1 + J cov J^T) [nat], with their whitened Jacobian J.
double information(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& jacobian);

/// A direction of logarithms in words: those with at least 0.35 of the largest component, multiplied or divided.
std::string words_of(const std::vector<Parameter>& parameters, const Eigen::VectorXd& direction);

}  // namespace deadpoint::calibration
