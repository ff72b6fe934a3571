#include "deadpoint/study/laws/surface_geometry.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace deadpoint::study {
namespace {

const Face& face_of(const Machine& machine, const SurfaceFace& entry) { return machine.faces[entry.face]; }

// Lengths along edges of the mesh use whole faces.
std::vector<SurfaceFace> whole_faces(const MeshSurface& surface)
{
    std::vector<SurfaceFace> result;
    std::ranges::copy_if(surface.faces, std::back_inserter(result), &SurfaceFace::central);
    return result;
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
    for (const auto& entry : whole_faces(surface)) {
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

constexpr double same_direction = 1e-6;

// Whether a direction is the normal of one of a surface's planes.
bool is_normal(const Machine& machine, const MeshSurface& surface, const Vec3& direction)
{
    return std::ranges::any_of(surface.faces, [&](const SurfaceFace& entry) {
        const auto* plane = std::get_if<PlaneGeometry>(&machine.geometries[face_of(machine, entry).geometry]);
        return plane && norm(cross(plane->normal, direction)) < same_direction;
    });
}

bool on_one_part(const Machine& machine, const MeshSurface& surface)
{
    return std::ranges::all_of(surface.faces, [&](const SurfaceFace& entry) {
        return face_of(machine, entry).part == face_of(machine, surface.faces.front()).part;
    });
}

std::set<std::uint32_t> nodes_of(const Machine& machine, const MeshSurface& surface)
{
    std::set<std::uint32_t> nodes;
    for (const auto& entry : whole_faces(surface)) {
        const Face& face = face_of(machine, entry);
        nodes.insert(face.nodes.begin(), face.nodes.begin() + face.node_count);
    }
    return nodes;
}

// Whether a face shares an edge with faces of these nodes.
bool touches(const Face& face, const std::set<std::uint32_t>& nodes)
{
    return std::count_if(face.nodes.begin(), face.nodes.begin() + face.node_count,
                         [&](std::uint32_t node) { return nodes.contains(node); }) >= 2;
}

}  // namespace

std::optional<double> height_of(const Machine& machine, const MeshSurface& surface)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& entry : whole_faces(surface)) {
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

std::optional<double> disk_diameter(const Machine& machine, const MeshSurface& surface)
{
    if (!on_one_part(machine, surface))
        return std::nullopt;
    const auto nodes = nodes_of(machine, surface);
    const CylinderGeometry* widest = nullptr;
    for (const auto& face : machine.faces) {
        const auto* cylinder = std::get_if<CylinderGeometry>(&machine.geometries[face.geometry]);
        if (cylinder && !cylinder->bore && (!widest || cylinder->radius > widest->radius) && touches(face, nodes) &&
            is_normal(machine, surface, cylinder->axis))
            widest = cylinder;
    }
    const auto inside = [&](std::uint32_t node) {
        constexpr double rounding = 1e-6;
        const Vec3 arm = machine.nodes[node] - widest->point;
        return norm(arm - dot(arm, widest->axis) * widest->axis) < widest->radius + rounding;
    };
    return widest && std::ranges::all_of(nodes, inside) ? std::optional(2 * widest->radius) : std::nullopt;
}

std::optional<double> area_over_perimeter(const Machine& machine, const MeshSurface& surface)
{
    if (surface.faces.empty())
        return std::nullopt;
    const auto& first = machine.geometries[face_of(machine, surface.faces.front()).geometry];
    double area = 0;
    for (const auto& entry : whole_faces(surface)) {
        if (!same_plane(first, machine.geometries[face_of(machine, entry).geometry]))
            return std::nullopt;
        area += face_area(machine, face_of(machine, entry));
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
        const double area = entry.fraction * face_area(machine, face);
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
