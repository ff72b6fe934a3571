#include "deadpoint/machine/parts/arrangement.hpp"

#include "deadpoint/machine/geometry/shapes.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/layers.hpp"

#include <algorithm>
#include <cmath>
#include <gmsh.h>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace deadpoint::machine {

namespace {

namespace occ = gmsh::model::occ;
using Tags = gmsh::vectorpair;
using Groups = std::map<std::vector<char>, Tags>;

int add_polygon(const std::vector<Vec2>& points)
{
    std::vector<int> corners;
    for (const Vec2& p : points) {
        corners.push_back(occ::addPoint(to_gmsh(p[0]), to_gmsh(p[1]), 0));
    }
    std::vector<int> lines;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        lines.push_back(occ::addLine(corners[i], corners[(i + 1) % corners.size()]));
    }
    return occ::addPlaneSurface({occ::addCurveLoop(lines)});
}

int add_disk(const Vec2& centre, double radius)
{
    return occ::addDisk(to_gmsh(centre[0]), to_gmsh(centre[1]), 0, to_gmsh(radius), to_gmsh(radius));
}

/// Every outline once, as a face, in an order that does not depend on the order of the shapes.
Tags draw_outlines(const LayeredPart& part)
{
    std::vector<Circle> circles;
    std::vector<std::vector<Vec2>> polygons;
    const auto circle = [&](const Circle& c) {
        const auto same = [&](const Circle& d) { return d.centre == c.centre && d.radius == c.radius; };
        if (c.radius > 0 && std::none_of(circles.begin(), circles.end(), same)) {
            circles.push_back(c);
        }
    };
    const auto polygon = [&](const std::vector<Vec2>& points) {
        const std::vector<Vec2> ring = in_standard_order(points);
        if (std::find(polygons.begin(), polygons.end(), ring) == polygons.end()) {
            polygons.push_back(ring);
        }
    };
    double reach = 1;
    for (const Prism& prism : part.prisms) {
        if (prism.section.circle) {
            circle(*prism.section.circle);
            circle({prism.section.circle->centre, prism.section.bore_radius});
            reach = std::max(reach, norm(prism.section.circle->centre) + prism.section.circle->radius + 1);
        } else {
            polygon(prism.section.points);
            for (const auto& hole : prism.section.holes) {
                polygon(hole);
            }
            for (const Vec2& point : prism.section.points) {
                reach = std::max(reach, norm(point) + 1);
            }
        }
    }
    if (part.half_plane) {
        polygon({{-reach, -reach}, {0, -reach}, {0, reach}, {-reach, reach}});
    }
    std::sort(circles.begin(), circles.end(), [](const Circle& a, const Circle& b) {
        return std::tie(a.centre, a.radius) < std::tie(b.centre, b.radius);
    });
    std::sort(polygons.begin(), polygons.end());
    Tags faces;
    for (const Circle& c : circles) {
        faces.emplace_back(2, add_disk(c.centre, c.radius));
    }
    for (const auto& points : polygons) {
        faces.emplace_back(2, add_polygon(points));
    }
    return faces;
}

Tags fragmented(const Tags& faces)
{
    if (faces.size() < 2) {
        return faces;
    }
    Tags pieces;
    std::vector<Tags> map;
    occ::fragment({faces.front()}, Tags(faces.begin() + 1, faces.end()), pieces, map);
    std::erase_if(pieces, [](const auto& piece) { return piece.first != 2; });
    return pieces;
}

/// The boundary of a face as unordered segments, dense enough to tell inside from outside.
struct Boundary {
    std::vector<std::array<Vec2, 2>> segments;
    std::vector<std::vector<Vec2>> curves;
};

Boundary boundary_of(int face)
{
    Boundary boundary;
    for (const int curve : boundary_curves(face)) {
        boundary.curves.push_back(sampled(curve, 128));
        const auto& points = boundary.curves.back();
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            boundary.segments.push_back({points[i], points[i + 1]});
        }
    }
    return boundary;
}

