#include "deadpoint/fem/algebra/sparse_factor.hpp"

#include "deadpoint/error.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint::fem;

namespace {

constexpr PetscInt block = 3, nodes = 40, size = block * nodes;

// A chain of nodes with longer couplings here and there; every coupled pair has a full block.
Eigen::MatrixXd chain(double diagonal)
{
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
    const auto couple = [&](PetscInt a, PetscInt b) {
        for (PetscInt i = 0; i < block; ++i)
            for (PetscInt j = 0; j < block; ++j)
                dense(block * a + i, block * b + j) = dense(block * b + j, block * a + i) =
                    std::sin(1.0 + a + 2.0 * b + 3.0 * i * j);
    };
    for (PetscInt a = 0; a + 1 < nodes; ++a)
        couple(a, a + 1);
    for (PetscInt a = 0; a + 7 < nodes; a += 5)
        couple(a, a + 7);
    dense.diagonal().setConstant(diagonal);
    return dense;
}

OwnedMat sparse(const Eigen::MatrixXd& dense)
{
    OwnedMat matrix;
    const auto rows = static_cast<PetscInt>(dense.rows());
    DEADPOINT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, rows, rows, rows, nullptr, matrix.out()));
    for (PetscInt i = 0; i < rows; ++i)
        for (PetscInt j = 0; j < rows; ++j)
            if (i == j || dense(i, j) != 0)
                DEADPOINT_PETSC(MatSetValue(matrix, i, j, dense(i, j), INSERT_VALUES));
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return matrix;
}

Eigen::MatrixXd columns(Eigen::Index rows, Eigen::Index count)
{
    Eigen::MatrixXd result(rows, count);
    for (Eigen::Index i = 0; i < result.size(); ++i)
        result.data()[i] = std::cos(1.0 + static_cast<double>(i));
    return result;
}

// A view; `values` must outlive it.
OwnedMat dense_view(const Eigen::MatrixXd& values)
{
    OwnedMat view;
    DEADPOINT_PETSC(MatCreateSeqDense(PETSC_COMM_SELF, static_cast<PetscInt>(values.rows()),
                                      static_cast<PetscInt>(values.cols()), const_cast<double*>(values.data()),
                                      view.out()));
    return view;
}

Eigen::MatrixXd solve(SparseFactor& factor, const Eigen::MatrixXd& right)
{
    Eigen::MatrixXd solution(right.rows(), right.cols());
    factor.solve(dense_view(right), dense_view(solution));
    return solution;
}

}  // namespace

TEST_CASE("the upper half of a matrix multiplies like the whole one, any number of columns")
{
    const auto dense = chain(30);
    const SymmetricTriplets half(sparse(dense));
    CHECK(half.value.size() == static_cast<std::size_t>(((dense.array() != 0).count() + size) / 2));
    for (const Eigen::Index count : {1, 8, 11}) {
        const auto x = columns(size, count);
        Eigen::MatrixXd y(size, count);
        half.multiply(dense_view(x), dense_view(y));
        CHECK((y - dense * x).norm() < 1e-14 * dense.norm() * x.norm());  // rounding of some ten terms
    }
}

TEST_CASE("a sparse factor solves for many columns, with new values of the same pattern too")
{
    const auto right = columns(size, 40);  // more than are solved at once
    SparseFactor factor(SymmetricTriplets(sparse(chain(1))), block);
    for (const double diagonal : {30.0, 12.0}) {
        const auto dense = chain(diagonal);
        factor.factorise(SymmetricTriplets(sparse(dense)));
        const Eigen::MatrixXd exact = dense.llt().solve(right);
        CHECK((solve(factor, right) - exact).norm() < 1e-13 * exact.norm());  // a condition of about 10
    }
}

TEST_CASE("a factor is made again as often as a build of a reduced press asks for")
{
    const auto dense = chain(30);
    const SymmetricTriplets matrix(sparse(dense));
    const auto right = columns(size, 1);
    SparseFactor factor(matrix, block);
    for (int k = 0; k < 100; ++k)
        factor.factorise(matrix);
    CHECK((dense * solve(factor, right) - right).norm() < 1e-13 * right.norm());
}

TEST_CASE("nodes without couplings, and a single one, need no order")
{
    for (const PetscInt count : {1, 5}) {
        const Eigen::MatrixXd dense = 4 * Eigen::MatrixXd::Identity(count, count);
        SparseFactor factor(SymmetricTriplets(sparse(dense)), 1);
        factor.factorise(SymmetricTriplets(sparse(dense)));
        CHECK((solve(factor, columns(count, 2)) - 0.25 * columns(count, 2)).norm() < 1e-15);
    }
}

TEST_CASE("a singular matrix has no factor")
{
    Eigen::MatrixXd dense = chain(30);
    dense.row(7).setZero();
    dense.col(7).setZero();
    SparseFactor factor(SymmetricTriplets(sparse(dense)), block);
    CHECK_THROWS_AS(factor.factorise(SymmetricTriplets(sparse(dense))), deadpoint::ConvergenceError);
}
