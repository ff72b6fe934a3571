#include "deadpoint/reduce/dense/tridiagonal.hpp"

#include "deadpoint/heat/system.hpp"
#include "deadpoint/reduce/dense/kernels.hpp"

#include <cmath>
#include <limits>

namespace deadpoint::reduce {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using kernels::panel_begin;
using kernels::width;

using Triangle = Eigen::Matrix<double, width, width, Eigen::RowMajor>;

/// The part of a column that a panel stores, from the panel's first row on.
Eigen::Map<const VectorXd> stored_column(const double* panels, Index size, Index column)
{
    const Index panel = column / width, length = size - panel * width;
    return {panels + panel_begin(size, panel) + (column % width) * length, length};
}

/// 1 - factor v v^T takes a vector to `length` times the first unit vector.
struct Reflection {
    double factor = 0, length = 0;
};
/// @param vector  then v, whose first number is 1
Reflection reflection_of(Eigen::Ref<VectorXd> vector)
{
    const double first = vector[0], rest = vector.tail(vector.size() - 1).squaredNorm();
    Reflection result{0, first};
    vector[0] = 1;
    if (rest <= std::numeric_limits<double>::min()) {
        vector.tail(vector.size() - 1).setZero();
        return result;
    }
    result.length = -std::copysign(std::sqrt(first * first + rest), first);
    result.factor = (result.length - first) / result.length;
    vector.tail(vector.size() - 1) /= first - result.length;
    return result;
}

}  // namespace

// Each pass over the rest of the matrix applies the change A -= v w^T + w v^T of the last reflection and multiplies
// with the next one.
TridiagonalForm::TridiagonalForm(SymmetricMatrix matrix)
    : diagonal(matrix.rows()), beside(std::max<Index>(matrix.rows() - 1, 0)), padded_(matrix.padded_rows()),
      reflectors_(panel_begin(padded_, padded_ / width)), triangles_(padded_ * width)
{
    const Index n = matrix.rows();
    VectorXd v = VectorXd::Zero(padded_), w = v, next = v, product = v, column = v;
    for (Index k = 0; k < n; ++k) {
        const Index top = k / width * width, left = n - k;
        column.tail(padded_ - top) = stored_column(matrix.panels(), padded_, k);
        column.segment(k, left) -= w[k] * v.segment(k, left) + v[k] * w.segment(k, left);
        diagonal[k] = column[k];
        if (k + 1 == n)
            break;
        auto reflector = column.segment(k + 1, left - 1);
        const auto [factor, length] = reflection_of(reflector);
        beside[k] = length;
        next.setZero();
        next.segment(k + 1, left - 1) = reflector;
        take_reflector(k, factor, next);
        product.setZero();
        kernels::update_and_multiply(matrix.panels(), padded_, (k + 1) / width, v.data(), w.data(), next.data(),
                                     product.data());
        product.head(k + 1).setZero();
        v.swap(next);
        w = factor * product;
        w -= factor / 2 * w.dot(v) * v;
    }
    for (Index panel = 0; panel < padded_ / width; ++panel)
        finish_panel(panel);
}

void TridiagonalForm::take_reflector(Index column, double factor, const VectorXd& reflector)
{
    const Index panel = column / width, length = padded_ - panel * width;
    Eigen::Map<VectorXd>(reflectors_.data() + panel_begin(padded_, panel) + (column % width) * length, length) =
        reflector.tail(length);
    triangles_.data()[width * column + column % width] = factor;
}

// T of V: T_ii is the factor of reflection i, and above it stands -factor T V^T v_i.
void TridiagonalForm::finish_panel(Index panel)
{
    Eigen::Map<Triangle> triangle(triangles_.data() + panel * width * width);
    for (Index i = 1; i < width; ++i) {
        const auto reflector = stored_column(reflectors_.data(), padded_, panel * width + i);
        VectorXd products(i);
        for (Index k = 0; k < i; ++k)
            products[k] = stored_column(reflectors_.data(), padded_, panel * width + k).dot(reflector);
        triangle.col(i).head(i) = -triangle(i, i) * (triangle.topLeftCorner(i, i) * products);
    }
}

void TridiagonalForm::reflect(bool transposed, Eigen::Ref<Eigen::MatrixXd> columns) const
{
    VectorXd padded = VectorXd::Zero(padded_);
    for (Index k = 0; k < columns.cols(); ++k) {
        padded.head(columns.rows()) = columns.col(k);
        kernels::reflect(reflectors_.data(), padded_, triangles_.data(), transposed, padded.data());
        columns.col(k) = padded.head(columns.rows());
    }
}
void TridiagonalForm::into_basis(Eigen::Ref<Eigen::MatrixXd> columns) const { reflect(true, columns); }
void TridiagonalForm::from_basis(Eigen::Ref<Eigen::MatrixXd> columns) const { reflect(false, columns); }

ShiftedFactor::ShiftedFactor(const TridiagonalForm& form, double d)
    : below(form.diagonal.size()), pivots(form.diagonal.size())
{
    double pivot = 0;
    for (Eigen::Index i = 0; i < below.size(); ++i) {
        const double beside = i > 0 ? d * form.beside[i - 1] : 0;
        below[i] = i > 0 ? beside / pivot : 0;
        pivot = 1 + d * form.diagonal[i] - below[i] * beside;
        if (!(pivot > 0) || !std::isfinite(pivot))
            throw heat::NotFinite(
                "the matrix of a stage is not positive definite, or holds a value that is not finite");
        pivots[i] = 1 / pivot;
    }
}

void ShiftedFactor::solve_in_place(Eigen::Ref<Eigen::MatrixXd> columns) const
{
    const Eigen::Index n = columns.rows();
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
        auto column = columns.col(k);
        for (Eigen::Index i = 1; i < n; ++i)
            column[i] -= below[i] * column[i - 1];
        column.array() *= pivots.array();
        for (Eigen::Index i = n - 2; i >= 0; --i)
            column[i] -= below[i + 1] * column[i + 1];
    }
}

}  // namespace deadpoint::reduce
