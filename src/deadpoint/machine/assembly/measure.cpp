#include "deadpoint/machine/assembly/measure.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace deadpoint::machine {
namespace {

constexpr double same_direction = 1e-6;

const Face& face_of(const Machine& machine, const SurfaceFace& entry) { return machine.faces[entry.face]; }

const FaceGeometry& geometry_of(const Machine& machine, const SurfaceFace& entry)
{
    return machine.geometries[face_of(machine, entry).geometry];
}

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

using SurfaceEdge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<SurfaceEdge> edges_of(const Machine& machine, const std::vector<SurfaceFace>& faces)
{
    std::vector<SurfaceEdge> edges;
    for (const auto& entry : faces) {
        const Face& face = face_of(machine, entry);
        for (std::size_t i = 0; i < face.node_count; ++i)
            edges.emplace_back(std::minmax(face.nodes[i], face.nodes[(i + 1) % face.node_count]));
    }
    std::ranges::sort(edges);
    return edges;
}

double perimeter_of(const Machine& machine, const std::vector<SurfaceFace>& faces)
{
    const auto edges = edges_of(machine, faces);
    double perimeter = 0;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto next = std::find_if(first, edges.end(), [&](const SurfaceEdge& edge) { return edge != *first; });
        if (next - first == 1 && !on_symmetry_plane(machine, first->first, first->second))
            perimeter += norm(machine.nodes[first->second] - machine.nodes[first->first]);
        first = next;
    }
    return perimeter;
}

bool same_plane(const FaceGeometry& one, const FaceGeometry& other)
{
    const auto* a = std::get_if<PlaneGeometry>(&one);
    const auto* b = std::get_if<PlaneGeometry>(&other);
    return a && b && norm(a->normal - b->normal) < 1e-9 && std::abs(a->offset - b->offset) < 1e-9;
}

bool on_one_part(const Machine& machine, const MeshSurface& surface)
{
    return std::ranges::all_of(surface.faces, [&](const SurfaceFace& entry) {
        return face_of(machine, entry).part == face_of(machine, surface.faces.front()).part;
    });
}

std::optional<double> height_of(const Machine& machine, const MeshSurface& surface)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& entry : surface.faces) {
        if (!entry.central)
            continue;
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
        const auto* cylinder = std::get_if<CylinderGeometry>(&geometry_of(machine, entry));
        if (!cylinder || (diameter && std::abs(2 * cylinder->radius - *diameter) > 1e-9))
            return std::nullopt;
        diameter = 2 * cylinder->radius;
    }
    return diameter;
}

/// Normals of the planes of a surface, each once.
std::vector<Vec3> normals_of(const Machine& machine, const MeshSurface& surface)
{
    std::vector<std::uint32_t> geometries;
    for (const auto& entry : surface.faces)
        if (const auto geometry = face_of(machine, entry).geometry; geometries.empty() || geometry != geometries.back())
            geometries.push_back(geometry);
    std::ranges::sort(geometries);
    const auto repeated = std::ranges::unique(geometries);
    geometries.erase(repeated.begin(), repeated.end());
    std::vector<Vec3> normals;
    for (const auto geometry : geometries)
        if (const auto* plane = std::get_if<PlaneGeometry>(&machine.geometries[geometry]))
            normals.push_back(plane->normal);
    return normals;
}

/// Per node of the machine: whether it is one of a surface's whole faces.
std::vector<char> nodes_of(const Machine& machine, const MeshSurface& surface)
{
    std::vector<char> held(machine.nodes.size(), 0);
    for (const auto& entry : surface.faces)
        for (std::size_t i = 0; entry.central && i < face_of(machine, entry).node_count; ++i)
            held[face_of(machine, entry).nodes[i]] = 1;
    return held;
}

/// The largest full cylinder along a surface's normal with a face that shares an edge with the surface's faces.
const CylinderGeometry* cylinder_around(const Machine& machine, const std::vector<char>& nodes,
                                        const std::vector<Vec3>& normals)
{
    const auto touches = [&](const Face& face) {
        return std::count_if(face.nodes.begin(), face.nodes.begin() + face.node_count,
                             [&](std::uint32_t node) { return nodes[node] != 0; }) >= 2;
    };
    const auto is_normal = [&](const Vec3& direction) {
        return std::ranges::any_of(normals,
                                   [&](const Vec3& normal) { return norm(cross(normal, direction)) < same_direction; });
    };
    const CylinderGeometry* widest = nullptr;
    for (const auto& face : machine.faces) {
        const auto* cylinder = std::get_if<CylinderGeometry>(&machine.geometries[face.geometry]);
        if (cylinder && !cylinder->bore && (!widest || cylinder->radius > widest->radius) && touches(face) &&
            is_normal(cylinder->axis))
            widest = cylinder;
    }
    return widest;
}

std::optional<double> disk_diameter(const Machine& machine, const MeshSurface& surface)
{
    if (!on_one_part(machine, surface))
        return std::nullopt;
    const auto normals = normals_of(machine, surface);
    if (normals.empty())
        return std::nullopt;
    const auto nodes = nodes_of(machine, surface);
    const auto* widest = cylinder_around(machine, nodes, normals);
    if (!widest)
        return std::nullopt;
    constexpr double rounding = 1e-6;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const Vec3 arm = machine.nodes[node] - widest->point;
        if (nodes[node] != 0 && !(norm(arm - dot(arm, widest->axis) * widest->axis) < widest->radius + rounding))
            return std::nullopt;
    }
    return 2 * widest->radius;
}

