#pragma once

#include "deadpoint/core/vec.hpp"

#include <functional>
#include <vector>

/// Convex polygons in a plane, counter-clockwise.
namespace deadpoint::machine {

using Polygon = std::vector<Vec2>;

/// Positive for counter-clockwise polygons.
double signed_area(const Polygon& polygon);

/// The half plane of all points p with dot(normal, p) <= offset.
struct HalfPlane {
    Vec2 normal{};
    double offset = 0;
};

/// One step of Sutherland-Hodgman: the part of a convex polygon in the half plane; empty if less
/// than a triangle.
Polygon clipped(const Polygon& polygon, const HalfPlane& half_plane);
/// The same where `excess` is at most 0, which is taken as linear along each edge.
Polygon clipped_where(const Polygon& polygon, const std::function<double(const Vec2&)>& excess);
/// The intersection of two convex polygons.
Polygon intersection(const Polygon& subject, const Polygon& window);

struct PlanePoint {
    Vec2 position{};
    double weight = 0;
};
/// Appends integration points of a convex polygon: it is split into quadrilaterals and at most one triangle. Weights
/// sum to the area.
/// @param fine  3 x 3 Gauss points and 6 points of degree 4, for products of quadratic functions; else 2 x 2 and 3 of
///              degree 2
void append_points(const Polygon& polygon, bool fine, std::vector<PlanePoint>& points);

}  // namespace deadpoint::machine
