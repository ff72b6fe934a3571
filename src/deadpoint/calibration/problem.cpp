#include "deadpoint/calibration/problem.hpp"

#include "deadpoint/error.hpp"

namespace deadpoint::calibration {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd Problem::sigmas() const
{
    VectorXd result(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k)
        result[static_cast<Eigen::Index>(k)] = parameters[k].sigma;
    return result;
}

VectorXd Problem::measured() const
{
    const auto first = starts();
    VectorXd result(first.back());
    for (std::size_t c = 0; c < curves.size(); ++c)
        result.segment(first[c], curves[c].measured.size()) = curves[c].measured;
    return result;
}

std::vector<Eigen::Index> Problem::starts() const
{
    std::vector<Eigen::Index> result{0};
    for (const auto& curve : curves)
        result.push_back(result.back() + curve.time.size());
    return result;
}

MatrixXd whiten_columns(const Problem& problem, const MatrixXd& columns)
{
    const auto first = problem.starts();
    if (columns.rows() != first.back())
        throw InputError("a model predicts another number of values than were measured");
    MatrixXd result(columns.rows(), columns.cols());
    for (std::size_t c = 0; c < problem.curves.size(); ++c) {
        const auto& curve = problem.curves[c];
        const Whitening whitening(curve.noise, curve.time);
        result.middleRows(first[c], curve.time.size()) =
            whitening.apply(columns.middleRows(first[c], curve.time.size()));
    }
    return result;
}

Whitened whiten(const Problem& problem, const Prediction& prediction)
{
    const bool derived = prediction.jacobian.size() > 0;
    MatrixXd all(prediction.value.size(), 1 + (derived ? prediction.jacobian.cols() : 0));
    all.col(0) = problem.measured() - prediction.value;
    if (derived)
        all.rightCols(prediction.jacobian.cols()) = prediction.jacobian;
    const MatrixXd white = whiten_columns(problem, all);
    return {white.col(0), white.rightCols(white.cols() - 1)};
}

double cost(const Problem& problem, const Whitened& at, const VectorXd& theta)
{
    return 0.5 * at.residual.squaredNorm() + 0.5 * theta.cwiseQuotient(problem.sigmas()).squaredNorm();
}

}  // namespace deadpoint::calibration
