#include "deadpoint/study/surface_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace deadpoint::study {
namespace {

const Face& face_of(const Machine& machine, const SurfaceFace& entry) { return machine.faces[entry.face]; }

double area_of(const Machine& machine, const Face& face)
{
    const auto& x = machine.nodes;
    double area = 0.5 * norm(cross(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]]));
    if (face.node_count == 4)
        area += 0.5 * norm(cross(x[face.nodes[2]] - x[face.nodes[0]], x[face.nodes[3]] - x[face.nodes[0]]));
    return area;
}

bool on_symmetry_plane(const Machine& machine, std::uint32_t a, std::uint32_t b)
{
    constexpr double tolerance = 1e-9;
    return machine.half_model && std::abs(machine.nodes[a][0]) < tolerance && std::abs(machine.nodes[b][0]) < tolerance;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

double perimeter_of(const Machine& machine, const MeshSurface& surface)
{
    std::map<Edge, int> edges;
    for (const auto& entry : surface.faces) {
        const Face& face = face_of(machine, entry);
        for (std::size_t i = 0; i < face.node_count; ++i) {
            const auto a = face.nodes[i], b = face.nodes[(i + 1) % face.node_count];
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    }
    double perimeter = 0;
    for (const auto& [edge, count] : edges)
        if (count == 1 && !on_symmetry_plane(machine, edge.first, edge.second))
            perimeter += norm(machine.nodes[edge.second] - machine.nodes[edge.first]);
    return perimeter;
}

bool same_plane(const FaceGeometry& one, const FaceGeometry& other)
{
    const auto* a = std::get_if<PlaneGeometry>(&one);
    const auto* b = std::get_if<PlaneGeometry>(&other);
    return a && b && norm(a->normal - b->normal) < 1e-9 && std::abs(a->offset - b->offset) < 1e-9;
}

}  // namespace

std::optional<double> height_of(const Machine& machine, const MeshSurface& surface)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& entry : surface.faces) {
        const Face& face = face_of(machine, entry);
        if (face.part != face_of(machine, surface.faces.front()).part)
            return std::nullopt;
        for (std::size_t i = 0; i < face.node_count; ++i) {
            low = std::min(low, machine.nodes[face.nodes[i]][1]);
            high = std::max(high, machine.nodes[face.nodes[i]][1]);
        }
    }
    return high > low ? std::optional(high - low) : std::nullopt;
}

std::optional<double> cylinder_diameter(const Machine& machine, const MeshSurface& surface)
{
    std::optional<double> diameter;
    for (const auto& entry : surface.faces) {
        const auto* cylinder = std::get_if<CylinderGeometry>(&machine.geometries[face_of(machine, entry).geometry]);
        if (!cylinder || (diameter && std::abs(2 * cylinder->radius - *diameter) > 1e-9))
            return std::nullopt;
        diameter = 2 * cylinder->radius;
    }
    return diameter;
}

std::optional<double> area_over_perimeter(const Machine& machine, const MeshSurface& surface)
{
    if (surface.faces.empty())
        return std::nullopt;
    const auto& first = machine.geometries[face_of(machine, surface.faces.front()).geometry];
    double area = 0;
    for (const auto& entry : surface.faces) {
        if (!same_plane(first, machine.geometries[face_of(machine, entry).geometry]))
            return std::nullopt;
        area += area_of(machine, face_of(machine, entry));
    }
    return area / perimeter_of(machine, surface);
}

PlaneMoments plane_moments(const Machine& machine, const MeshSurface& surface)
{
    PlaneMoments sum;
    double total = 0;
    for (const auto& entry : surface.faces) {
        const Face& face = face_of(machine, entry);
        Vec3 centre{};
        for (std::size_t i = 0; i < face.node_count; ++i)
            centre = centre + (1.0 / face.node_count) * machine.nodes[face.nodes[i]];
        const double area = entry.fraction * area_of(machine, face);
        const Vec2 place{centre[0], centre[1]};
        sum.mean = sum.mean + area * place;
        sum.mean_square += area * dot(place, place);
        total += area;
    }
    if (total > 0)
        sum = {(1 / total) * sum.mean, sum.mean_square / total};
    return sum;
}

}  // namespace deadpoint::study
