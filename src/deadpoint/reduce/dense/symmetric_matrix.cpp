#include "deadpoint/reduce/dense/symmetric_matrix.hpp"

#include "deadpoint/reduce/dense/kernels.hpp"

namespace deadpoint::reduce {

using kernels::panel_begin;
using kernels::width;

PaddedNumbers::PaddedNumbers(std::ptrdiff_t count)
    : eights_(static_cast<std::size_t>(kernels::padded(count) / width), Eight{})
{}
std::ptrdiff_t PaddedNumbers::count() const { return width * static_cast<std::ptrdiff_t>(eights_.size()); }
double* PaddedNumbers::data() { return eights_.empty() ? nullptr : eights_.front().numbers; }
const double* PaddedNumbers::data() const { return eights_.empty() ? nullptr : eights_.front().numbers; }

SymmetricMatrix::SymmetricMatrix(const Eigen::MatrixXd& matrix)
    : rows_(matrix.rows()), numbers_(panel_begin(padded_rows(), padded_rows() / width))
{
    for (Eigen::Index column = 0; column < rows_; ++column) {
        const Eigen::Index begin = column / width * width, length = padded_rows() - begin;
        double* to = panels() + panel_begin(padded_rows(), begin / width) + (column - begin) * length;
        for (Eigen::Index row = begin; row < rows_; ++row)
            to[row - begin] = row < column ? matrix(column, row) : matrix(row, column);
    }
}

Eigen::Index SymmetricMatrix::padded_rows() const { return kernels::padded(rows_); }

Eigen::MatrixXd SymmetricMatrix::lower() const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows_, rows_);
    for (Eigen::Index column = 0; column < rows_; ++column) {
        const Eigen::Index begin = column / width * width, length = padded_rows() - begin;
        const double* from = panels() + panel_begin(padded_rows(), begin / width) + (column - begin) * length;
        for (Eigen::Index row = column; row < rows_; ++row)
            result(row, column) = from[row - begin];
    }
    return result;
}

SymmetricMatrix SymmetricMatrix::plus(const std::vector<Term>& terms) const
{
    SymmetricMatrix result = *this;
    std::vector<const double*> matrices;
    std::vector<double> coefficients;
    for (const auto& [coefficient, matrix] : terms) {
        matrices.push_back(matrix->panels());
        coefficients.push_back(coefficient);
    }
    kernels::add_scaled(result.panels(), result.numbers_.count(), matrices.data(), coefficients.data(),
                        static_cast<std::ptrdiff_t>(terms.size()));
    return result;
}

// Every panel has both halves of its first eight rows, and one of the others.
double SymmetricMatrix::product(const SymmetricMatrix& other) const
{
    double sum = 0;
    for (Eigen::Index begin = 0; begin < padded_rows(); begin += width) {
        const Eigen::Index length = padded_rows() - begin, place = panel_begin(padded_rows(), begin / width);
        using Panel = Eigen::Map<const Eigen::MatrixXd>;
        const Panel a(panels() + place, length, width), b(other.panels() + place, length, width);
        sum += a.topRows(width).cwiseProduct(b.topRows(width)).sum() +
               2 * a.bottomRows(length - width).cwiseProduct(b.bottomRows(length - width)).sum();
    }
    return sum;
}

Eigen::VectorXd SymmetricMatrix::times(const Eigen::VectorXd& vector) const
{
    Eigen::VectorXd from = Eigen::VectorXd::Zero(padded_rows()), to = from;
    from.head(rows_) = vector;
    kernels::symmetric_product(panels(), padded_rows(), from.data(), to.data());
    return to.head(rows_);
}

}  // namespace deadpoint::reduce
