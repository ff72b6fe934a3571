#include "deadpoint/machine/geometry/polygon.hpp"

#include <cmath>

namespace deadpoint::machine {

namespace {

double wedge(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

struct LinePoint {
    double place;  ///< 0..1
    double weight;
};

std::vector<LinePoint> gauss_points(bool fine)
{
    if (fine) {
        const double g = std::sqrt(0.15);
        return {{0.5 - g, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + g, 5.0 / 18}};
    }
    const double g = 0.5 / std::sqrt(3.0);
    return {{0.5 - g, 0.5}, {0.5 + g, 0.5}};
}

struct Orbit {
    double corner;
    double other;
    double weight;
};

// Dunavant (1985)
std::vector<Orbit> triangle_orbits(bool fine)
{
    if (fine) {
        return {{0.108103018168070, 0.445948490915965, 0.223381589678011},
                {0.816847572980459, 0.091576213509771, 0.109951743655322}};
    }
    return {{2.0 / 3, 1.0 / 6, 1.0 / 3}};
}

void append_triangle(const Vec2& a, const Vec2& b, const Vec2& c, bool fine, std::vector<PlanePoint>& points)
{
    const double area = wedge(b - a, c - a) / 2;
    for (const Orbit& o : triangle_orbits(fine)) {
        points.push_back({o.corner * a + o.other * b + o.other * c, o.weight * area});
        points.push_back({o.other * a + o.corner * b + o.other * c, o.weight * area});
        points.push_back({o.other * a + o.other * b + o.corner * c, o.weight * area});
    }
}

void append_quadrilateral(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, bool fine,
                          std::vector<PlanePoint>& points)
{
    const auto line = gauss_points(fine);
    for (const auto& [s, weight_s] : line) {
        for (const auto& [r, weight_r] : line) {
            const Vec2 dr = (1 - s) * (b - a) + s * (c - d);
            const Vec2 ds = (1 - r) * (d - a) + r * (c - b);
            const Vec2 x = ((1 - r) * (1 - s)) * a + (r * (1 - s)) * b + (r * s) * c + ((1 - r) * s) * d;
            points.push_back({x, weight_s * weight_r * wedge(dr, ds)});
        }
    }
}

template <typename Excess>
Polygon kept(const Polygon& polygon, const Excess& excess)
{
    Polygon result;
    result.reserve(polygon.size() + 1);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& p = polygon[i];
        const Vec2& q = polygon[(i + 1) % polygon.size()];
        const double dp = excess(p);
        const double dq = excess(q);
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
    return kept(polygon, [&](const Vec2& p) { return dot(half_plane.normal, p) - half_plane.offset; });
}

Polygon clipped_where(const Polygon& polygon, const std::function<double(const Vec2&)>& excess)
{
    return kept(polygon, excess);
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

void append_points(const Polygon& polygon, bool fine, std::vector<PlanePoint>& points)
{
    std::size_t i = 1;
    for (; i + 2 < polygon.size(); i += 2) {
        append_quadrilateral(polygon[0], polygon[i], polygon[i + 1], polygon[i + 2], fine, points);
    }
    if (i + 1 < polygon.size()) {
        append_triangle(polygon[0], polygon[i], polygon[i + 1], fine, points);
    }
}

}  // namespace deadpoint::machine