std::optional<double> area_over_perimeter(const Machine& machine, const MeshSurface& surface)
{
    if (surface.faces.empty())
        return std::nullopt;
    const auto& first = geometry_of(machine, surface.faces.front());
    const auto faces = whole_faces(surface);
    double area = 0;
    for (const auto& entry : faces) {
        if (!same_plane(first, geometry_of(machine, entry)))
            return std::nullopt;
        area += face_area(machine, face_of(machine, entry));
    }
    return area / perimeter_of(machine, faces);
}

Vec2 centre_in_plane(const Machine& machine, const Face& face)
{
    Vec3 centre{};
    for (std::size_t i = 0; i < face.node_count; ++i)
        centre = centre + (1.0 / face.node_count) * machine.nodes[face.nodes[i]];
    return {centre[0], centre[1]};
}

void add_share(std::vector<SurfaceShare>& shares, std::uint32_t part, double area)
{
    auto found = std::ranges::find(shares, part, &SurfaceShare::part);
    if (found == shares.end())
        found = shares.insert(found, {part, 0});
    found->area += area;
}

/// Moments, and the area on each part.
void add_areas(const Machine& machine, const MeshSurface& surface, SurfaceFigures& figures)
{
    PlaneMoments sum;
    double total = 0;
    for (const auto& entry : surface.faces) {
        const Face& face = face_of(machine, entry);
        const double area = entry.fraction * face_area(machine, face);
        const Vec2 place = centre_in_plane(machine, face);
        sum.mean = sum.mean + area * place;
        sum.mean_square += area * dot(place, place);
        total += area;
        add_share(figures.parts, face.part, area);
    }
    if (total > 0)
        figures.moments = {(1 / total) * sum.mean, sum.mean_square / total};
}

/// The origin of a part's integrals: parts far from the machine's origin would lose digits.
Vec3 origin_of(const Machine& machine, const MeshPart& part)
{
    return machine.nodes[machine.cells[part.first_cell].nodes[0]];
}

/// The four corners from an origin; a triangle is a quadrilateral whose last two corners coincide.
std::array<Vec3, 4> corners_of(const Machine& machine, const Face& face, const Vec3& origin)
{
    std::array<Vec3, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i)
        corners[i] = machine.nodes[face.nodes[std::min<std::size_t>(i, face.node_count - 1)]] - origin;
    return corners;
}

void add_point(VolumeMoments& moments, const Vec3& x, const Vec3& normal_area)
{
    const Vec2 outward{x[0] * normal_area[0], x[1] * normal_area[1]};
    moments.volume += dot(x, normal_area) / 3;
    moments.first = moments.first + Vec2{x[0] * outward[0] / 2, x[1] * outward[1] / 2};
    moments.second += (x[0] * x[0] * outward[0] + x[1] * x[1] * outward[1]) / 3;
}

void add_face(VolumeMoments& moments, const std::array<Vec3, 4>& p)
{
    constexpr double g = 0.3872983346207417;  // sqrt(0.15)
    constexpr std::array<double, 3> at{0.5 - g, 0.5, 0.5 + g};
    constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const double s = at[i], t = at[j];
            const Vec3 along_s = (1 - t) * (p[1] - p[0]) + t * (p[2] - p[3]);
            const Vec3 along_t = (1 - s) * (p[3] - p[0]) + s * (p[2] - p[1]);
            const Vec3 x = (1 - t) * p[0] + t * p[3] + s * along_s;
            add_point(moments, x, weight[i] * weight[j] * cross(along_s, along_t));
        }
}

VolumeMoments shifted(const VolumeMoments& moments, const Vec2& by)
{
    return {moments.volume, moments.first + moments.volume * by,
            moments.second + 2 * dot(by, moments.first) + moments.volume * dot(by, by)};
}

void measure_parts(Machine& machine)
{
    for (auto& part : machine.parts)
        part.moments = {};
    for (const auto& face : machine.faces) {
        auto& part = machine.parts[face.part];
        add_face(part.moments, corners_of(machine, face, origin_of(machine, part)));
    }
    for (auto& part : machine.parts) {
        const Vec3 origin = origin_of(machine, part);
        part.moments = shifted(part.moments, {origin[0], origin[1]});
    }
}

}  // namespace

SurfaceFigures figures_of(const Machine& machine, const MeshSurface& surface)
{
    SurfaceFigures figures;
    figures.height = height_of(machine, surface);
    figures.cylinder_diameter = cylinder_diameter(machine, surface);
    figures.disk_diameter = disk_diameter(machine, surface);
    figures.area_over_perimeter = area_over_perimeter(machine, surface);
    add_areas(machine, surface, figures);
    return figures;
}

void measure(Machine& machine)
{
    measure_parts(machine);
    for (auto& surface : machine.surfaces)
        surface.figures = figures_of(machine, surface);
}

}  // namespace deadpoint::machine
