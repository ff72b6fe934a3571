/// Requirement: products with small dense matrices, their sums and their tridiagonal form are those of Eigen, for sizes
/// that fill panels of eight columns and sizes that do not.
#include "deadpoint/reduce/dense/kernels.hpp"
#include "deadpoint/reduce/dense/products.hpp"
#include "deadpoint/reduce/dense/symmetric_matrix.hpp"
#include "deadpoint/reduce/dense/tridiagonal.hpp"
#include "deadpoint/reduce/online/conduction.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using reduce::SymmetricMatrix;
using reduce::TridiagonalForm;

namespace {

// Sums of at most 200 products of numbers of size 1 in another order.
constexpr double rounding = 1e-13;

constexpr int sizes[] = {1, 2, 7, 8, 9, 40, 61, 200};

MatrixXd any_symmetric(Eigen::Index n)
{
    const MatrixXd any = MatrixXd::Random(n, n);
    return any + any.transpose();
}

MatrixXd whole(const TridiagonalForm& form)
{
    const Eigen::Index n = form.diagonal.size();
    MatrixXd result = form.diagonal.asDiagonal();
    result.diagonal(1) = result.diagonal(-1) = form.beside;
    form.from_basis(result);
    result.transposeInPlace();
    form.from_basis(result);
    REQUIRE(result.rows() == n);
    return result;
}

}  // namespace

TEST_CASE("products with rows and with their transpose are those of the matrix")
{
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    std::srand(1);
    for (const int n : sizes)
        for (const int rows : {0, 1, 3, 4, 8, 13}) {
            const Rows a = Rows::Random(rows, n);
            const VectorXd x = VectorXd::Random(n), w = VectorXd::Random(rows), start = VectorXd::Random(n);
            VectorXd y(rows), sum = start;
            reduce::kernels::row_products(a.data(), n, rows, n, x.data(), y.data());
            CHECK((y - a * x).norm() <= rounding * (1 + y.norm()));
            reduce::kernels::add_rows(a.data(), n, rows, n, w.data(), sum.data());
            CHECK((sum - start - a.transpose() * w).norm() <= rounding * (1 + sum.norm()));
        }
}

TEST_CASE("products of two matrices are those of Eigen, in one block of rows and in several")
{
    std::srand(4);
    for (const int n : {1, 9, 61, 530, 1100}) {
        const MatrixXd a = MatrixXd::Random(n, 7), b = MatrixXd::Random(n, 10);
        const MatrixXd expected = a.transpose() * b;
        CHECK((reduce::transposed_product(a, b) - expected).norm() <= rounding * n);
    }
    for (const int n : {1, 31, 32, 61, 200}) {
        const reduce::RowMatrix any = reduce::RowMatrix::Random(n, n);  // nothing below the diagonal is read
        const MatrixXd b = MatrixXd::Random(n, 6), expected = any.triangularView<Eigen::Upper>() * b;
        CHECK((reduce::upper_product(any, b) - expected).norm() <= rounding * n);
    }
}

TEST_CASE("a symmetric matrix keeps its lower half, multiplies, and is summed with any number of terms")
{
    std::srand(2);
    for (const int n : sizes) {
        std::vector<MatrixXd> matrices;
        std::vector<SymmetricMatrix> packed;
        std::vector<SymmetricMatrix::Term> terms;
        for (int k = 0; k < 6; ++k) {
            matrices.push_back(any_symmetric(n));
            const MatrixXd lower = matrices.back().triangularView<Eigen::Lower>();
            packed.emplace_back(lower);  // nothing above the diagonal is read
        }
        const MatrixXd lower = matrices[0].triangularView<Eigen::Lower>();
        CHECK(packed[0].lower() == lower);
        CHECK(packed[0].product(packed[1]) == near(matrices[0].cwiseProduct(matrices[1]).sum(), rounding * n));
        MatrixXd expected = matrices[0];
        for (std::size_t count = 1; count <= 6; ++count) {
            const VectorXd x = VectorXd::Random(n);
            const SymmetricMatrix sum = packed[0].plus(terms);
            CHECK((sum.times(x) - expected * x).norm() <= rounding * expected.norm());
            if (count < 6) {
                terms.push_back({0.3 * static_cast<double>(count), &packed[count]});
                expected += terms.back().coefficient * matrices[count];
            }
        }
    }
}

TEST_CASE("the tridiagonal form is the matrix again, in an orthonormal basis, with its eigenvalues")
{
    std::srand(3);
    for (const int n : sizes) {
        const MatrixXd matrix = any_symmetric(n);
        const TridiagonalForm form{SymmetricMatrix(matrix)};
        CHECK((whole(form) - matrix).norm() <= rounding * matrix.norm());
        MatrixXd unit = MatrixXd::Identity(n, n);
        form.into_basis(unit);
        CHECK((unit * unit.transpose() - MatrixXd::Identity(n, n)).norm() <= rounding * n);
        form.from_basis(unit);
        CHECK((unit - MatrixXd::Identity(n, n)).norm() <= rounding * n);
        Eigen::SelfAdjointEigenSolver<MatrixXd> of_form, of_matrix(matrix, Eigen::EigenvaluesOnly);
        of_form.computeFromTridiagonal(form.diagonal, form.beside, Eigen::EigenvaluesOnly);
        CHECK((of_form.eigenvalues() - of_matrix.eigenvalues()).norm() <= rounding * matrix.norm());
    }
}

TEST_CASE("a matrix that is tridiagonal or zero already stays as it is")
{
    MatrixXd matrix = MatrixXd::Zero(12, 12);
    matrix.diagonal().setLinSpaced(1, 12);
    for (const double beside : {0.0, 2.0}) {
        matrix.diagonal(1).setConstant(beside);
        matrix.diagonal(-1).setConstant(beside);
        const TridiagonalForm form{SymmetricMatrix(matrix)};
        CHECK(form.diagonal == matrix.diagonal());
        CHECK(form.beside == VectorXd::Constant(11, beside));
    }
}

TEST_CASE("equal sums of terms share one matrix, others do not")
{
    const SymmetricMatrix start(any_symmetric(5)), term(any_symmetric(5));
    reduce::Conductions sums;
    const auto sum_with = [&](double weight) {
        return sums.get({{0, weight}}, [&] { return start.plus({{weight, &term}}); });
    };
    const auto first = sum_with(2);
    CHECK(sum_with(2) == first);
    CHECK(sum_with(3) != first);
    for (int k = 4; k < 20; ++k)
        sum_with(k);
    const auto again = sum_with(2);
    CHECK(again != first);  // forgotten since
    CHECK(again->matrix().lower() == first->matrix().lower());
    CHECK(again->form() == again->form());
}
