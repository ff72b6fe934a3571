#pragma once

#include <cstddef>

/// Internal to reduce/: products with small dense matrices, compiled for several processors in one program. They know
/// no Eigen, whose templates must not be compiled for two processors.
///
/// A symmetric matrix or a set of reflectors lies in panels of eight columns: panel b has the columns from 8 b, each
/// from row 8 b to the last, one after the other. Sizes are filled up with zeros to a multiple of eight, so vectors
/// that go with panels have that length too.
namespace deadpoint::reduce::kernels {

inline constexpr std::ptrdiff_t width = 8;  ///< columns of a panel

/// Sizes with the zeros that fill up.
constexpr std::ptrdiff_t padded(std::ptrdiff_t n) { return (n + width - 1) / width * width; }
/// Place of the first number of panel b. @param size  padded
constexpr std::ptrdiff_t panel_begin(std::ptrdiff_t size, std::ptrdiff_t b)
{
    return width * (b * size - width * b * (b - 1) / 2);
}

/// y = A x for `rows` rows of n numbers, which begin `stride` numbers apart.
void row_products(const double* a, std::ptrdiff_t stride, std::ptrdiff_t rows, std::ptrdiff_t n, const double* x,
                  double* y);
/// y += A^T w of the same rows.
void add_rows(const double* a, std::ptrdiff_t stride, std::ptrdiff_t rows, std::ptrdiff_t n, const double* w,
              double* y);
/// Rows of a matrix, which begin `stride` numbers apart.
struct Rows {
    const double* numbers = nullptr;
    std::ptrdiff_t stride = 0, count = 0;
};
/// C += A B^T of rows of n numbers. @param stride  of the rows of c, one for each row of a
void add_products(const Rows& a, const Rows& b, std::ptrdiff_t n, double* c, std::ptrdiff_t stride);
/// sum += the sum of coefficient times matrix. @param length  of each, a multiple of eight
void add_scaled(double* sum, std::ptrdiff_t length, const double* const* matrices, const double* coefficients,
                std::ptrdiff_t count);

/// y += A x of a symmetric A in panels.
void symmetric_product(const double* panels, std::ptrdiff_t size, const double* x, double* y);
/// A -= v w^T + w v^T, then y += A x, in one pass over the panels from `first`: rows before it are taken as zero.
void update_and_multiply(double* panels, std::ptrdiff_t size, std::ptrdiff_t first, const double* v, const double* w,
                         const double* x, double* y);

/// x = H x with the product H of all reflectors 1 - tau v v^T in the order of the columns, or H^T x. Each panel of them
/// is 1 - V T V^T (compact WY form: Schreiber and Van Loan, SIAM J. Sci. Stat. Comput. 10, 1989).
/// @param triangles  T of each panel, row by row
void reflect(const double* panels, std::ptrdiff_t size, const double* triangles, bool transposed, double* x);

}  // namespace deadpoint::reduce::kernels
