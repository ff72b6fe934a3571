#include "deadpoint/reduce/certificate/directions.hpp"

#include "deadpoint/reduce/certificate/residual_cut.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double eigenvalue_rounding = 1e-14;  // of the largest eigenvalue of the remainder

/// The directions of one term, the one with the most heat first.
struct Rotated {
    MatrixXd unit;      ///< F (F^T F)^-1 Q
    MatrixXd products;  ///< F Q
    MatrixXd below;     ///< columns of F that are too small to be rotated
    VectorXd heat;      ///< of each direction, in typical states
};

Rotated rotated(const MatrixXd& factor, double highest, const ResidualTask& task)
{
    Rotated result;
    if (factor.cols() == 0 || highest == 0)
        return result;
    const VectorXd sizes = factor.colwise().squaredNorm().transpose();
    const Index count = (sizes.array() > task.cut.kept * sizes.maxCoeff()).count();
    const MatrixXd above = factor.leftCols(count);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(above.transpose() * task.typical * above);
    const MatrixXd turn = solver.eigenvectors().rowwise().reverse();
    result.heat = highest * solver.eigenvalues().reverse().cwiseMax(0.0);
    result.products = above * turn;
    result.unit = above * (sizes.head(count).cwiseInverse().asDiagonal() * turn);
    result.below = factor.rightCols(factor.cols() - count);
    return result;
}

// The heat below which directions go to the remainder.
double least_heat(const std::vector<Rotated>& terms, double left)
{
    std::vector<double> all;
    for (const auto& term : terms)
        all.insert(all.end(), term.heat.begin(), term.heat.end());
    std::ranges::sort(all);
    double sum = 0, total = 0;
    for (const double one : all)
        total += one;
    for (const double one : all)
        if (sum += one; sum > left * total)
            return one;
    return 0;
}

// Rows whose squares sum up to x^T matrix x.
MatrixXd root_of(const MatrixXd& lower)
{
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(lower);
    const auto& values = solver.eigenvalues();
    const Index count = (values.array() > eigenvalue_rounding * values.maxCoeff()).count();
    return values.tail(count).cwiseSqrt().asDiagonal() * solver.eigenvectors().rightCols(count).transpose();
}

}  // namespace

std::vector<MatrixXd> choose_directions(const std::vector<MatrixXd>& factors, const ResidualTask& task,
                                        ResidualTerms& result)
{
    std::vector<Rotated> terms;
    for (std::size_t q = 0; q < factors.size(); ++q)
        terms.push_back(rotated(factors[q], task.highest[q], task));
    const double least = least_heat(terms, task.cut.left);
    const auto states = task.typical.rows();
    MatrixXd rest = MatrixXd::Zero(states, states);
    std::vector<MatrixXd> combinations;
    result.highest = task.highest;
    result.first = {0};
    result.factors.resize(states, 0);
    for (std::size_t q = 0; q < terms.size(); ++q) {
        const auto& term = terms[q];
        const Index count = (term.heat.array() >= least).count();
        combinations.emplace_back(term.unit.leftCols(count));
        result.first.push_back(result.first.back() + count);
        result.factors.conservativeResize(Eigen::NoChange, result.first.back());
        result.factors.rightCols(count) = term.products.leftCols(count);
        const MatrixXd further = term.products.rightCols(term.products.cols() - count);
        for (const MatrixXd* part : {&further, &term.below})
            if (part->cols() > 0)
                rest.selfadjointView<Eigen::Lower>().rankUpdate(*part, task.highest[q]);
    }
    result.remainder = rest.isZero(0) ? MatrixXd(0, states) : root_of(rest);
    return combinations;
}

}  // namespace deadpoint::reduce
