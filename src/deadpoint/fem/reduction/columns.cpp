#include "deadpoint/fem/reduction/columns.hpp"

#include "deadpoint/fem/algebra/session.hpp"

#include <algorithm>
#include <petscblaslapack.h>

namespace deadpoint::fem {
namespace {

using Columns = Eigen::Ref<const Eigen::MatrixXd>;

// left (transposed, if it says so) times right.
void multiply(const char* transposed, const Eigen::MatrixXd& left, const Columns& right, Eigen::MatrixXd& product)
{
    const auto size = [](Eigen::Index n) { return static_cast<PetscBLASInt>(std::max<Eigen::Index>(n, 1)); };
    const auto rows = size(product.rows()), columns = size(product.cols()), inner = size(right.rows());
    const auto left_stride = size(left.rows()), right_stride = size(right.outerStride());
    const double one = 1, zero = 0;
    if (product.size() == 0 || right.rows() == 0)
        product.setZero();
    else
        BLASgemm_(transposed, "N", &rows, &columns, &inner, &one, left.data(), &left_stride, right.data(),
                  &right_stride, &zero, product.data(), &rows);
}

OwnedVec vector_like(Mat matrix)
{
    OwnedVec vector;
    DEADPOINT_PETSC(MatCreateVecs(matrix, vector.out(), nullptr));
    return vector;
}

}  // namespace

void sum_over_ranks(Eigen::MatrixXd& matrix)
{
    const auto size = static_cast<int>(matrix.size());
    MPI_Reduce(rank() == 0 ? MPI_IN_PLACE : matrix.data(), matrix.data(), size, MPI_DOUBLE, MPI_SUM, 0,
               PETSC_COMM_WORLD);
    MPI_Bcast(matrix.data(), size, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
}

Eigen::MatrixXd product_of_transposed(const Eigen::MatrixXd& a, const Columns& b)
{
    Eigen::MatrixXd result(a.cols(), b.cols());
    multiply("T", a, b, result);
    return result;
}

Eigen::MatrixXd combined(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& combinations)
{
    Eigen::MatrixXd result(columns.rows(), combinations.cols());
    multiply("N", columns, combinations, result);
    return result;
}

Eigen::MatrixXd times(Mat matrix, const Eigen::MatrixXd& columns)
{
    Eigen::MatrixXd result(columns.rows(), columns.cols());
    const auto in = vector_like(matrix), out = vector_like(matrix);
    for (Eigen::Index k = 0; k < columns.cols(); ++k) {
        DEADPOINT_PETSC(VecPlaceArray(in, columns.col(k).data()));
        DEADPOINT_PETSC(VecPlaceArray(out, result.col(k).data()));
        DEADPOINT_PETSC(MatMult(matrix, in, out));
        DEADPOINT_PETSC(VecResetArray(in));
        DEADPOINT_PETSC(VecResetArray(out));
    }
    return result;
}

}  // namespace deadpoint::fem
