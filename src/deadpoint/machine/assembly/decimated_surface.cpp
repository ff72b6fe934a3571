#include "deadpoint/machine/assembly/decimated_surface.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace deadpoint::machine {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::uint64_t mixed(std::uint64_t seed, std::uint64_t value)
{
    // The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
    std::uint64_t z = seed * 0x9e3779b97f4a7c15ull + value + 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

Vec3 vector_area(const std::vector<Vec3>& nodes, const Triangle& t)
{
    return 0.5 * cross(nodes[t[1]] - nodes[t[0]], nodes[t[2]] - nodes[t[0]]);
}

Vec3 vector_area(const Machine& machine, const Face& face)
{
    const auto& n = face.nodes;
    Vec3 area = vector_area(machine.nodes, {n[0], n[1], n[2]});
    if (face.node_count == 4)
        area = area + vector_area(machine.nodes, {n[0], n[2], n[3]});
    return area;
}

// Which side of its geometry a face is on: cylinders have eight, freeform surfaces six, planes one.
std::uint64_t side_of(const Machine& machine, const Face& face)
{
    const auto& geometry = machine.geometries[face.geometry];
    if (std::holds_alternative<PlaneGeometry>(geometry))
        return 0;
    const Vec3 normal = vector_area(machine, face);
    std::size_t main = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[main]))
            main = i;
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        std::size_t along = 0;
        for (std::size_t i = 1; i < 3; ++i)
            if (std::abs(cylinder->axis[i]) > std::abs(cylinder->axis[along]))
                along = i;
        const double angle = std::atan2(normal[(along + 2) % 3], normal[(along + 1) % 3]);
        return 1 + static_cast<std::uint64_t>(std::floor(angle / (std::numbers::pi / 4) + 4.5)) % 8;
    }
    return 1 + 2 * main + (normal[main] > 0 ? 1 : 0);
}

// Per node, a number that stands for the set of solid faces on which it lies; 0 inside.
std::vector<std::uint64_t> places(const Machine& machine)
{
    std::vector<std::pair<std::uint32_t, std::uint64_t>> pairs;
    for (const auto& face : machine.faces) {
        const std::uint64_t code = 16ull * face.geometry + side_of(machine, face);
        for (std::size_t i = 0; i < face.node_count; ++i)
            pairs.emplace_back(face.nodes[i], code);
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<std::uint64_t> result(machine.nodes.size(), 0);
    for (const auto& [node, code] : pairs)
        result[node] = mixed(result[node], code);
    return result;
}

class Clusters {
public:
    explicit Clusters(const Machine& machine)
        : machine_(machine), place_(places(machine)), owner_(machine.nodes.size()), fineness_(machine.parts.size(), 0.0)
    {
        std::vector<bool> used(machine.nodes.size(), false);
        for (const auto& face : machine.faces) {
            fineness_[face.part] += norm(vector_area(machine, face));
            for (std::size_t i = 0; i < face.node_count; ++i) {
                owner_[face.nodes[i]] = face.part;
                used[face.nodes[i]] = true;
            }
        }
        const double largest = *std::ranges::max_element(fineness_);
        for (double& part : fineness_)
            part = std::pow(part / largest, 0.25);
        for (std::uint32_t node = 0; node < machine.nodes.size(); ++node)
            if (used[node])
                nodes_.push_back(node);
        representative_.resize(machine.nodes.size());
        cluster_.resize(machine.nodes.size());
        halvings_.resize(machine.nodes.size());
        keep_all();
    }

    void keep_all()
    {
        for (const auto node : nodes_)
            representative_[node] = node;
    }

    // Merges the nodes in each box of edge `grid`; with `faces` only nodes on the same faces of the solid. The edge of
    // a box scales with the fourth root of the part's area, so small parts have fewer triangles, but more per area.
    // If the surface would fold over, for example beside a hole as large as a box, boxes are halved until it does not.
    void merge(double grid, bool faces)
    {
        constexpr int most_halvings = 5;
        std::ranges::fill(halvings_, 0);
        merge_boxes(grid, faces);
        for (int round = 0; faces && round < most_halvings && halve_at_folds(); ++round)
            merge_boxes(grid, faces);
    }

    // Calls visit for each triangle of a face that has not degenerated to a line.
    template <class Visit>
    void for_triangles(const Face& face, Visit&& visit) const
    {
        for (std::size_t k = 1; k + 1 < face.node_count; ++k) {
            const Triangle t{representative_[face.nodes[0]], representative_[face.nodes[k]],
                             representative_[face.nodes[k + 1]]};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
                visit(t);
        }
    }

    [[nodiscard]] double finest() const { return *std::ranges::min_element(fineness_); }

    [[nodiscard]] std::size_t count() const
    {
        std::size_t result = 0;
        for (const auto& face : machine_.faces)
            for_triangles(face, [&](const Triangle&) { ++result; });
        return result;
    }

private:
    struct Cluster {
        Vec3 sum{};
        std::size_t count = 0;
        std::uint32_t best = 0;
        double distance = std::numeric_limits<double>::infinity();
    };

    void merge_boxes(double grid, bool faces)
    {
        std::unordered_map<std::uint64_t, std::uint32_t> index;
        std::vector<Cluster> clusters;
        for (const auto node : nodes_) {
            const double edge = std::ldexp(grid * fineness_[owner_[node]], -halvings_[node]);
            std::uint64_t key =
                mixed(owner_[node] + (static_cast<std::uint64_t>(halvings_[node]) << 32), faces ? place_[node] : 0);
            for (const double x : machine_.nodes[node])
                key = mixed(key, static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / edge))));
            const auto at = index.try_emplace(key, static_cast<std::uint32_t>(clusters.size())).first->second;
            if (at == clusters.size())
                clusters.emplace_back();
            clusters[at].sum = clusters[at].sum + machine_.nodes[node];
            ++clusters[at].count;
            cluster_[node] = at;
        }
        for (const auto node : nodes_) {
            auto& cluster = clusters[cluster_[node]];
            const Vec3 centre = (1.0 / static_cast<double>(cluster.count)) * cluster.sum;
            const double distance = norm(machine_.nodes[node] - centre);
            if (distance < cluster.distance) {
                cluster.distance = distance;
                cluster.best = node;
            }
        }
        for (const auto node : nodes_)
            representative_[node] = clusters[cluster_[node]].best;
    }

    // Halves the boxes that meet in an inverted triangle; returns whether there were any.
    bool halve_at_folds()
    {
        std::vector<bool> folded(machine_.nodes.size(), false);  // by cluster
        bool any = false;
        for (const auto& face : machine_.faces) {
            const Vec3 before = vector_area(machine_, face);
            bool turned = false;
            for_triangles(
                face, [&](const Triangle& t) { turned = turned || dot(vector_area(machine_.nodes, t), before) < 0; });
            for (std::size_t i = 0; turned && i < face.node_count; ++i)
                folded[cluster_[face.nodes[i]]] = any = true;
        }
        for (const auto node : nodes_)
            if (folded[cluster_[node]])
                ++halvings_[node];
        return any;
    }

    const Machine& machine_;
    std::vector<std::uint64_t> place_;
    std::vector<std::uint32_t> owner_;  // part of each node
    std::vector<double> fineness_;      // per part: edge of its boxes relative to that of the largest part
    std::vector<std::uint32_t> nodes_;  // nodes of the outer surface
    std::vector<std::uint32_t> representative_;
    std::vector<std::uint32_t> cluster_;
    std::vector<int> halvings_;  // of the box of each node
};

