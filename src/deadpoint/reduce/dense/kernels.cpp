#include "deadpoint/reduce/dense/kernels.hpp"

#include <algorithm>
#include <cstring>

// The compiler makes each function for processors with AVX-512, with AVX2, and for all; the program takes the one that
// fits when it starts. Sanitizers do not bear such functions, and clang 14 does not know these names of processors.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&          \
    !defined(__SANITIZE_THREAD__)
#define DEADPOINT_FOR_PROCESSORS [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define DEADPOINT_FOR_PROCESSORS
#endif

namespace deadpoint::reduce::kernels {
namespace {

using Size = std::ptrdiff_t;
constexpr Size lanes = 4;  // with eight, the accumulators of four rows overflow the registers of AVX2 and SSE2
using Lanes [[gnu::vector_size(lanes * sizeof(double))]] = double;

constexpr Size part_length = 4096;  // numbers of a sum that stay in the nearest cache

// By reference, since how vectors are passed by value depends on the processor.
[[gnu::always_inline]] inline void load(Lanes& to, const double* from) { std::memcpy(&to, from, sizeof(Lanes)); }
[[gnu::always_inline]] inline void store(double* to, const Lanes& from) { std::memcpy(to, &from, sizeof(Lanes)); }
[[gnu::always_inline]] inline double sum_of(const Lanes& v) { return (v[0] + v[2]) + (v[1] + v[3]); }

// Four columns of a panel below its first eight rows: y += A x, and the sums of A^T x. Before, if `update`,
// A -= v w^T + w v^T. All pointers are to the first row of the panel, `column` is the first of the four.
template <bool update, typename Number>
[[gnu::always_inline]] inline void multiply_columns(Number* a, Size length, Size column, const double* v,
                                                    const double* w, const double* x, double* y)
{
    Number *a0 = a + column * length, *a1 = a0 + length, *a2 = a1 + length, *a3 = a2 + length;
    Lanes s0{}, s1{}, s2{}, s3{};
    const double *xc = x + column, *vc = v + column, *wc = w + column;
    for (Size i = width; i < length; i += lanes) {
        Lanes c0, c1, c2, c3, xi, yi;
        load(c0, a0 + i);
        load(c1, a1 + i);
        load(c2, a2 + i);
        load(c3, a3 + i);
        if constexpr (update) {
            Lanes vi, wi;
            load(vi, v + i);
            load(wi, w + i);
            c0 -= vi * wc[0];
            c0 -= wi * vc[0];
            c1 -= vi * wc[1];
            c1 -= wi * vc[1];
            c2 -= vi * wc[2];
            c2 -= wi * vc[2];
            c3 -= vi * wc[3];
            c3 -= wi * vc[3];
            store(a0 + i, c0);
            store(a1 + i, c1);
            store(a2 + i, c2);
            store(a3 + i, c3);
        }
        load(xi, x + i);
        load(yi, y + i);
        s0 += c0 * xi;
        s1 += c1 * xi;
        s2 += c2 * xi;
        s3 += c3 * xi;
        yi += c0 * xc[0];
        yi += c1 * xc[1];
        yi += c2 * xc[2];
        yi += c3 * xc[3];
        store(y + i, yi);
    }
    double* yc = y + column;
    yc[0] += sum_of(s0);
    yc[1] += sum_of(s1);
    yc[2] += sum_of(s2);
    yc[3] += sum_of(s3);
}

// The first eight rows of a panel, of which both halves are stored.
template <bool update, typename Number>
[[gnu::always_inline]] inline void multiply_corner(Number* a, Size length, const double* v, const double* w,
                                                   const double* x, double* y)
{
    for (Size at = 0; at < width; at += lanes) {
        Lanes top;
        load(top, y + at);
#pragma GCC unroll 8
        for (Size c = 0; c < width; ++c) {
            Lanes column;
            load(column, a + c * length + at);
            if constexpr (update) {
                Lanes vi, wi;
                load(vi, v + at);
                load(wi, w + at);
                column -= vi * w[c];
                column -= wi * v[c];
                store(a + c * length + at, column);
            }
            top += column * x[c];
        }
        store(y + at, top);
    }
}

template <bool update, typename Number>
[[gnu::always_inline]] inline void multiply_panels(Number* panels, Size size, Size first, const double* v,
                                                   const double* w, const double* x, double* y)
{
    for (Size begin = first * width; begin < size; begin += width) {
        Number* panel = panels + panel_begin(size, begin / width);
        const Size length = size - begin;
        multiply_corner<update>(panel, length, v + begin, w + begin, x + begin, y + begin);
        multiply_columns<update>(panel, length, 0, v + begin, w + begin, x + begin, y + begin);
        multiply_columns<update>(panel, length, width / 2, v + begin, w + begin, x + begin, y + begin);
    }
}

template <Size rows>
[[gnu::always_inline]] inline void products_of(const double* a, Size stride, Size n, const double* x, double* y)
{
    Lanes sums[rows]{};
    Size i = 0;
    for (; i + lanes <= n; i += lanes) {
        Lanes xi;
        load(xi, x + i);
#pragma GCC unroll 8
        for (Size r = 0; r < rows; ++r) {
            Lanes row;
            load(row, a + r * stride + i);
            sums[r] += row * xi;
        }
    }
#pragma GCC unroll 8
    for (Size r = 0; r < rows; ++r) {
        double sum = sum_of(sums[r]);
        for (Size k = i; k < n; ++k)
            sum += a[r * stride + k] * x[k];
        y[r] = sum;
    }
}

template <Size rows>
[[gnu::always_inline]] inline void add_products_of(const double* a, Size stride, Size n, const double* w, double* y)
{
    Size i = 0;
    for (; i + lanes <= n; i += lanes) {
        Lanes sum;
        load(sum, y + i);
#pragma GCC unroll 8
        for (Size r = 0; r < rows; ++r) {
            Lanes row;
            load(row, a + r * stride + i);
            sum += row * w[r];
        }
        store(y + i, sum);
    }
    for (; i < n; ++i)
        for (Size r = 0; r < rows; ++r)
            y[i] += a[r * stride + i] * w[r];
}

template <Size count>
[[gnu::always_inline]] inline void add_part(double* sum, Size begin, Size end, const double* const* matrices,
                                            const double* coefficients)
{
    for (Size i = begin; i < end; i += lanes) {
        Lanes all;
        load(all, sum + i);
#pragma GCC unroll 8
        for (Size k = 0; k < count; ++k) {
            Lanes term;
            load(term, matrices[k] + i);
            all += term * coefficients[k];
        }
        store(sum + i, all);
    }
}

constexpr Size block_length = 512;  // numbers of a row that stay in the nearest cache while they are multiplied

template <Size rows, Size columns>
[[gnu::always_inline]] inline void add_block(const double* a, Size stride_a, const double* b, Size stride_b, Size n,
                                             double* c, Size stride)
{
    Lanes sums[rows][columns]{};
    Size i = 0;
    for (; i + lanes <= n; i += lanes) {
        Lanes of_a[rows], of_b[columns];
#pragma GCC unroll 8
        for (Size r = 0; r < rows; ++r)
            load(of_a[r], a + r * stride_a + i);
#pragma GCC unroll 8
        for (Size k = 0; k < columns; ++k)
            load(of_b[k], b + k * stride_b + i);
#pragma GCC unroll 8
        for (Size r = 0; r < rows; ++r)
#pragma GCC unroll 8
            for (Size k = 0; k < columns; ++k)
                sums[r][k] += of_a[r] * of_b[k];
    }
#pragma GCC unroll 8
    for (Size r = 0; r < rows; ++r)
#pragma GCC unroll 8
        for (Size k = 0; k < columns; ++k) {
            double sum = sum_of(sums[r][k]);
            for (Size left = i; left < n; ++left)
                sum += a[r * stride_a + left] * b[k * stride_b + left];
            c[r * stride + k] += sum;
        }
}

template <Size rows>
[[gnu::always_inline]] inline void add_row_block(const double* a, Size stride_a, const Rows& b, Size begin, Size n,
                                                 double* c, Size stride)
{
    Size k = 0;
    for (; k + 4 <= b.count; k += 4)
        add_block<rows, 4>(a + begin, stride_a, b.numbers + k * b.stride + begin, b.stride, n, c + k, stride);
    for (; k < b.count; ++k)
        add_block<rows, 1>(a + begin, stride_a, b.numbers + k * b.stride + begin, b.stride, n, c + k, stride);
}

// u = T s or T^T s of a triangle T whose upper half counts.
[[gnu::always_inline]] inline void multiply_triangle(const double* t, bool transposed, const double* s, double* u)
{
    for (Size i = 0; i < width; ++i) {
        u[i] = 0;
        for (Size k = transposed ? 0 : i; k < (transposed ? i + 1 : width); ++k)
            u[i] += (transposed ? t[k * width + i] : t[i * width + k]) * s[k];
    }
}

[[gnu::always_inline]] inline void reflect_panel(const double* panel, Size length, const double* triangle,
                                                 bool transposed, double* x)
{
    double s[width], u[width];
    products_of<width / 2>(panel, length, length, x, s);
    products_of<width / 2>(panel + width / 2 * length, length, length, x, s + width / 2);
    multiply_triangle(triangle, transposed, s, u);
    for (double& factor : u)
        factor = -factor;
    add_products_of<width>(panel, length, length, u, x);
}

}  // namespace

DEADPOINT_FOR_PROCESSORS
void row_products(const double* a, Size stride, Size rows, Size n, const double* x, double* y)
{
    Size r = 0;
    for (; r + 4 <= rows; r += 4)
        products_of<4>(a + r * stride, stride, n, x, y + r);
    for (; r < rows; ++r)
        products_of<1>(a + r * stride, stride, n, x, y + r);
}

DEADPOINT_FOR_PROCESSORS
void add_rows(const double* a, Size stride, Size rows, Size n, const double* w, double* y)
{
    Size r = 0;
    for (; r + 8 <= rows; r += 8)
        add_products_of<8>(a + r * stride, stride, n, w + r, y);
    for (; r < rows; ++r)
        add_products_of<1>(a + r * stride, stride, n, w + r, y);
}

DEADPOINT_FOR_PROCESSORS
void add_products(const Rows& a, const Rows& b, Size n, double* c, Size stride)
{
    for (Size begin = 0; begin < n; begin += block_length) {
        const Size length = std::min(block_length, n - begin);
        Size r = 0;
        for (; r + 4 <= a.count; r += 4)
            add_row_block<4>(a.numbers + r * a.stride, a.stride, b, begin, length, c + r * stride, stride);
        for (; r < a.count; ++r)
            add_row_block<1>(a.numbers + r * a.stride, a.stride, b, begin, length, c + r * stride, stride);
    }
}

DEADPOINT_FOR_PROCESSORS
void add_scaled(double* sum, Size length, const double* const* matrices, const double* coefficients, Size count)
{
    for (Size begin = 0; begin < length; begin += part_length) {
        const Size end = std::min(begin + part_length, length);
        Size k = 0;
        for (; k + 4 <= count; k += 4)
            add_part<4>(sum, begin, end, matrices + k, coefficients + k);
        for (; k < count; ++k)
            add_part<1>(sum, begin, end, matrices + k, coefficients + k);
    }
}

DEADPOINT_FOR_PROCESSORS
void symmetric_product(const double* panels, Size size, const double* x, double* y)
{
    multiply_panels<false>(panels, size, 0, x, x, x, y);
}

DEADPOINT_FOR_PROCESSORS
void update_and_multiply(double* panels, Size size, Size first, const double* v, const double* w, const double* x,
                         double* y)
{
    multiply_panels<true>(panels, size, first, v, w, x, y);
}

DEADPOINT_FOR_PROCESSORS
void reflect(const double* panels, Size size, const double* triangles, bool transposed, double* x)
{
    const Size count = size / width;
    for (Size k = 0; k < count; ++k) {
        const Size b = transposed ? k : count - 1 - k;
        reflect_panel(panels + panel_begin(size, b), size - width * b, triangles + width * width * b, transposed,
                      x + width * b);
    }
}

}  // namespace deadpoint::reduce::kernels
