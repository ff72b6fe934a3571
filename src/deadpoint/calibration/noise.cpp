#include "deadpoint/calibration/noise.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::calibration {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd covariance(const Noise& noise, const VectorXd& time)
{
    const auto count = time.size();
    MatrixXd result(count, count);
    const double own = noise.sigma * noise.sigma, model = noise.model_error * noise.model_error;
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j <= i; ++j) {
            const double apart = std::abs(time[i] - time[j]);
            double value = model * std::exp(-apart / noise.model_time);
            if (i == j)
                value += own;
            else if (noise.correlation_time > 0)
                value += own * std::exp(-apart / noise.correlation_time);
            result(i, j) = result(j, i) = value;
        }
    return result;
}

Whitening::Whitening(const Noise& noise, const VectorXd& time) : factor_(covariance(noise, time))
{
    if (time.size() > 0 && (factor_.info() != Eigen::Success || !(noise.sigma > 0)))
        throw InputError("the errors of a measured curve are not independent enough to weigh it\n  help: give it noise "
                         "above zero, and each time once");
}

MatrixXd Whitening::apply(const MatrixXd& columns) const { return factor_.matrixL().solve(columns); }

double Whitening::log_determinant() const { return 2 * factor_.matrixLLT().diagonal().array().log().sum(); }

double log_likelihood(const Noise& noise, const VectorXd& time, const VectorXd& residual)
{
    const Whitening whitening(noise, time);
    return -0.5 * whitening.apply(residual).squaredNorm() - 0.5 * whitening.log_determinant();
}

Noise with_estimated_correlation(Noise noise, const VectorXd& time, const VectorXd& residual, double longest)
{
    constexpr int steps = 24;
    const double shortest = longest / 300;
    Noise best = noise;
    best.correlation_time = 0;
    double likeliest = log_likelihood(best, time, residual);
    for (int k = 0; k <= steps; ++k) {
        noise.correlation_time = shortest * std::pow(longest / shortest, static_cast<double>(k) / steps);
        const double found = log_likelihood(noise, time, residual);
        if (found > likeliest) {
            likeliest = found;
            best = noise;
        }
    }
    return best;
}

}  // namespace deadpoint::calibration
