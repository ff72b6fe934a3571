#include "deadpoint/reduce/offline/gram.hpp"

#include <vector>

namespace deadpoint::reduce {
namespace {

struct PivotedRoot {
    Eigen::MatrixXd root;  ///< lower triangle, of the chosen fields in their order
    std::vector<Eigen::Index> chosen;
};

// Of a matrix with ones on its diagonal.
PivotedRoot pivoted_root(const Eigen::MatrixXd& gram, double least)
{
    const Eigen::Index count = gram.rows();
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd left = gram.diagonal();
    PivotedRoot result;
    for (Eigen::Index k = 0; k < count; ++k) {
        Eigen::Index pivot = 0;
        if (k > 0)
            left.maxCoeff(&pivot);
        if (!(left[pivot] > least * least) || !(left[pivot] > 0))
            break;
        const double size = std::sqrt(left[pivot]);
        columns.col(k) = (gram.col(pivot) - columns.leftCols(k) * columns.row(pivot).head(k).transpose()) / size;
        left -= columns.col(k).cwiseAbs2();
        result.chosen.push_back(pivot);
        for (const auto done : result.chosen)
            left[done] = -1;
    }
    const auto rank = static_cast<Eigen::Index>(result.chosen.size());
    result.root = columns(result.chosen, Eigen::seqN(0, rank));
    return result;
}

}  // namespace

Eigen::MatrixXd orthonormal_combinations(const Eigen::MatrixXd& gram, double least)
{
    const Eigen::VectorXd scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const auto [root, chosen] = pivoted_root(scale.asDiagonal() * gram * scale.asDiagonal(), least);
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
