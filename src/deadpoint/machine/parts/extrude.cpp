#include "deadpoint/machine/parts/extrude.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"
#include "deadpoint/machine/parts/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace deadpoint::machine {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b)
{
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

struct Layer {
    std::uint32_t slab = 0;
    double bottom = 0;
    double top = 0;
};

std::vector<Layer> layers_of(const LayeredPart& part, double size)
{
    std::vector<Layer> layers;
    for (std::uint32_t slab = 0; slab + 1 < part.positions.size(); ++slab) {
        const double from = part.positions[slab];
        const double to = part.positions[slab + 1];
        const int count = steps(to - from, size);
        for (int i = 0; i < count; ++i) {
            const double bottom = i == 0 ? from : layers.back().top;
            const double top = i + 1 == count ? to : from + (to - from) * (i + 1) / count;
            layers.push_back({slab, bottom, top});
        }
    }
    return layers;
}

struct QuadEdge {
    std::array<std::uint32_t, 2> quads{none, none};
    std::uint32_t curve = none;
};

/// Component noise of directions that are meant to be along an axis.
double cleaned(double component)
{
    if (std::abs(component) < 1e-12) {
        return 0;
    }
    return std::abs(std::abs(component) - 1) < 1e-12 ? std::copysign(1.0, component) : component;
}

class Extruder {
public:
    Extruder(const LayeredPart& part, const PlaneMesh& plane, double size)
        : part_(part), plane_(plane), layers_(layers_of(part, size)), quads_(plane.quads)
    {
        if (part.axis == Axis::y) {  // (x, z, y) is left-handed
            for (auto& quad : quads_) {
                std::swap(quad[1], quad[3]);
            }
        }
        for (std::uint32_t q = 0; q < quads_.size(); ++q) {
            for (std::size_t i = 0; i < 4; ++i) {
                QuadEdge& edge = edges_[edge_key(quads_[q][i], quads_[q][(i + 1) % 4])];
                edge.quads[edge.quads[0] == none ? 0 : 1] = q;
            }
        }
        for (const auto& curve_edge : plane.curve_edges) {
            const auto found = edges_.find(edge_key(curve_edge.from, curve_edge.to));
            if (found != edges_.end()) {
                found->second.curve = curve_edge.curve;
            }
        }
        node_ids_.assign(plane.nodes.size() * (layers_.size() + 1), none);
    }

    PartMesh run()
    {
        for (std::uint32_t layer = 0; layer < layers_.size(); ++layer) {
            for (std::uint32_t quad = 0; quad < quads_.size(); ++quad) {
                if (solid(quad, layer)) {
                    add_cell(quad, layer);
                }
            }
        }
        return std::move(mesh_);
    }

private:
    [[nodiscard]] bool solid(std::uint32_t quad, std::uint32_t layer) const
    {
        return layer < layers_.size() && plane_.signatures[plane_.region[quad]][layers_[layer].slab] != 0;
    }

    std::uint32_t node(std::uint32_t plane_node, std::uint32_t level)
    {
        std::uint32_t& id = node_ids_[level * plane_.nodes.size() + plane_node];
        if (id == none) {
            id = static_cast<std::uint32_t>(mesh_.nodes.size());
            const double position = level == 0 ? layers_.front().bottom : layers_[level - 1].top;
            mesh_.nodes.push_back(point_at(part_.axis, plane_.nodes[plane_node], position));
        }
        return id;
    }

    void add_cell(std::uint32_t quad, std::uint32_t layer)
    {
        Cell cell;
        for (std::size_t i = 0; i < 4; ++i) {
            cell.nodes[i] = node(quads_[quad][i], layer);
            cell.nodes[i + 4] = node(quads_[quad][i], layer + 1);
        }
        const auto index = static_cast<std::uint32_t>(mesh_.cells.size());
        mesh_.cells.push_back(cell);
        const auto& n = cell.nodes;
        if (layer == 0 || !solid(quad, layer - 1)) {
            add_face(index, {n[0], n[3], n[2], n[1]}, end_plane(-1, layers_[layer].bottom));
        }
        if (!solid(quad, layer + 1)) {
            add_face(index, {n[4], n[5], n[6], n[7]}, end_plane(1, layers_[layer].top));
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t j = (i + 1) % 4;
            const QuadEdge& edge = edges_.at(edge_key(quads_[quad][i], quads_[quad][j]));
            const std::uint32_t neighbour = edge.quads[0] == quad ? edge.quads[1] : edge.quads[0];
            if (neighbour != none && solid(neighbour, layer)) {
                continue;
            }
            add_face(index, {n[i], n[j], n[j + 4], n[i + 4]}, side(edge.curve, quad));
        }
    }

    void add_face(std::uint32_t cell, const std::array<std::uint32_t, 4>& nodes, const FaceGeometry& geometry)
    {
        Face face;
        face.cell = cell;
        face.nodes = nodes;
        face.geometry = geometry_index(geometry);
        mesh_.faces.push_back(face);
    }

    [[nodiscard]] FaceGeometry end_plane(double sign, double position) const
    {
        PlaneGeometry plane;
        plane.normal[index_of(part_.axis)] = sign;
        plane.offset = sign * position;
        return plane;
    }

    /// The surface that a curve extrudes to, for the quadrilateral beside it.
    [[nodiscard]] FaceGeometry side(std::uint32_t curve_index, std::uint32_t quad) const
    {
        if (curve_index == none) {
            return FreeformGeometry{};
        }
        const PlaneCurve& curve = plane_.curves[curve_index];
        Vec2 middle{};
        for (const std::uint32_t corner : quads_[quad]) {
            middle = middle + 0.25 * plane_.nodes[corner];
        }
        if (curve.circle) {
            CylinderGeometry cylinder;
            cylinder.point = point_at(part_.axis, curve.circle->centre, 0);
            cylinder.axis[index_of(part_.axis)] = 1;
            cylinder.radius = curve.circle->radius;
            cylinder.bore = norm(middle - curve.circle->centre) > curve.circle->radius;
            return cylinder;
        }
        const Vec2 direction = curve.to - curve.from;
        Vec2 normal = (1 / norm(direction)) * Vec2{direction[1], -direction[0]};
        if (dot(normal, middle - curve.from) > 0) {
            normal = -1.0 * normal;
        }
        normal = {cleaned(normal[0]), cleaned(normal[1])};
        PlaneGeometry plane;
        plane.normal = point_at(part_.axis, normal, 0);
        plane.offset = dot(normal, curve.from);
        return plane;
    }

    std::uint32_t geometry_index(const FaceGeometry& geometry)
    {
        for (std::size_t i = 0; i < mesh_.geometries.size(); ++i) {
            if (same(mesh_.geometries[i], geometry)) {
                return static_cast<std::uint32_t>(i);
            }
        }
        mesh_.geometries.push_back(geometry);
        return static_cast<std::uint32_t>(mesh_.geometries.size() - 1);
    }

    static bool same(const FaceGeometry& a, const FaceGeometry& b)
    {
        constexpr double tolerance = 1e-9;
        if (a.index() != b.index()) {
            return false;
        }
        if (const auto* p = std::get_if<PlaneGeometry>(&a)) {
            const auto& q = std::get<PlaneGeometry>(b);
            return norm(p->normal - q.normal) < tolerance && std::abs(p->offset - q.offset) < tolerance;
        }
        if (const auto* c = std::get_if<CylinderGeometry>(&a)) {
            const auto& d = std::get<CylinderGeometry>(b);
            return c->bore == d.bore && norm(c->point - d.point) < tolerance &&
                   std::abs(c->radius - d.radius) < tolerance;
        }
        return true;
    }

    const LayeredPart& part_;
    const PlaneMesh& plane_;
    std::vector<Layer> layers_;
    std::vector<std::array<std::uint32_t, 4>> quads_;
    std::unordered_map<std::uint64_t, QuadEdge> edges_;
    std::vector<std::uint32_t> node_ids_;
    PartMesh mesh_;
};

}  // namespace

PartMesh extrude(const LayeredPart& part, const PlaneMesh& plane, double size)
{
    if (part.positions.size() < 2 || plane.quads.empty()) {
        return {};
    }
    return Extruder(part, plane, size).run();
}

}  // namespace deadpoint::machine
