#pragma once

#include "deadpoint/calibration/problem.hpp"

#include <random>

/// A linear model with normal errors, whose posterior is known: measured = A theta + errors.
namespace linear {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace deadpoint::calibration;

inline VectorXd even_times(Index count, double step = 60)
{
    return VectorXd::LinSpaced(count, 0, step * static_cast<double>(count - 1));
}

inline VectorXd draw(Index count, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    VectorXd result(count);
    for (double& value : result)
        value = normal(random);
    return result;
}

/// Two curves of `count` values each: theta_0 (1 - exp(-t/1000)) and theta_0 t/1000 + theta_1 exp(-t/500).
inline MatrixXd matrix(const VectorXd& time)
{
    MatrixXd a = MatrixXd::Zero(2 * time.size(), 2);
    for (Index k = 0; k < time.size(); ++k) {
        a(k, 0) = 1 - std::exp(-time[k] / 1000);
        a(time.size() + k, 0) = time[k] / 1000;
        a(time.size() + k, 1) = std::exp(-time[k] / 500);
    }
    return a;
}

inline Problem problem(const VectorXd& truth, const Noise& noise, unsigned seed, Index count = 40)
{
    const VectorXd time = even_times(count);
    const MatrixXd a = matrix(time);
    Problem result;
    result.parameters = {{"first", 0.7}, {"second", 0.5}};
    const VectorXd all = a * truth;
    for (Index c = 0; c < 2; ++c) {
        const MatrixXd root = covariance(noise, time).llt().matrixL();
        result.curves.push_back(
            {c == 0 ? "one" : "two", time,
             all.segment(c * count, count) + root * draw(count, 2 * seed + static_cast<unsigned>(c)), noise});
    }
    result.model = [a](const VectorXd& theta, bool jacobian) {
        return Prediction{a * theta, jacobian ? a : MatrixXd()};
    };
    return result;
}

}  // namespace linear
