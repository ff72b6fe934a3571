#include "deadpoint/exchange/stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deadpoint {

double von_mises(const Tensor6& s)
{
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

// Roots of the characteristic polynomial in trigonometric form (Smith, Commun. ACM 4, 1961).
std::array<double, 3> principal(const Tensor6& s)
{
    const double mean = (s[0] + s[1] + s[2]) / 3;
    const double x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
    const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    const double radius = std::sqrt((x * x + y * y + z * z + 2 * shear) / 6);
    if (radius <= 0)
        return {mean, mean, mean};
    const double determinant = x * y * z + 2 * s[3] * s[4] * s[5] - x * s[4] * s[4] - y * s[5] * s[5] - z * s[3] * s[3];
    const double angle = std::acos(std::clamp(determinant / (2 * radius * radius * radius), -1.0, 1.0)) / 3;
    const double third = 2 * std::numbers::pi / 3;
    return {mean + 2 * radius * std::cos(angle), mean + 2 * radius * std::cos(angle - third),
            mean + 2 * radius * std::cos(angle + third)};
}

double normal_stress(const Tensor6& s, const std::array<double, 3>& n)
{
    return s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + s[2] * n[2] * n[2] +
           2 * (s[3] * n[0] * n[1] + s[4] * n[1] * n[2] + s[5] * n[2] * n[0]);
}

}  // namespace deadpoint
