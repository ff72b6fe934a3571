#include "deadpoint/press/run/field_place.hpp"

#include "deadpoint/io/vtu.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace deadpoint::press {
namespace {

constexpr double local_tolerance = 1e-9;
constexpr int most_iterations = 30;

/// Corners of the faces of cells; a triangle repeats its last corner.
constexpr std::array<std::array<int, 4>, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<std::array<int, 4>, 4> tetrahedron_faces{{{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}}};
/// Which local coordinates are 1 at a corner.
constexpr std::array<std::array<int, 3>, 8> far_corner{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

using Weights = std::array<double, 8>;

/// One cell with the places of its corners.
struct CellHere {
    int corners = 8;
    std::array<std::uint32_t, 8> nodes{};
    std::array<Vec3, 8> places{};
};

CellHere cell_of(const VtuGrid& grid, std::size_t cell)
{
    const std::size_t first = cell == 0 ? 0 : grid.offsets[cell - 1];
    CellHere here;
    here.corners = static_cast<int>(std::min<std::size_t>(8, grid.offsets[cell] - first));
    for (int k = 0; k < here.corners; ++k) {
        here.nodes[k] = grid.connectivity[first + static_cast<std::size_t>(k)];
        here.places[k] = grid.points[here.nodes[k]];
    }
    return here;
}

/// Distance of a place from the box around a cell, and that box's largest extent.
std::array<double, 2> box_distance(const CellHere& cell, const Vec3& place)
{
    double squared = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double low = cell.places[0][i], high = low;
        for (int k = 1; k < cell.corners; ++k) {
            low = std::min(low, cell.places[k][i]);
            high = std::max(high, cell.places[k][i]);
        }
        const double off = std::max({low - place[i], place[i] - high, 0.0});
        squared += off * off;
        size = std::max(size, high - low);
    }
    return {std::sqrt(squared), size};
}

Weights weights_at(int corners, const Vec3& local)
{
    Weights weights{};
    if (corners == 4) {
        return {1 - local[0] - local[1] - local[2], local[0], local[1], local[2]};
    }
    for (std::size_t k = 0; k < 8; ++k) {
        weights[k] = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            weights[k] *= far_corner[k][i] == 1 ? local[i] : 1 - local[i];
        }
    }
    return weights;
}

Vec3 place_at(const CellHere& cell, const Weights& weights)
{
    Vec3 place{};
    for (int k = 0; k < cell.corners; ++k) {
        place = place + weights[k] * cell.places[k];
    }
    return place;
}

/// Derivative of the place by one local coordinate: the map is linear in each of them.
Vec3 slope(const CellHere& cell, Vec3 local, std::size_t axis)
{
    local[axis] = 1;
    const Vec3 high = place_at(cell, weights_at(cell.corners, local));
    local[axis] = 0;
    return high - place_at(cell, weights_at(cell.corners, local));
}

/// The local coordinates of a place by Newton's method; none if it does not converge.
std::optional<Vec3> local_of(const CellHere& cell, const Vec3& place)
{
    Vec3 local{0.25, 0.25, 0.25};
    for (int k = 0; k < most_iterations; ++k) {
        const Vec3 off = place - place_at(cell, weights_at(cell.corners, local));
        const Vec3 a = slope(cell, local, 0), b = slope(cell, local, 1), c = slope(cell, local, 2);
        const double volume = dot(a, cross(b, c));
        const Vec3 step{dot(off, cross(b, c)) / volume, dot(a, cross(off, c)) / volume, dot(a, cross(b, off)) / volume};
        local = local + step;
        if (!std::isfinite(norm(local))) {
            return std::nullopt;
        }
        if (norm(step) < 1e-12) {
            return local;
        }
    }
    return std::nullopt;
}

bool is_inside(int corners, const Vec3& local)
{
    const bool above = std::ranges::all_of(local, [](double value) { return value >= -local_tolerance; });
    if (corners == 4) {
        return above && local[0] + local[1] + local[2] <= 1 + local_tolerance;
    }
    return above && std::ranges::all_of(local, [](double value) { return value <= 1 + local_tolerance; });
}

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& place)
{
    const Vec3 along = b - a;
    const double length = dot(along, along);
    return a + (length > 0 ? std::clamp(dot(place - a, along) / length, 0.0, 1.0) : 0.0) * along;
}

Vec3 nearer(const Vec3& a, const Vec3& b, const Vec3& place) { return norm(b - place) < norm(a - place) ? b : a; }

/// The foot of the perpendicular if it is in the triangle, else the nearest place on an edge.
Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& place)
{
    Vec3 best = nearer(nearest_on_segment(a, b, place), nearest_on_segment(b, c, place), place);
    best = nearer(best, nearest_on_segment(c, a, place), place);
    const Vec3 normal = cross(b - a, c - a);
    const double squared = dot(normal, normal);
    if (squared <= 0) {
        return best;
    }
    const Vec3 foot = place - (dot(place - a, normal) / squared) * normal;
    const bool within = dot(cross(b - a, foot - a), normal) >= 0 && dot(cross(c - b, foot - b), normal) >= 0 &&
                        dot(cross(a - c, foot - c), normal) >= 0;
    return within ? foot : best;
}

template <class Faces>
Vec3 nearest_on(const Faces& faces, const CellHere& cell, const Vec3& place)
{
    Vec3 best = cell.places[0];
    for (const auto& face : faces) {
        const auto& p = cell.places;
        best = nearer(best, nearest_on_triangle(p[face[0]], p[face[1]], p[face[2]], place), place);
        if (face[3] != face[2]) {
            best = nearer(best, nearest_on_triangle(p[face[0]], p[face[2]], p[face[3]], place), place);
        }
    }
    return best;
}

Vec3 nearest_in(const CellHere& cell, const Vec3& place)
{
    return cell.corners == 4 ? nearest_on(tetrahedron_faces, cell, place) : nearest_on(hexahedron_faces, cell, place);
}

}  // namespace

FieldPlace find_place(const VtuGrid& grid, std::span<const std::int32_t> parts, std::int32_t part, const Vec3& position)
{
    FieldPlace best;
    best.outside = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < grid.offsets.size(); ++c) {
        if (parts[c] != part) {
            continue;
        }
        const auto cell = cell_of(grid, c);
        const auto [distance, size] = box_distance(cell, position);
        if (distance >= best.outside) {
            continue;
        }
        if (distance <= local_tolerance * size) {
            const auto local = local_of(cell, position);
            if (local && is_inside(cell.corners, *local)) {
                return {0, size, position, cell.nodes, weights_at(cell.corners, *local)};
            }
        }
        const Vec3 nearest = nearest_in(cell, position);
        if (const double outside = norm(nearest - position); outside < best.outside) {
            best = {outside, size, nearest, cell.nodes, {}};
            Vec3 local = local_of(cell, nearest).value_or(Vec3{0.25, 0.25, 0.25});
            std::ranges::transform(local, local.begin(), [](double value) { return std::clamp(value, 0.0, 1.0); });
            best.weights = weights_at(cell.corners, local);
        }
    }
    return best;
}

}  // namespace deadpoint::press
