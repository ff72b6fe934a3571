#include "deadpoint/fem/estimate/pod.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

double largest_of_ranks(double value)
{
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
    return value;
}

void require_alike(const std::vector<std::vector<float>>& snapshots)
{
    if (snapshots.empty())
        throw InputError("modes need at least one field");
    for (const auto& field : snapshots)
        if (field.size() != snapshots.front().size())
            throw InputError("the fields of which modes are wanted differ in length");
}

}  // namespace

Pod pod(const std::vector<std::vector<float>>& snapshots, double tolerance, std::size_t at_most)
{
    require_alike(snapshots);
    const auto rows = static_cast<Eigen::Index>(snapshots.front().size());
    const auto times = static_cast<Eigen::Index>(snapshots.size());
    Eigen::MatrixXf rest(rows, times);
    for (Eigen::Index j = 0; j < times; ++j)
        rest.col(j) = Eigen::Map<const Eigen::VectorXf>(snapshots[static_cast<std::size_t>(j)].data(), rows);

    Pod result;
    const Eigen::VectorXf base = rest.col(0);
    result.base.owned.assign(base.begin(), base.end());
    double rise = 0;
    for (Eigen::Index j = 0; j < times; ++j) {
        rest.col(j) -= base;
        if (rows > 0)
            rise = std::max(rise, static_cast<double>(rest.col(j).cwiseAbs().maxCoeff()));
    }
    result.largest_rise = result.error = largest_of_ranks(rise);

    std::vector<double> products(static_cast<std::size_t>(times * times));
    Eigen::Map<Eigen::MatrixXd> gram(products.data(), times, times);
    for (Eigen::Index i = 0; i < times; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            gram(i, j) = gram(j, i) = rest.col(i).cast<double>().dot(rest.col(j).cast<double>());
    sum_over_ranks(products);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);

    // Rounding can make eigenvalues of absent modes slightly negative.
    const Eigen::VectorXd squares = solver.eigenvalues().cwiseMax(0.0);
    const auto most = std::min(static_cast<Eigen::Index>(at_most), times);
    for (Eigen::Index k = 0; k < most && result.error > tolerance * result.largest_rise; ++k) {
        const Eigen::VectorXd weight = solver.eigenvectors().col(times - 1 - k);
        Eigen::VectorXd mode = Eigen::VectorXd::Zero(rows);
        for (Eigen::Index j = 0; j < times; ++j)
            mode += weight[j] * rest.col(j).cast<double>();
        double error = 0;
        for (Eigen::Index j = 0; j < times; ++j) {
            rest.col(j) -= (weight[j] * mode).cast<float>();
            if (rows > 0)
                error = std::max(error, static_cast<double>(rest.col(j).cwiseAbs().maxCoeff()));
        }
        result.error = largest_of_ranks(error);
        result.modes.push_back({{mode.begin(), mode.end()}});
        result.coefficients.emplace_back(weight.begin(), weight.end());
        result.residual_energy.push_back(std::sqrt(squares.head(times - k).sum() / squares.sum()));
    }
    return result;
}

}  // namespace deadpoint::fem
