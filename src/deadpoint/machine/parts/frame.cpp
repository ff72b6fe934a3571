#include "deadpoint/machine/parts/frame.hpp"

#include "deadpoint/machine/geometry/polygon.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace deadpoint::machine {

namespace {

/// Numbers in a frame are multiples of this [m]: far above rounding, far below what anyone states.
constexpr double grain = 1e-12;
/// Directions that decide are multiples of this [m].
constexpr double coarse = 1e-9;

double rounded(double value, double step) { return std::round(value / step) * step + 0.0; }  // no -0

Vec3 turned(const Frame& frame, const Vec3& v)
{
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = frame.sign[i] * v[frame.axis[i]] + 0.0;
    }
    return result;
}

Vec3 turned_back(const Frame& frame, const Vec3& v)
{
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[frame.axis[i]] = frame.sign[i] * v[i] + 0.0;
    }
    return result;
}

/// The 24 rotations by right angles; of a half model the four that keep x.
std::vector<Frame> rotations(bool half)
{
    std::vector<Frame> result;
    std::array<std::size_t, 3> axis{0, 1, 2};
    do {
        const bool even = (axis[0] + 1) % 3 == axis[1];
        for (int signs = 0; signs < 8; ++signs) {
            const auto sign = [signs](int i) { return (signs >> i) % 2 == 0 ? 1.0 : -1.0; };
            const Frame frame{axis, {sign(0), sign(1), sign(2)}, {}};
            const bool keeps_x = axis[0] == 0 && sign(0) > 0;
            if (sign(0) * sign(1) * sign(2) == (even ? 1 : -1) && (keeps_x || !half)) {
                result.push_back(frame);
            }
        }
    } while (std::next_permutation(axis.begin(), axis.end()));
    return result;
}

void append(std::vector<double>& numbers, const std::vector<Vec2>& ring)
{
    numbers.push_back(static_cast<double>(ring.size()));
    for (const Vec2& point : in_standard_order(ring)) {
        numbers.insert(numbers.end(), point.begin(), point.end());
    }
}

std::vector<double> numbers_of(const Prism& prism)
{
    std::vector<double> numbers{static_cast<double>(prism.operation)};
    if (prism.box) {
        numbers.insert(numbers.end(), prism.min.begin(), prism.min.end());
        numbers.insert(numbers.end(), prism.max.begin(), prism.max.end());
        return numbers;
    }
    numbers.insert(numbers.end(), {static_cast<double>(index_of(prism.axis)), prism.from, prism.to});
    if (const auto& circle = prism.section.circle) {
        numbers.insert(numbers.end(),
                       {circle->centre[0], circle->centre[1], circle->radius, prism.section.bore_radius});
    }
    append(numbers, prism.section.points);
    for (const auto& hole : prism.section.holes) {
        append(numbers, hole);
    }
    return numbers;
}

/// Data that distinguish views of a part: its shapes in any order, then the direction to the machine's centre.
std::vector<std::vector<double>> view(const Frame& frame, const std::vector<Prism>& prisms, const Vec3& towards)
{
    std::vector<std::vector<double>> numbers;
    for (const Prism& prism : prisms) {
        numbers.push_back(numbers_of(to_local(frame, prism)));
    }
    std::sort(numbers.begin(), numbers.end());
    const Vec3 way = turned(frame, towards);
    numbers.push_back({rounded(way[0], coarse), rounded(way[1], coarse), rounded(way[2], coarse)});
    return numbers;
}

FaceGeometry to_machine(const Frame& frame, const FaceGeometry& geometry)
{
    if (const auto* plane = std::get_if<PlaneGeometry>(&geometry)) {
        return PlaneGeometry{turned_back(frame, plane->normal), plane->offset + dot(plane->normal, frame.origin)};
    }
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        CylinderGeometry result = *cylinder;
        result.point = to_machine(frame, cylinder->point);
        result.axis = turned_back(frame, cylinder->axis);
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(result.axis[i]) == 1) {
                result.axis[i] = 1;
                result.point[i] = 0;
            }
        }
        return result;
    }
    return geometry;
}

}  // namespace

