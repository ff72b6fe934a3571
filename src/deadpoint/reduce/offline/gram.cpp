#include "deadpoint/reduce/offline/gram.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace deadpoint::reduce {
namespace {

struct PivotedRoot {
    Eigen::MatrixXd root;  ///< lower triangle, of the chosen fields in their order
    std::vector<Eigen::Index> chosen;
};

// The field whose weight times its new part is largest. @param left  squares of the new parts
std::optional<Eigen::Index> next_field(const Eigen::VectorXd& left, const FieldChoice& choice)
{
    std::optional<Eigen::Index> best;
    double largest = 0;
    for (Eigen::Index k = 0; k < left.size(); ++k) {
        const double weight = choice.weight[static_cast<std::size_t>(k)];
        if (left[k] > choice.least * choice.least && weight * weight * left[k] > largest) {
            largest = weight * weight * left[k];
            best = k;
        }
    }
    return best;
}

// Pivoted root of a matrix with ones on its diagonal.
PivotedRoot pivoted_root(const Eigen::MatrixXd& gram, const FieldChoice& choice)
{
    const Eigen::Index count = gram.rows();
    const auto most = std::min(count, static_cast<Eigen::Index>(choice.most));
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count, most);
    Eigen::VectorXd left = gram.diagonal();
    PivotedRoot result;
    std::optional<Eigen::Index> pivot = 0;
    for (Eigen::Index k = 0; k < most && pivot; ++k) {
        const double size = std::sqrt(left[*pivot]);
        columns.col(k) = (gram.col(*pivot) - columns.leftCols(k) * columns.row(*pivot).head(k).transpose()) / size;
        left -= columns.col(k).cwiseAbs2();
        result.chosen.push_back(*pivot);
        for (const auto done : result.chosen)
            left[done] = -1;
        pivot = next_field(left, choice);
    }
    const auto rank = static_cast<Eigen::Index>(result.chosen.size());
    result.root = columns(result.chosen, Eigen::seqN(0, rank));
    return result;
}

}  // namespace

Eigen::MatrixXd orthonormal_combinations(const Eigen::MatrixXd& gram, const FieldChoice& choice)
{
    const Eigen::VectorXd scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const auto [root, chosen] = pivoted_root(scale.asDiagonal() * gram * scale.asDiagonal(), choice);
    const auto rank = static_cast<Eigen::Index>(chosen.size());
    const Eigen::MatrixXd inverse = root.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(rank, rank));
    Eigen::MatrixXd combinations = Eigen::MatrixXd::Zero(gram.rows(), rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const auto field = chosen[static_cast<std::size_t>(k)];
        combinations.row(field) = scale[field] * inverse.col(k).transpose();
    }
    return combinations;
}

}  // namespace deadpoint::reduce