// Widens the grid until the triangles suffice; its final edge.
double coarsen(const Machine& machine, Clusters& clusters, std::size_t most)
{
    std::size_t count = clusters.count();
    if (count <= most)
        return 0;
    double area = 0, size = 0;
    for (const auto& face : machine.faces)
        area += norm(vector_area(machine, face));
    for (const auto& node : machine.nodes)
        size = std::max(size, norm(node - machine.nodes.front()));
    const double widest = 4 * size / std::max(1e-3, clusters.finest());
    for (const bool faces : {true, false}) {
        double grid = std::sqrt(2 * area / static_cast<double>(most));
        while (grid < widest) {
            clusters.merge(grid, faces);
            count = clusters.count();
            if (count <= most)
                return grid;
            grid *= std::clamp(std::sqrt(static_cast<double>(count) / static_cast<double>(most)), 1.06, 1.6);
        }
    }
    return widest;
}

// Numbers the vertices of a part as its triangles meet them.
class Collector {
public:
    explicit Collector(const Machine& machine) : machine_(machine), number_(machine.nodes.size(), none)
    {
        corner_.resize(machine.nodes.size());
        for (const auto& face : machine.faces) {
            const auto& cell = machine.cells[face.cell];
            const std::uint32_t count = cell.kind == CellKind::hexahedron ? 8 : 4;
            for (std::uint32_t i = 0; i < count; ++i)
                corner_[cell.nodes[i]] = {face.cell, i};
        }
    }

    void add(const Triangle& nodes, LightPart& part)
    {
        Triangle t;
        for (std::size_t i = 0; i < 3; ++i) {
            auto& number = number_[nodes[i]];
            if (number == none) {
                number = static_cast<std::uint32_t>(surface.vertices.size());
                surface.vertices.push_back(corner_[nodes[i]]);
                surface.positions.push_back(machine_.nodes[nodes[i]]);
            }
            t[i] = number;
        }
        surface.triangles.push_back(t);
        part.area += norm(vector_area(surface.positions, t));
    }

    DecimatedSurface surface;

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    const Machine& machine_;
    std::vector<std::uint32_t> number_;
    std::vector<CellCorner> corner_;
};

}  // namespace

DecimatedSurface decimated_surface(const Machine& machine, std::size_t most_triangles)
{
    Clusters clusters(machine);
    const double grid = coarsen(machine, clusters, most_triangles);

    std::vector<std::vector<std::uint32_t>> faces(machine.parts.size()), cuts(machine.parts.size());
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        (machine.faces[f].symmetry ? cuts : faces)[machine.faces[f].part].push_back(f);

    Collector collector(machine);
    auto& surface = collector.surface;
    for (std::size_t p = 0; p < machine.parts.size(); ++p) {
        LightPart part;
        part.first_vertex = surface.vertices.size();
        part.first_triangle = surface.triangles.size();
        const auto take = [&](const std::vector<std::uint32_t>& list) {
            for (const auto f : list) {
                part.full_area += norm(vector_area(machine, machine.faces[f]));
                clusters.for_triangles(machine.faces[f], [&](const Triangle& t) { collector.add(t, part); });
                surface.faces.resize(surface.triangles.size(), f);
            }
        };
        take(faces[p]);
        const std::size_t outside = surface.triangles.size();
        take(cuts[p]);
        part.symmetry_triangles = surface.triangles.size() - outside;
        part.vertex_count = surface.vertices.size() - part.first_vertex;
        part.triangle_count = surface.triangles.size() - part.first_triangle;
        surface.parts.push_back(part);
    }
    surface.grid = grid;
    return std::move(surface);
}

}  // namespace deadpoint::machine
