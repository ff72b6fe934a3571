#include "deadpoint/machine/polygon.hpp"

#include <cmath>

namespace deadpoint::machine {

namespace {

double wedge(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

void append_triangle(const Vec2& a, const Vec2& b, const Vec2& c, std::vector<PlanePoint>& points)
{
    const double weight = wedge(b - a, c - a) / 6;
    points.push_back({(2.0 / 3) * a + (1.0 / 6) * b + (1.0 / 6) * c, weight});
    points.push_back({(1.0 / 6) * a + (2.0 / 3) * b + (1.0 / 6) * c, weight});
    points.push_back({(1.0 / 6) * a + (1.0 / 6) * b + (2.0 / 3) * c, weight});
}

void append_quadrilateral(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, std::vector<PlanePoint>& points)
{
    const double g = 0.5 / std::sqrt(3.0);
    for (const double s : {0.5 - g, 0.5 + g}) {
        for (const double r : {0.5 - g, 0.5 + g}) {
            const Vec2 dr = (1 - s) * (b - a) + s * (c - d);
            const Vec2 ds = (1 - r) * (d - a) + r * (c - b);
            const Vec2 x = ((1 - r) * (1 - s)) * a + (r * (1 - s)) * b + (r * s) * c + ((1 - r) * s) * d;
            points.push_back({x, wedge(dr, ds) / 4});
        }
    }
}

}  // namespace

double signed_area(const Polygon& polygon)
{
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        sum += wedge(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    }
    return sum / 2;
}

Polygon clipped(const Polygon& polygon, const HalfPlane& half_plane)
{
    Polygon result;
    result.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& p = polygon[i];
        const Vec2& q = polygon[(i + 1) % polygon.size()];
        const double dp = dot(half_plane.normal, p) - half_plane.offset;
        const double dq = dot(half_plane.normal, q) - half_plane.offset;
        if (dp <= 0) {
            result.push_back(p);
        }
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
            result.push_back(p + (dp / (dp - dq)) * (q - p));
        }
    }
    if (result.size() < 3) {
        result.clear();
    }
    return result;
}

Polygon intersection(const Polygon& subject, const Polygon& window)
{
    Polygon result = subject;
    for (std::size_t i = 0; i < window.size() && !result.empty(); ++i) {
        const Vec2 edge = window[(i + 1) % window.size()] - window[i];
        const Vec2 outwards{edge[1], -edge[0]};
        result = clipped(result, {outwards, dot(outwards, window[i])});
    }
    return result;
}

void append_points(const Polygon& polygon, std::vector<PlanePoint>& points)
{
    std::size_t i = 1;
    for (; i + 2 < polygon.size(); i += 2) {
        append_quadrilateral(polygon[0], polygon[i], polygon[i + 1], polygon[i + 2], points);
    }
    if (i + 1 < polygon.size()) {
        append_triangle(polygon[0], polygon[i], polygon[i + 1], points);
    }
}

}  // namespace deadpoint::machine
