#include "deadpoint/reduce/dense/products.hpp"

#include "deadpoint/reduce/dense/kernels.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

constexpr Eigen::Index rows_at_a_time = 32;

}  // namespace

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    RowMatrix result = RowMatrix::Zero(a.cols(), b.cols());
    kernels::add_products({a.data(), a.rows(), a.cols()}, {b.data(), b.rows(), b.cols()}, a.rows(), result.data(),
                          b.cols());
    return result;
}

// A block on the diagonal, then the rows to its right.
Eigen::MatrixXd upper_product(const RowMatrix& upper, const Eigen::MatrixXd& b)
{
    const Eigen::Index n = upper.rows();
    RowMatrix result = RowMatrix::Zero(n, b.cols());
    for (Eigen::Index first = 0; first < n; first += rows_at_a_time) {
        const Eigen::Index count = std::min(rows_at_a_time, n - first), right = first + count;
        result.middleRows(first, count) =
            upper.block(first, first, count, count).triangularView<Eigen::Upper>() * b.middleRows(first, count);
        kernels::add_products({upper.data() + first * n + right, n, count}, {b.data() + right, n, b.cols()}, n - right,
                              result.data() + first * b.cols(), b.cols());
    }
    return result;
}

}  // namespace deadpoint::reduce