double in_frame(double length) { return rounded(length, grain); }

Vec3 to_local(const Frame& frame, const Vec3& point) { return turned(frame, point) - frame.origin; }

Vec3 to_machine(const Frame& frame, const Vec3& local) { return turned_back(frame, local + frame.origin); }

Prism to_local(const Frame& frame, const Prism& prism)
{
    const auto seen = [&](const Vec3& point) {
        const Vec3 p = to_local(frame, point);
        return Vec3{in_frame(p[0]), in_frame(p[1]), in_frame(p[2])};
    };
    Prism result = prism;
    if (prism.box) {
        BoxShape box = empty_box();
        include(box, seen(prism.min));
        include(box, seen(prism.max));
        result.min = box.min;
        result.max = box.max;
        return along(result, prism.axis);
    }
    const auto along_axis = std::find(frame.axis.begin(), frame.axis.end(), index_of(prism.axis)) - frame.axis.begin();
    result.axis = static_cast<Axis>(along_axis);
    const auto seen_across = [&](const Vec2& point) {
        return project(result.axis, seen(point_at(prism.axis, point, prism.from)));
    };
    const auto seen_along = [&](double position) { return seen(point_at(prism.axis, {}, position))[along_axis]; };
    std::tie(result.from, result.to) = std::minmax({seen_along(prism.from), seen_along(prism.to)});
    if (prism.section.circle) {
        result.section.circle =
            Circle{seen_across(prism.section.circle->centre), in_frame(prism.section.circle->radius)};
        result.section.bore_radius = in_frame(prism.section.bore_radius);
    }
    std::transform(prism.section.points.begin(), prism.section.points.end(), result.section.points.begin(),
                   seen_across);
    for (auto& hole : result.section.holes) {
        std::transform(hole.begin(), hole.end(), hole.begin(), seen_across);
    }
    return result;
}

PartMesh to_machine(const Frame& frame, PartMesh mesh)
{
    for (Vec3& node : mesh.nodes) {
        node = to_machine(frame, node);
    }
    for (FaceGeometry& geometry : mesh.geometries) {
        geometry = to_machine(frame, geometry);
    }
    return mesh;
}

Frame frame_of(const std::vector<Prism>& prisms, const Vec3& towards, bool half)
{
    const BoxShape box = bounds_of(prisms);
    std::vector<Frame> frames = rotations(half);
    std::vector<std::vector<std::vector<double>>> views;
    for (Frame& frame : frames) {
        const Vec3 first = turned(frame, box.min);
        const Vec3 last = turned(frame, box.max);
        for (std::size_t i = half ? 1 : 0; i < 3; ++i) {
            frame.origin[i] = std::min(first[i], last[i]);
        }
        views.push_back(view(frame, prisms, towards));
    }
    return frames[static_cast<std::size_t>(std::min_element(views.begin(), views.end()) - views.begin())];
}

BoxShape bounds_of(const std::vector<Prism>& prisms)
{
    BoxShape box = empty_box();
    for (const Prism& prism : prisms) {
        if (prism.box) {
            include(box, prism.min);
            include(box, prism.max);
            continue;
        }
        const auto add = [&](const Vec2& point) {
            include(box, point_at(prism.axis, point, prism.from));
            include(box, point_at(prism.axis, point, prism.to));
        };
        std::for_each(prism.section.points.begin(), prism.section.points.end(), add);
        if (const auto& circle = prism.section.circle) {
            add(circle->centre - Vec2{circle->radius, circle->radius});
            add(circle->centre + Vec2{circle->radius, circle->radius});
        }
    }
    return box;
}

Vec3 middle(const BoxShape& box) { return 0.5 * (box.min + box.max); }

std::vector<Vec2> in_standard_order(std::vector<Vec2> ring)
{
    if (signed_area(ring) < 0) {
        std::reverse(ring.begin(), ring.end());
    }
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return ring;
}

}  // namespace deadpoint::machine
