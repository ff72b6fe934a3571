#include "deadpoint/reduce/online/tridiagonal.hpp"

#include "deadpoint/heat/system.hpp"

#include <cmath>

namespace deadpoint::reduce {

TridiagonalForm::TridiagonalForm(const Eigen::MatrixXd& matrix)
{
    const Eigen::Tridiagonalization<Eigen::MatrixXd> found(matrix);
    basis = found.matrixQ();
    diagonal = found.diagonal();
    beside = found.subDiagonal();
}

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
