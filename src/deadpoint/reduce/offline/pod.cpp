#include "deadpoint/reduce/offline/pod.hpp"

#include "deadpoint/reduce/parallel/ranks.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

// Over their trace.
Eigen::MatrixXd weighted(const Moments& moments, const Eigen::VectorXd& unit)
{
    const Eigen::MatrixXd full = deviations(moments, unit);
    const double trace = full.trace();
    return trace > 0 ? Eigen::MatrixXd(full / trace) : full;
}

LowRankTerm combined(const LowRankTerm& term, const Eigen::MatrixXd& combinations)
{
    return term.is_missing() ? LowRankTerm{} : LowRankTerm{combinations.transpose() * term.factor};
}

}  // namespace

void Moments::add(const Eigen::MatrixXd& states) { sum_.selfadjointView<Eigen::Lower>().rankUpdate(states); }

void Moments::sum_over(const Ranks& ranks) { ranks.sum(sum_); }

Eigen::MatrixXd deviations(const Moments& moments, const Eigen::VectorXd& unit)
{
    Eigen::MatrixXd full = moments.sum().selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd along = full * unit;
    full -= along * unit.transpose() + unit * along.transpose() - unit.dot(along) * unit * unit.transpose();
    return full;
}

Eigen::MatrixXd error_norm(const DenseTerms& terms, double readings)
{
    const auto& layout = terms.geometry.layout;
    const auto row = [&](std::size_t functional) {
        return terms.functionals.row(static_cast<Eigen::Index>(functional));
    };
    const auto states = terms.uniform.size();
    RowMatrix told(static_cast<Eigen::Index>(2 * layout.interfaces + layout.probes), states);
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < layout.interfaces; ++i)
        for (const bool side_b : {false, true})
            told.row(next++) = row(layout.mean(i, side_b));
    for (std::size_t p = 0; p < layout.probes; ++p)
        told.row(next++) = row(layout.probe(p));
    Eigen::MatrixXd norm = Eigen::MatrixXd::Identity(states, states);
    if (next > 0)
        norm += readings * terms.uniform.squaredNorm() / static_cast<double>(next) * (told.transpose() * told);
    return norm;
}

Eigen::MatrixXd most_frequent(const Moments& moments, const Moments& duals, const StateWeights& weights,
                              Eigen::Index count)
{
    const Eigen::VectorXd unit = weights.uniform.normalized();
    const Eigen::LLT<Eigen::MatrixXd> root(weights.norm);
    const Eigen::MatrixXd seen =
        root.matrixU() * (weighted(moments, unit) + weights.dual_share * weighted(duals, unit)) * root.matrixL();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(seen);
    const Eigen::Index others = std::min(count, unit.size()) - 1;
    Eigen::MatrixXd result(unit.size(), 1 + others);
    result << unit, root.matrixU().solve(solver.eigenvectors().rightCols(others)).rowwise().reverse();
    // states that never occur are eigenvectors like any other, and may hold some of the uniform field
    return Eigen::HouseholderQR<Eigen::MatrixXd>(result).householderQ() *
           Eigen::MatrixXd::Identity(unit.size(), result.cols());
}

Eigen::MatrixXd by_conduction(const DenseTerms& terms, const Eigen::MatrixXd& combinations)
{
    const auto others = combinations.rightCols(combinations.cols() - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(others.transpose() * terms.solid * others);
    Eigen::MatrixXd result(combinations.rows(), combinations.cols());
    result << combinations.col(0), others * solver.eigenvectors();
    return result;
}

DenseTerms combined(const DenseTerms& terms, const Eigen::MatrixXd& combinations)
{
    DenseTerms result;
    result.geometry = terms.geometry;
    result.solid = combinations.transpose() * terms.solid * combinations;
    for (const auto& joint : terms.joints)
        result.joints.push_back({combined(joint.aa, combinations), combined(joint.bb, combinations),
                                 combined(joint.between, combinations), combined(joint.turning, combinations)});
    for (const auto& film : terms.films)
        result.films.push_back(combined(film, combinations));
    result.functionals = terms.functionals * combinations;
    result.observed = terms.observed * combinations;
    result.uniform = combinations.transpose() * terms.uniform;
    result.parts = combinations.transpose() * terms.parts;
    return result;
}

}  // namespace deadpoint::reduce
