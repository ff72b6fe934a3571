#include "deadpoint/reduce/offline/low_rank.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace deadpoint::reduce {
namespace {

constexpr Eigen::Index first_columns = 32;

// Orthonormal columns, the same ones in every call.
Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns)
{
    std::mt19937_64 random(1);
    Eigen::MatrixXd values(rows, columns);
    for (double& value : values.reshaped())
        value = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
    return Eigen::HouseholderQR<Eigen::MatrixXd>(values).householderQ() * Eigen::MatrixXd::Identity(rows, columns);
}

struct Eigenpairs {
    Eigen::MatrixXd vectors;
    Eigen::VectorXd values;  ///< descending
};

// Eigenpairs of V V^T, each value less the shift.
Eigenpairs eigenpairs(const Eigen::MatrixXd& factor, double shift)
{
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(factor, Eigen::ComputeThinU);
    return {svd.matrixU(), (svd.singularValues().array().square() - shift).cwiseMax(0.0)};
}

Eigenpairs nystroem(const SymmetricProduct& product, Eigen::Index size, Eigen::Index columns)
{
    const Eigen::MatrixXd probes = random_columns(size, columns);
    const Eigen::MatrixXd found = product(probes);
    if (found.norm() == 0)
        return {};
    for (double shift = 1e-15 * found.norm(); shift < 1e-6 * found.norm(); shift *= 10) {
        const Eigen::MatrixXd seen = found + shift * probes;
        const Eigen::MatrixXd middle = probes.transpose() * seen;
        const Eigen::LLT<Eigen::MatrixXd> root((middle + middle.transpose()) / 2);
        if (root.info() == Eigen::Success)
            return eigenpairs(root.matrixL().solve(seen.transpose()).transpose(), shift);
    }
    throw ConvergenceError("a term of the reduced model is not positive semidefinite; please report the case");
}

Eigen::MatrixXd scaled(const Eigenpairs& pairs, double least)
{
    const Eigen::Index count = (pairs.values.array() > least).count();
    return pairs.vectors.leftCols(count) * pairs.values.head(count).cwiseSqrt().asDiagonal();
}

Eigen::MatrixXd factor_above(const SymmetricProduct& product, Eigen::Index size, double tolerance, double largest)
{
    for (Eigen::Index columns = std::min(first_columns, size);; columns = std::min(2 * columns, size)) {
        const auto pairs = nystroem(product, size, columns);
        if (pairs.values.size() == 0 || pairs.values[0] == 0)
            return Eigen::MatrixXd(size, 0);
        const double least = tolerance * std::max(largest, pairs.values[0]);
        if (columns == size || pairs.values[columns - 1] < least)
            return scaled(pairs, least);
    }
}

}  // namespace

Eigen::MatrixXd factor_of(const Eigen::MatrixXd& matrix, double tolerance)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const auto& values = solver.eigenvalues();
    return scaled({solver.eigenvectors().rowwise().reverse(), values.reverse().cwiseMax(0.0)},
                  tolerance * values.maxCoeff());
}

Eigen::MatrixXd low_rank_factor(const SymmetricProduct& product, Eigen::Index size, double tolerance)
{
    return factor_above(product, size, tolerance, 0);
}

Eigen::MatrixXd low_rank_factor(const SymmetricProduct& product, const Eigen::VectorXd& load,
                                const Eigen::VectorXd& uniform, double tolerance)
{
    const double whole = uniform.dot(load);
    const auto rest = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
        return product(columns) - load * (load.transpose() * columns) / whole;
    };
    const auto behind = factor_above(rest, load.size(), tolerance, load.squaredNorm() / whole);
    Eigen::MatrixXd factor(load.size(), 1 + behind.cols());
    factor << load / std::sqrt(whole), behind;
    return factor;
}

Eigen::MatrixXd cut(const Eigen::MatrixXd& factor, Eigen::Index kept, const Eigen::MatrixXd& moments, double least)
{
    if (factor.cols() <= kept)
        return factor;
    const auto others = factor.rightCols(factor.cols() - kept);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(others.transpose() * moments * others);
    const Eigen::Index count = (solver.eigenvalues().array() > least).count();
    Eigen::MatrixXd result(factor.rows(), kept + count);
    result << factor.leftCols(kept), others * solver.eigenvectors().rightCols(count).rowwise().reverse();
    return result;
}

}  // namespace deadpoint::reduce
