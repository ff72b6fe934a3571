#include "deadpoint/machine/assembly/assembly.hpp"

#include "deadpoint/machine/geometry/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::machine {

namespace {

constexpr double symmetry_tolerance = 1e-9;

bool on_symmetry_plane(const FaceGeometry& geometry)
{
    const auto* plane = std::get_if<PlaneGeometry>(&geometry);
    return plane != nullptr && plane->normal[0] > 1 - 1e-9 && std::abs(plane->offset) < symmetry_tolerance;
}

BoxShape bounds_of(const std::vector<Vec3>& nodes)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BoxShape box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (const Vec3& node : nodes) {
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], node[i]);
            box.max[i] = std::max(box.max[i], node[i]);
        }
    }
    return box;
}

void measure_cells(MeshPart& part, const PartMesh& mesh, double density)
{
    part.min_quality = 1;
    for (const Cell& cell : mesh.cells) {
        const double own = quality(cell, mesh.nodes);
        part.volume += volume(cell, mesh.nodes);
        part.min_quality = std::min(part.min_quality, own);
        part.mean_quality += own / static_cast<double>(mesh.cells.size());
    }
    part.mass = density * part.volume;
}

/// The index of the coordinate axis a unit vector lies along, or -1.
int axis_along(const Vec3& direction)
{
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(direction[i]) - 1) < 1e-9) {
            return i;
        }
    }
    return -1;
}

/// Where the numbers of the next part begin.
struct NextNumbers {
    explicit NextNumbers(const Machine& machine)
        : part(static_cast<std::uint32_t>(machine.parts.size())),
          node(static_cast<std::uint32_t>(machine.nodes.size())),
          cell(static_cast<std::uint32_t>(machine.cells.size())),
          face(static_cast<std::uint32_t>(machine.faces.size())),
          geometry(static_cast<std::uint32_t>(machine.geometries.size()))
    {}
    std::uint32_t part, node, cell, face, geometry;
};

void snap_to_symmetry(PartMesh& mesh)
{
    for (Vec3& node : mesh.nodes) {
        if (std::abs(node[0]) < symmetry_tolerance) {
            node[0] = 0;
        }
    }
}

/// Numbers a part's faces as the machine's, and files those on its outside by their geometry.
void number_faces(Assembly& assembly, const NextNumbers& next, PartMesh& mesh, MeshPart& part)
{
    assembly.part_of_geometry.resize(next.geometry + mesh.geometries.size(), next.part);
    assembly.faces_of_geometry.resize(next.geometry + mesh.geometries.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        Face& face = mesh.faces[i];
        face.symmetry = assembly.machine.half_model && on_symmetry_plane(mesh.geometries[face.geometry]);
        part.cut = part.cut || face.symmetry;
        if (!face.symmetry) {
            part.exterior_area += area(face, mesh.nodes);
        }
        face.part = next.part;
        face.cell += next.cell;
        face.geometry += next.geometry;
        for (std::uint32_t& node : face.nodes) {
            node += next.node;
        }
        if (!face.symmetry) {
            assembly.faces_of_geometry[face.geometry].push_back(next.face + static_cast<std::uint32_t>(i));
        }
    }
}

void number_cells(const NextNumbers& next, PartMesh& mesh)
{
    for (Cell& cell : mesh.cells) {
        cell.part = next.part;
        for (int i = 0; i < node_count(cell.kind); ++i) {
            cell.nodes[i] += next.node;
        }
    }
}

void take_groups(Assembly& assembly, const NextNumbers& next, PartMesh& mesh)
{
    for (FaceGroup& group : mesh.groups) {
        for (std::uint32_t& face : group.faces) {
            face += next.face;
        }
        assembly.groups.push_back({next.part, std::move(group)});
    }
}

}  // namespace

double millimetres(double length)
{
    const double rounded = std::round(length * 1e7) / 1e4;
    return rounded == 0 ? 0.0 : rounded;
}

void append(Assembly& assembly, const PartDescription& description, PartMesh mesh)
{
    Machine& machine = assembly.machine;
    if (machine.half_model) {
        snap_to_symmetry(mesh);
    }
    const NextNumbers next(machine);
    MeshPart part;
    part.name = description.name;
    part.body = description.body;
    part.first_cell = next.cell;
    part.cell_count = static_cast<std::uint32_t>(mesh.cells.size());
    part.kind = mesh.kind;
    measure_cells(part, mesh, description.density);
    number_faces(assembly, next, mesh, part);
    number_cells(next, mesh);
    take_groups(assembly, next, mesh);
    assembly.bounds.push_back(bounds_of(mesh.nodes));
    machine.nodes.insert(machine.nodes.end(), mesh.nodes.begin(), mesh.nodes.end());
    machine.cells.insert(machine.cells.end(), mesh.cells.begin(), mesh.cells.end());
    machine.faces.insert(machine.faces.end(), mesh.faces.begin(), mesh.faces.end());
    machine.geometries.insert(machine.geometries.end(), mesh.geometries.begin(), mesh.geometries.end());
    machine.parts.push_back(std::move(part));
}

std::string describe(const FaceGeometry& geometry)
{
    static constexpr std::array<const char*, 3> names{"x", "y", "z"};
    if (const auto* plane = std::get_if<PlaneGeometry>(&geometry)) {
        const int axis = axis_along(plane->normal);
        if (axis < 0) {
            const Vec3 foot = plane->offset * plane->normal;
            return fmt::format("plane of normal ({:.4f}, {:.4f}, {:.4f}) through ({}, {}, {}) mm", plane->normal[0],
                               plane->normal[1], plane->normal[2], millimetres(foot[0]), millimetres(foot[1]),
                               millimetres(foot[2]));
        }
        return fmt::format("plane {} = {} mm", names[axis], millimetres(plane->offset * plane->normal[axis]));
    }
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        const char* kind = cylinder->bore ? "bore" : "cylinder";
        const int axis = axis_along(cylinder->axis);
        if (axis < 0) {
            return fmt::format("oblique {} of diameter {} mm", kind, millimetres(2 * cylinder->radius));
        }
        const Vec2 centre = project(static_cast<Axis>(axis), cylinder->point);
        return fmt::format("{} of diameter {} mm along {} about ({}, {}) mm", kind, millimetres(2 * cylinder->radius),
                           names[axis], millimetres(centre[0]), millimetres(centre[1]));
    }
    return "freeform surface";
}

}  // namespace deadpoint::machine
