#include "deadpoint/fem/elastic/dual_functions.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

constexpr double least_singular_value = 0.02;
constexpr double least_integral = 1e-3;  // share of the covered area

}  // namespace

std::optional<Eigen::MatrixXd> dual_functions(const CoveredFace& face, const std::vector<int>& chosen)
{
    const auto count = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd own(face.shape.rows(), count);
    for (Eigen::Index k = 0; k < count; ++k)
        own.col(k) = face.shape.col(chosen[static_cast<std::size_t>(k)]);
    const Eigen::VectorXd others = Eigen::VectorXd::Ones(face.shape.rows()) - own.rowwise().sum();
    const Eigen::MatrixXd shared = own.colwise() + others / static_cast<double>(count);

    const Eigen::VectorXd integral = own.transpose() * face.weight;
    if (integral.minCoeff() < least_integral * face.weight.sum())
        return std::nullopt;
    const Eigen::MatrixXd mass = shared.transpose() * face.weight.asDiagonal() * own;
    const Eigen::VectorXd scale = integral.cwiseSqrt().cwiseInverse();
    const Eigen::JacobiSVD<Eigen::MatrixXd> scaled(scale.asDiagonal() * mass * scale.asDiagonal());
    if (scaled.singularValues().minCoeff() < least_singular_value)
        return std::nullopt;
    return shared * mass.transpose().partialPivLu().solve(Eigen::MatrixXd(integral.asDiagonal())).eval();
}

}  // namespace deadpoint::fem
