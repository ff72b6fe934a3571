#include "deadpoint/calibration/discrepancy.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace deadpoint::calibration {

using Eigen::Index;
using Eigen::VectorXd;

double rms(const VectorXd& values)
{
    return values.size() == 0 ? 0 : std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

namespace {

double neighbour_correlation(const VectorXd& white)
{
    const auto count = white.size();
    const double sum = white.squaredNorm();
    return count < 2 || sum == 0 ? 0 : white.head(count - 1).dot(white.tail(count - 1)) / sum;
}

}  // namespace

CurveResidual residual_of(const Curve& curve, const VectorXd& residual)
{
    constexpr Index least_for_course = 8;  // values, for tests of order and mean
    const auto count = static_cast<double>(residual.size());
    const VectorXd white = Whitening(curve.noise, curve.time).apply(residual);
    CurveResidual result{curve.name,
                         residual.size(),
                         rms(residual),
                         residual.mean(),
                         white.squaredNorm() / count,
                         neighbour_correlation(white),
                         1};
    const boost::math::normal normal;
    const boost::math::chi_squared squares(count);
    double least = cdf(complement(squares, white.squaredNorm()));
    if (residual.size() >= least_for_course) {
        // A product of neighbouring independent normal errors has mean 0 and variance 1. The sum is not divided by
        // that of squares: residuals far below the stated errors do not count, however regular they are.
        const double products = white.head(white.size() - 1).dot(white.tail(white.size() - 1));
        least = std::min(least, cdf(complement(normal, products / std::sqrt(count - 1))));
        least = std::min(least, 2 * cdf(complement(normal, std::abs(white.mean()) * std::sqrt(count))));
    }
    result.probability = std::min(1.0, 3 * least);
    return result;
}

ModelTest test_model(const Problem& problem, const Prediction& prediction)
{
    constexpr double level = 0.05;
    const auto first = problem.starts();
    const VectorXd residual = problem.measured() - prediction.value;
    ModelTest result;
    for (std::size_t c = 0; c < problem.curves.size(); ++c)
        result.curves.push_back(
            residual_of(problem.curves[c], residual.segment(first[c], problem.curves[c].time.size())));
    for (const auto& curve : result.curves)
        result.probability = std::min(result.probability, curve.probability);
    result.probability = std::min(1.0, result.probability * static_cast<double>(result.curves.size()));
    result.differs = result.probability < level;
    return result;
}

}  // namespace deadpoint::calibration