/// Distance to the boundary, positive inside.
double inner_distance(const Boundary& boundary, const Vec2& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    bool in = false;
    for (const auto& [a, b] : boundary.segments) {
        const Vec2 edge = b - a;
        const double length = dot(edge, edge);
        const double s = length > 0 ? std::clamp(dot(point - a, edge) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, norm(point - a - s * edge));
        if ((a[1] > point[1]) != (b[1] > point[1]) && point[0] < a[0] + (point[1] - a[1]) / edge[1] * edge[0]) {
            in = !in;
        }
    }
    return in ? nearest : -nearest;
}

/// A point well inside a face: the best of points beside the middles of its boundary curves.
Vec2 interior_point(int face)
{
    const Boundary boundary = boundary_of(face);
    Vec2 best{};
    double best_distance = 0;
    for (const auto& curve : boundary.curves) {
        double length = 0;
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            length += norm(curve[i + 1] - curve[i]);
        }
        const std::size_t middle = curve.size() / 2;
        const Vec2 tangent = curve[middle + 1] - curve[middle - 1];
        const Vec2 normal = (1 / norm(tangent)) * Vec2{-tangent[1], tangent[0]};
        double offset = 0.3 * length;
        while (offset > 1e-7) {
            for (const double sign : {1.0, -1.0}) {
                const Vec2 point = curve[middle] + (sign * offset) * normal;
                const double distance = inner_distance(boundary, point);
                if (distance > best_distance) {
                    best_distance = distance;
                    best = point;
                }
            }
            offset *= 0.4;
        }
    }
    return best;
}

/// Faces by what they belong to; faces that belong to nothing are removed.
Groups grouped(const LayeredPart& part, const Tags& faces)
{
    occ::synchronize();
    Groups groups;
    Tags useless;
    for (const auto& face : faces) {
        const std::vector<char> own = signature(part, interior_point(face.second));
        if (own.empty()) {
            useless.push_back(face);
        } else {
            groups[own].push_back(face);
        }
    }
    if (!useless.empty()) {
        occ::remove(useless, true);
    }
    return groups;
}

/// A closed chain of curves, with its sampled polygon.
struct Loop {
    std::vector<int> curves;
    std::vector<Vec2> polygon;
    double area = 0;
};

/// Follows curves from `start` until a vertex comes back; takes the curves of the closed part out of `open`.
Loop next_loop(std::map<int, std::array<int, 2>>& open)
{
    const auto [first, ends] = *open.begin();
    std::vector<int> curves{first};
    std::vector<int> vertices{ends[0], ends[1]};
    std::map<int, std::array<int, 2>> rest = open;
    rest.erase(first);
    for (;;) {
        const auto seen = std::find(vertices.begin(), vertices.end() - 1, vertices.back());
        if (seen != vertices.end() - 1) {
            curves.erase(curves.begin(), curves.begin() + (seen - vertices.begin()));
            break;
        }
        const auto follows = [&](const auto& entry) {
            return entry.second[0] == vertices.back() || entry.second[1] == vertices.back();
        };
        const auto next = std::find_if(rest.begin(), rest.end(), follows);
        if (next == rest.end()) {
            throw std::runtime_error("an outline does not close");
        }
        curves.push_back(next->first);
        vertices.push_back(next->second[0] == vertices.back() ? next->second[1] : next->second[0]);
        rest.erase(next);
    }
    Loop loop;
    loop.curves = curves;
    for (const int curve : curves) {
        open.erase(curve);
    }
    return loop;
}

