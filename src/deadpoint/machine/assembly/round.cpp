#include "deadpoint/machine/assembly/round.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/round_edges.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace deadpoint::machine {

namespace {

using NodePair = std::array<std::uint32_t, 2>;

/// A bulge below this share of the chord is rounding.
constexpr double least_bulge = 1e-9;
/// Least determinant of a cell with round edges, as a share of the mean of its straight one.
constexpr double least_determinant_share = 0.1;

/// The point of a surface nearest to another.
Vec3 projected(const FaceGeometry& geometry, const Vec3& point)
{
    if (const auto* plane = std::get_if<PlaneGeometry>(&geometry)) {
        return point - (dot(plane->normal, point) - plane->offset) * plane->normal;
    }
    const auto* cylinder = std::get_if<CylinderGeometry>(&geometry);
    if (cylinder == nullptr) {
        return point;
    }
    const Vec3 arm = point - cylinder->point;
    const Vec3 across = arm - dot(arm, cylinder->axis) * cylinder->axis;
    return norm(across) > 0 ? point + (cylinder->radius / norm(across) - 1) * across : point;
}

/// Where the middle of a chord comes to lie on all of some surfaces, by turns.
Vec3 middle_on(const std::vector<const FaceGeometry*>& surfaces, const Vec3& chord)
{
    constexpr int most_turns = 60;
    Vec3 point = chord;
    for (int turn = 0; turn < most_turns; ++turn) {
        const Vec3 before = point;
        for (const FaceGeometry* surface : surfaces) {
            point = projected(*surface, point);
        }
        if (point == before) {
            break;
        }
    }
    return point;
}

std::span<const Face> faces_of_last_part(const Machine& machine)
{
    const auto part = static_cast<std::uint32_t>(machine.parts.size() - 1);
    const auto first = std::ranges::find(machine.faces, part, &Face::part);
    return {first, machine.faces.end()};
}

/// The surfaces that meet in each edge of the last part.
std::map<NodePair, std::set<std::uint32_t>> surfaces_at_edges(const Machine& machine)
{
    std::map<NodePair, std::set<std::uint32_t>> result;
    for (const Face& face : faces_of_last_part(machine)) {
        for (int i = 0; i < face.node_count; ++i) {
            const auto [low, high] = std::minmax(face.nodes[i], face.nodes[(i + 1) % face.node_count]);
            result[{low, high}].insert(face.geometry);
        }
    }
    return result;
}

std::vector<RoundEdge> round_edges_of(const Machine& machine)
{
    std::vector<RoundEdge> result;
    for (const auto& [edge, geometries] : surfaces_at_edges(machine)) {
        std::vector<const FaceGeometry*> surfaces;
        for (const std::uint32_t geometry : geometries) {
            surfaces.push_back(&machine.geometries[geometry]);
        }
        if (std::ranges::none_of(surfaces, [](auto* s) { return std::holds_alternative<CylinderGeometry>(*s); })) {
            continue;
        }
        const Vec3& from = machine.nodes[edge[0]];
        const Vec3& to = machine.nodes[edge[1]];
        const Vec3 chord = 0.5 * (from + to);
        const Vec3 own = middle_on(surfaces, chord) - chord;
        if (norm(own) > least_bulge * norm(to - from)) {
            result.push_back({edge, own});
        }
    }
    return result;
}

/// Determinant of a cell's map. Its coordinates are of second degree at most along each direction, where central
/// differences are exact.
double determinant(const Machine& machine, const Cell& cell, const Vec3& local)
{
    constexpr double step = 0.25;
    std::array<Vec3, 3> along{};
    for (std::size_t i = 0; i < 3; ++i) {
        Vec3 before = local, after = local;
        before[i] -= step;
        after[i] += step;
        along[i] = (0.5 / step) * (place_in(machine, cell, after) - place_in(machine, cell, before));
    }
    return dot(along[0], cross(along[1], along[2]));
}

double least_determinant(const Machine& machine, const Cell& cell)
{
    double least = determinant(machine, cell, {0, 0, 0});
    for (const double r : {0.0, 0.5, 1.0}) {
        for (const double s : {0.0, 0.5, 1.0}) {
            for (const double t : {0.0, 0.5, 1.0}) {
                if (cell.kind == CellKind::hexahedron || r + s + t <= 1) {
                    least = std::min(least, determinant(machine, cell, {r, s, t}));
                }
            }
        }
    }
    return least;
}

bool distorted(const Machine& machine, const Cell& cell)
{
    const double mean = (cell.kind == CellKind::hexahedron ? 1 : 6) * volume(cell, machine.nodes);
    return is_round(machine, cell) && least_determinant(machine, cell) < least_determinant_share * mean;
}

void straighten(Machine& machine, const Cell& cell)
{
    const auto nodes = std::span(cell.nodes).first(static_cast<std::size_t>(node_count(cell.kind)));
    const auto has = [&](std::uint32_t node) { return std::ranges::count(nodes, node) > 0; };
    std::erase_if(machine.round_edges, [&](const RoundEdge& edge) { return has(edge.nodes[0]) && has(edge.nodes[1]); });
}

/// Straightens the edges of distorted cells, and of those that this leaves distorted. Returns how many there were.
std::size_t straighten_distorted(Machine& machine)
{
    std::size_t straightened = 0, before = 0;
    do {
        before = straightened;
        for (std::uint32_t c = machine.parts.back().first_cell; c < machine.cells.size(); ++c) {
            if (distorted(machine, machine.cells[c])) {
                straighten(machine, machine.cells[c]);
                ++straightened;
            }
        }
    } while (straightened > before);
    return straightened;
}

void measure_again(Machine& machine, double density)
{
    MeshPart& part = machine.parts.back();
    part.volume = part.exterior_area = 0;
    for (const Face& face : faces_of_last_part(machine)) {
        part.volume += face_volume(machine, face);
        part.exterior_area += face.symmetry ? 0 : area(machine, face);
    }
    part.mass = density * part.volume;
}

}  // namespace

std::size_t add_round_edges(Machine& machine, double density)
{
    const std::vector<RoundEdge> found = round_edges_of(machine);
    if (found.empty()) {
        return 0;
    }
    machine.round_edges.insert(machine.round_edges.end(), found.begin(), found.end());
    const std::size_t straightened = straighten_distorted(machine);
    measure_again(machine, density);
    return straightened;
}

double area(const Machine& machine, const Face& face)
{
    return is_round(machine, face) ? face_area(machine, face) : area(face, machine.nodes);
}

}  // namespace deadpoint::machine
