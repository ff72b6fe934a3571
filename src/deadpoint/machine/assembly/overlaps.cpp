#include "deadpoint/machine/assembly/overlaps.hpp"

#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/cell_finder.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace deadpoint::machine {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

bool shares_space(const BoxShape& a, const BoxShape& b)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.min[i] + least_overlap > b.max[i] || b.min[i] + least_overlap > a.max[i]) {
            return false;
        }
    }
    return true;
}

bool contains(const BoxShape& box, const Vec3& point)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (point[i] < box.min[i] || point[i] > box.max[i]) {
            return false;
        }
    }
    return true;
}

/// Depth of a point inside a surface, as if the surface were unbounded.
double depth_below(const FaceGeometry& geometry, const Vec3& point)
{
    if (const auto* plane = std::get_if<PlaneGeometry>(&geometry)) {
        return plane->offset - dot(plane->normal, point);
    }
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        const Vec3 arm = point - cylinder->point;
        const double distance = norm(arm - dot(arm, cylinder->axis) * cylinder->axis);
        return cylinder->bore ? distance - cylinder->radius : cylinder->radius - distance;
    }
    return unbounded;
}

/// Computes how deep points lie inside a part that is known only by its cells.
class CellDepth {
public:
    CellDepth(const Assembly& assembly, std::uint32_t part)
        : machine_(assembly.machine), finder_(assembly, part), faces_(finder_.bins().size())
    {
        for (std::uint32_t f = 0; f < machine_.faces.size(); ++f) {
            const Face& face = machine_.faces[f];
            if (face.part != part) {
                continue;
            }
            BoxShape around = empty_box();
            for (int k = 0; k < face.node_count; ++k) {
                include(around, machine_.nodes[face.nodes[k]]);
            }
            const double margin = norm(around.max - around.min);
            for (std::size_t i = 0; i < 3; ++i) {
                around.min[i] -= margin;
                around.max[i] += margin;
            }
            finder_.bins().visit(around, [&](std::size_t bin) { faces_[bin].push_back(f); });
        }
    }

    [[nodiscard]] double operator()(const Vec3& point) const
    {
        if (!finder_.holds(point)) {
            return -unbounded;
        }
        double result = unbounded;
        double reach = 0;
        for (const std::uint32_t f : faces_[finder_.bins().at(point)]) {
            const Face& face = machine_.faces[f];
            if (face.symmetry) {
                continue;
            }
            const Vec3 outwards = area_vector(face, machine_.nodes);
            const double size = std::sqrt(norm(outwards));
            reach = std::max(reach, size);
            if (norm(point - centre(face, machine_.nodes)) > 2 * size) {
                continue;
            }
            const double facet = dot(centre(face, machine_.nodes) - point, normalised(outwards));
            result = std::min({result, facet, depth_below(machine_.geometries[face.geometry], point)});
        }
        return std::isfinite(result) ? result : std::max(reach, 2 * least_overlap);
    }

private:
    const Machine& machine_;
    CellFinder finder_;
    std::vector<std::vector<std::uint32_t>> faces_;
};

/// Points of the true solids: nodes, centres of cells and of exterior faces, without those that chords of bores put
/// outside of the true solid.
std::vector<std::vector<Vec3>> sample_points(const Machine& machine, const std::vector<std::vector<Prism>>& shapes)
{
    constexpr double outside = -1e-6;
    std::vector<std::vector<Vec3>> points(machine.parts.size());
    const auto add = [&](std::uint32_t part, const Vec3& point) {
        if (shapes[part].empty() || depth(shapes[part], point) > outside) {
            points[part].push_back(point);
        }
    };
    std::vector<char> seen(machine.nodes.size(), 0);
    for (const Cell& cell : machine.cells) {
        add(cell.part, centre(cell, machine.nodes));
        for (int i = 0; i < node_count(cell.kind); ++i) {
            if (seen[cell.nodes[i]] != 0) {
                continue;
            }
            seen[cell.nodes[i]] = 1;
            points[cell.part].push_back(machine.nodes[cell.nodes[i]]);
        }
    }
    for (const Face& face : machine.faces) {
        const bool flat = std::holds_alternative<PlaneGeometry>(machine.geometries[face.geometry]);
        if (flat) {
            add(face.part, centre(face, machine.nodes));
        }
    }
    return points;
}

}  // namespace

std::vector<Overlap> find_overlaps(const Assembly& assembly, const std::vector<std::vector<Prism>>& shapes)
{
    const Machine& machine = assembly.machine;
    const std::vector<std::vector<Vec3>> points = sample_points(machine, shapes);
    std::vector<std::unique_ptr<CellDepth>> by_cells(machine.parts.size());
    const auto depth_in = [&](std::uint32_t part, const Vec3& point) {
        if (!shapes[part].empty()) {
            return depth(shapes[part], point);
        }
        if (!by_cells[part]) {
            by_cells[part] = std::make_unique<CellDepth>(assembly, part);
        }
        return (*by_cells[part])(point);
    };
    std::vector<Overlap> overlaps;
    for (std::uint32_t i = 0; i < machine.parts.size(); ++i) {
        for (std::uint32_t j = i + 1; j < machine.parts.size(); ++j) {
            if (!shares_space(assembly.bounds[i], assembly.bounds[j])) {
                continue;
            }
            Overlap overlap{machine.parts[i].name, machine.parts[j].name, {}, 0};
            const auto test = [&](std::uint32_t own, std::uint32_t other) {
                for (const Vec3& point : points[own]) {
                    if (!contains(assembly.bounds[other], point)) {
                        continue;
                    }
                    const double deep = depth_in(other, point);
                    if (deep > overlap.depth) {
                        overlap.depth = deep;
                        overlap.where = point;
                    }
                }
            };
            test(i, j);
            test(j, i);
            if (overlap.depth > least_overlap) {
                overlaps.push_back(overlap);
            }
        }
    }
    return overlaps;
}

}  // namespace deadpoint::machine