void sample(Loop& loop)
{
    for (std::size_t i = 0; i < loop.curves.size(); ++i) {
        std::vector<Vec2> points = sampled(loop.curves[i], 64);
        if (i > 0 && norm(points.back() - loop.polygon.back()) < norm(points.front() - loop.polygon.back())) {
            std::reverse(points.begin(), points.end());
        } else if (i == 0 && loop.curves.size() > 1) {  // run towards the second curve
            const std::vector<Vec2> next = sampled(loop.curves[1], 1);
            const auto reach = [&](const Vec2& p) { return std::min(norm(p - next.front()), norm(p - next.back())); };
            if (reach(points.front()) < reach(points.back())) {
                std::reverse(points.begin(), points.end());
            }
        }
        loop.polygon.insert(loop.polygon.end(), points.begin(), points.end());
    }
    for (std::size_t i = 0; i < loop.polygon.size(); ++i) {
        const Vec2& p = loop.polygon[i];
        const Vec2& q = loop.polygon[(i + 1) % loop.polygon.size()];
        loop.area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    loop.area = std::abs(loop.area);
}

bool contains(const Loop& outer, const Loop& inner)
{
    if (outer.area <= inner.area) {
        return false;
    }
    const Vec2& point = inner.polygon[32];  // the middle of its first curve
    bool in = false;
    for (std::size_t i = 0; i < outer.polygon.size(); ++i) {
        const Vec2& a = outer.polygon[i];
        const Vec2& b = outer.polygon[(i + 1) % outer.polygon.size()];
        if ((a[1] > point[1]) != (b[1] > point[1]) &&
            point[0] < a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
            in = !in;
        }
    }
    return in;
}

/// New faces over the outer boundary of neighbouring faces; the curves between the faces are left out.
Tags merged(const Tags& faces)
{
    std::map<int, int> uses;
    for (const auto& face : faces) {
        Tags boundary;
        gmsh::model::getBoundary({face}, boundary, false, false, false);
        for (const auto& [dimension, curve] : boundary) {
            ++uses[std::abs(curve)];
        }
    }
    std::map<int, std::array<int, 2>> open;
    for (const auto& [curve, count] : uses) {
        if (count == 1) {
            open[curve] = ends_of(curve);
        }
    }
    std::vector<Loop> loops;
    while (!open.empty()) {
        loops.push_back(next_loop(open));
        sample(loops.back());
    }
    std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) { return a.area > b.area; });
    std::vector<std::vector<int>> wires;  // of each face: its outline, then its holes
    std::vector<std::size_t> face_of_loop(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const int wire = occ::addCurveLoop(loops[i].curves);
        std::size_t parent = i;
        int around = 0;
        for (std::size_t k = 0; k < i; ++k) {
            if (!contains(loops[k], loops[i])) {
                continue;
            }
            ++around;
            parent = k;  // the smallest so far
        }
        if (around % 2 == 0) {
            face_of_loop[i] = wires.size();
            wires.push_back({wire});
        } else {
            wires[face_of_loop[parent]].push_back(wire);
        }
    }
    Tags result;
    for (const auto& face : wires) {
        result.emplace_back(2, occ::addPlaneSurface(face));
    }
    return result;
}

/// Joins neighbouring faces with the same owners, so that only relevant outlines remain.
Groups simplified(const Groups& groups)
{
    Groups result;
    Tags old;
    for (const auto& [own, members] : groups) {
        if (members.size() < 2) {
            result[own] = members;
            continue;
        }
        result[own] = merged(members);
        old.insert(old.end(), members.begin(), members.end());
    }
    if (!old.empty()) {
        occ::remove(old, true);
    }
    occ::synchronize();
    return result;
}
}  // namespace

std::vector<Vec2> sampled(int curve, int count)
{
    std::vector<double> low;
    std::vector<double> high;
    gmsh::model::getParametrizationBounds(1, curve, low, high);
    std::vector<double> parameters;
    for (int i = 0; i <= count; ++i) {
        parameters.push_back(low[0] + (high[0] - low[0]) * i / count);
    }
    std::vector<double> coordinates;
    gmsh::model::getValue(1, curve, parameters, coordinates);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
        points.push_back({coordinates[i] * gmsh_unit, coordinates[i + 1] * gmsh_unit});
    }
    return points;
}

std::array<int, 2> ends_of(int curve)
{
    Tags points;
    gmsh::model::getBoundary({{1, curve}}, points, false, false, false);
    if (points.empty()) {
        return {-curve, -curve};
    }  // closed, without a vertex
    return {points.front().second, points.back().second};
}

std::vector<int> boundary_curves(int face)
{
    Tags boundary;
    gmsh::model::getBoundary({{2, face}}, boundary, false, false, false);
    std::vector<int> curves;
    for (const auto& [dimension, curve] : boundary) {
        curves.push_back(std::abs(curve));
    }
    return curves;
}

SurfaceGroups build_arrangement(const LayeredPart& part)
{
    SurfaceGroups result;
    for (const auto& [own, faces] : simplified(grouped(part, fragmented(draw_outlines(part))))) {
        for (const auto& face : faces) {
            result[own].push_back(face.second);
        }
    }
    return result;
}

}  // namespace deadpoint::machine
