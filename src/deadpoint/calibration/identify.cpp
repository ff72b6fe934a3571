#include "deadpoint/calibration/identify.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deadpoint::calibration {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string words_of(const std::vector<Parameter>& parameters, const VectorXd& direction)
{
    constexpr double share = 0.35;
    std::vector<Index> order(parameters.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](Index k) { return std::abs(direction[k]); });
    const double sign = direction[order.front()] < 0 ? -1 : 1;
    std::string text;
    const auto add = [&](bool above, const char* mark) {
        for (const Index k : order)
            if (std::abs(direction[k]) >= share * std::abs(direction[order.front()]) &&
                (sign * direction[k] > 0) == above)
                text += (text.empty() ? "" : mark) + parameters[static_cast<std::size_t>(k)].name;
    };
    add(true, " x ");
    add(false, " / ");
    return text;
}

Identifiability identify(const std::vector<Parameter>& parameters, const MatrixXd& jacobian)
{
    const auto count = static_cast<Index>(parameters.size());
    VectorXd sigma(count);
    for (Index k = 0; k < count; ++k)
        sigma[k] = parameters[static_cast<std::size_t>(k)].sigma;
    const MatrixXd scaled = jacobian * sigma.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled.transpose() * scaled);
    Identifiability result;
    for (Index k = count; k-- > 0;) {
        const double value = std::sqrt(std::max(eigen.eigenvalues()[k], 0.0));
        const VectorXd direction = eigen.eigenvectors().col(k);
        result.combinations.push_back({value, direction, value >= 1, words_of(parameters, direction)});
    }
    const VectorXd posterior = (1 + eigen.eigenvalues().array().max(0)).inverse();
    const MatrixXd relative = eigen.eigenvectors() * posterior.asDiagonal() * eigen.eigenvectors().transpose();
    result.covariance = sigma.asDiagonal() * relative * sigma.asDiagonal();
    result.shrinkage = 1 - relative.diagonal().array();
    result.influence = scaled.colwise().norm();
    return result;
}

double information(const MatrixXd& covariance, const MatrixXd& jacobian)
{
    const MatrixXd root = covariance.llt().matrixL();
    const MatrixXd turned = jacobian * root;
    MatrixXd small = turned.transpose() * turned;
    small.diagonal().array() += 1;
    const Eigen::LLT<MatrixXd> factor(small);
    return factor.matrixLLT().diagonal().array().log().sum();
}

}  // namespace deadpoint::calibration
