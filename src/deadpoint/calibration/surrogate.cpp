#include "deadpoint/calibration/surrogate.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <limits>

namespace deadpoint::calibration {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd normal_points(Index size, Index count)
{
    boost::random::mt19937 random(7);
    boost::random::normal_distribution<double> normal;
    MatrixXd result(size, count);
    for (Index k = 0; k < count; ++k)
        for (Index j = 0; j < size; ++j)
            result(j, k) = normal(random);
    return result;
}

// Derivative of features() by u_k.
VectorXd feature_slope(const VectorXd& u, Index by, Index count)
{
    VectorXd result = VectorXd::Zero(count);
    result[1 + by] = 1;
    Index place = 1 + u.size();
    for (Index i = 0; i < u.size(); ++i)
        for (Index j = 0; j <= i; ++j, ++place)
            result[place] = (i == by ? u[j] : 0) + (j == by ? u[i] : 0);
    return result;
}

}  // namespace

VectorXd Surrogate::features(const VectorXd& u) const
{
    const auto size = u.size();
    VectorXd result(1 + size + size * (size + 1) / 2);
    result[0] = 1;
    result.segment(1, size) = u;
    Index place = 1 + size;
    for (Index i = 0; i < size; ++i)
        for (Index j = 0; j <= i; ++j)
            result[place++] = u[i] * u[j];
    return result;
}

VectorXd Surrogate::drawn(const VectorXd& normal) const
{
    VectorXd theta = centre_ + root_ * normal;
    for (Index k = 0; k < theta.size(); ++k) {
        const auto& parameter = problem_.parameters[static_cast<std::size_t>(k)];
        theta[k] = std::clamp(theta[k], parameter.lower, parameter.upper);
    }
    return theta;
}

Surrogate::Surrogate(const Problem& problem, const Fit& fit, int points)
    : problem_(problem), centre_(fit.theta), root_(fit.covariance.llt().matrixL()),
      target_(whiten_columns(problem, problem.measured()))
{
    const auto size = centre_.size();
    const Index count = 1 + size + size * (size + 1) / 2;
    const Index wanted = points > 0 ? points : 2 * (count / (1 + size) + 1);
    points_ = normal_points(size, wanted + 1);
    points_.col(0).setZero();
    MatrixXd design((wanted + 1) * (1 + size), count), right((wanted + 1) * (1 + size), target_.size());
    for (Index p = 0; p <= wanted; ++p) {
        const VectorXd theta = p == 0 ? centre_ : drawn(points_.col(p));
        const VectorXd u = root_.triangularView<Eigen::Lower>().solve(theta - centre_);
        const auto found = problem.model(theta, true);
        const Index row = p * (1 + size);
        design.row(row) = features(u);
        right.row(row) = whiten_columns(problem, found.value).col(0);
        const MatrixXd slopes = whiten_columns(problem, found.jacobian) * root_;
        for (Index k = 0; k < size; ++k) {
            design.row(row + 1 + k) = feature_slope(u, k, count);
            right.row(row + 1 + k) = slopes.col(k);
        }
    }
    coefficients_ = design.householderQr().solve(right);
}

VectorXd Surrogate::value(const VectorXd& theta) const
{
    const VectorXd u = root_.triangularView<Eigen::Lower>().solve(theta - centre_);
    return coefficients_.transpose() * features(u);
}

double Surrogate::log_density(const VectorXd& theta) const
{
    for (Index k = 0; k < theta.size(); ++k) {
        const auto& parameter = problem_.parameters[static_cast<std::size_t>(k)];
        if (theta[k] < parameter.lower || theta[k] > parameter.upper)
            return -std::numeric_limits<double>::infinity();
    }
    return -0.5 * (target_ - value(theta)).squaredNorm() - 0.5 * theta.cwiseQuotient(problem_.sigmas()).squaredNorm();
}

double Surrogate::checked_error(int points) const
{
    const Index seen = points_.cols();
    const MatrixXd fresh = normal_points(centre_.size(), seen + points);
    double largest = 0;
    for (Index p = seen; p < fresh.cols(); ++p) {
        const VectorXd theta = drawn(fresh.col(p));
        const VectorXd exact = whiten_columns(problem_, problem_.model(theta, false).value).col(0);
        const double error = (exact - value(theta)).norm() / std::sqrt(static_cast<double>(exact.size()));
        largest = std::max(largest, error);
    }
    return largest;
}

}  // namespace deadpoint::calibration
