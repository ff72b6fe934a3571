#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>

namespace deadpoint::fem {

/// A 3 by 3 matrix by rows, such as the derivative d position_i / d unit_j of a cell's map.
using Matrix3 = std::array<Vec3, 3>;

constexpr double determinant(const Matrix3& a) { return dot(a[0], cross(a[1], a[2])); }

/// a^-T, which turns slopes on the reference cell into slopes in space. Its rows are the cofactors of a's over the
/// determinant.
/// @param a  not singular; else the result is not finite
constexpr Matrix3 inverse_transposed(const Matrix3& a)
{
    const double scale = 1 / determinant(a);
    return {scale * cross(a[1], a[2]), scale * cross(a[2], a[0]), scale * cross(a[0], a[1])};
}

constexpr Vec3 times(const Matrix3& a, const Vec3& x) { return {dot(a[0], x), dot(a[1], x), dot(a[2], x)}; }

/// a^T x.
constexpr Vec3 times_transposed(const Matrix3& a, const Vec3& x) { return x[0] * a[0] + x[1] * a[1] + x[2] * a[2]; }

/// Adds the outer product x y^T.
constexpr void add_outer(Matrix3& a, const Vec3& x, const Vec3& y)
{
    for (std::size_t i = 0; i < 3; ++i)
        a[i] = a[i] + x[i] * y;
}

}  // namespace deadpoint::fem
