#pragma once

#include <array>
#include <cmath>

namespace deadpoint {

/// A point or vector in machine coordinates [m]: x right, y up, z along the crankshaft.
using Vec3 = std::array<double, 3>;
/// A point or vector in the plane of the linkage [m].
using Vec2 = std::array<double, 2>;

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalised(const Vec3& a) { return (1.0 / norm(a)) * a; }

constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a[0] + b[0], a[1] + b[1]}; }
constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }
constexpr Vec2 operator*(double s, const Vec2& a) { return {s * a[0], s * a[1]}; }
constexpr double dot(const Vec2& a, const Vec2& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double norm(const Vec2& a) { return std::sqrt(dot(a, a)); }
inline bool is_finite(const Vec2& a) { return std::isfinite(a[0]) && std::isfinite(a[1]); }

}  // namespace deadpoint
