#include "deadpoint/exchange/round_edges.hpp"

#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <utility>

namespace deadpoint {
namespace {

/// An edge between two corners of a face or cell.
using Corners = std::array<int, 2>;
constexpr std::array<Corners, 4> quadrilateral_edges{{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
constexpr std::array<Corners, 3> triangle_edges{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<Corners, 12> hexahedron_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<Corners, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

template <typename Edges, typename Nodes>
bool any_round(const Machine& machine, const Edges& edges, const Nodes& nodes)
{
    return !machine.round_edges.empty() && std::any_of(edges.begin(), edges.end(), [&](const Corners& edge) {
        return bulge(machine, nodes[edge[0]], nodes[edge[1]]) != Vec3{};
    });
}

/// A function of the corner: 1 there, 0 at the others; its derivatives by r and s.
struct NodeFunction {
    double value = 0;
    double by_r = 0;
    double by_s = 0;
};

std::array<NodeFunction, 4> corner_shapes(const Face& face, const Vec2& local)
{
    const auto [r, s] = local;
    if (face.node_count == 3) {
        return {{{1 - r - s, -1, -1}, {r, 1, 0}, {s, 0, 1}, {}}};
    }
    return {{{(1 - r) * (1 - s), s - 1, r - 1}, {r * (1 - s), 1 - s, -r}, {r * s, s, r}, {(1 - r) * s, -s, 1 - r}}};
}

/// Function of the middle of an edge, which is 1 there: 4 a b.
NodeFunction triangle_edge(const NodeFunction& a, const NodeFunction& b)
{
    return {4 * a.value * b.value, 4 * (a.by_r * b.value + a.value * b.by_r),
            4 * (a.by_s * b.value + a.value * b.by_s)};
}

/// 4 u (1 - u) along the edge, falling linearly to the opposite one.
NodeFunction quadrilateral_edge(int edge, const Vec2& local)
{
    const bool along_r = edge % 2 == 0, far = edge == 1 || edge == 2;
    const double u = local[along_r ? 0 : 1], v = local[along_r ? 1 : 0];
    const double across = far ? v : 1 - v;
    const double by_u = 4 * (1 - 2 * u) * across, by_v = 4 * u * (1 - u) * (far ? 1 : -1);
    return {4 * u * (1 - u) * across, along_r ? by_u : by_v, along_r ? by_v : by_u};
}

constexpr std::array<std::array<bool, 3>, 8> far_corner{{{false, false, false},
                                                         {true, false, false},
                                                         {true, true, false},
                                                         {false, true, false},
                                                         {false, false, true},
                                                         {true, false, true},
                                                         {true, true, true},
                                                         {false, true, true}}};

double along(int corner, std::size_t axis, double u) { return far_corner[corner][axis] ? u : 1 - u; }

double hexahedron_edge(const Corners& edge, const Vec3& local)
{
    double product = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool lengthwise = far_corner[edge[0]][i] != far_corner[edge[1]][i];
        product *= lengthwise ? 4 * local[i] * (1 - local[i]) : along(edge[0], i, local[i]);
    }
    return product;
}

Vec3 in_hexahedron(const Machine& machine, const Cell& cell, const Vec3& local)
{
    Vec3 result{};
    for (int i = 0; i < 8; ++i) {
        const double value = along(i, 0, local[0]) * along(i, 1, local[1]) * along(i, 2, local[2]);
        result = result + value * machine.nodes[cell.nodes[i]];
    }
    for (const Corners& edge : hexahedron_edges) {
        const Vec3 own = bulge(machine, cell.nodes[edge[0]], cell.nodes[edge[1]]);
        result = result + hexahedron_edge(edge, local) * own;
    }
    return result;
}

Vec3 in_tetrahedron(const Machine& machine, const Cell& cell, const Vec3& local)
{
    const std::array<double, 4> corner{1 - local[0] - local[1] - local[2], local[0], local[1], local[2]};
    Vec3 result{};
    for (int i = 0; i < 4; ++i) {
        result = result + corner[i] * machine.nodes[cell.nodes[i]];
    }
    for (const auto& [a, b] : tetrahedron_edges) {
        result = result + (4 * corner[a] * corner[b]) * bulge(machine, cell.nodes[a], cell.nodes[b]);
    }
    return result;
}

}  // namespace

Vec3 bulge(const Machine& machine, std::uint32_t a, std::uint32_t b)
{
    const std::array<std::uint32_t, 2> key{std::min(a, b), std::max(a, b)};
    const auto found = std::ranges::lower_bound(machine.round_edges, key, {}, &RoundEdge::nodes);
    return found != machine.round_edges.end() && found->nodes == key ? found->bulge : Vec3{};
}

bool is_round(const Machine& machine, const Face& face)
{
    return face.node_count == 3 ? any_round(machine, triangle_edges, face.nodes)
                                : any_round(machine, quadrilateral_edges, face.nodes);
}

bool is_round(const Machine& machine, const Cell& cell)
{
    return cell.kind == CellKind::tetrahedron ? any_round(machine, tetrahedron_edges, cell.nodes)
                                              : any_round(machine, hexahedron_edges, cell.nodes);
}

FacePlace place_on(const Machine& machine, const Face& face, const Vec2& local)
{
    const auto corners = corner_shapes(face, local);
    FacePlace result;
    const auto add = [&](const NodeFunction& shape, const Vec3& x) {
        result.position = result.position + shape.value * x;
        result.along_r = result.along_r + shape.by_r * x;
        result.along_s = result.along_s + shape.by_s * x;
    };
    for (int i = 0; i < face.node_count; ++i) {
        add(corners[i], machine.nodes[face.nodes[i]]);
    }
    for (int i = 0; i < face.node_count; ++i) {
        const int next = (i + 1) % face.node_count;
        add(face.node_count == 3 ? triangle_edge(corners[i], corners[next]) : quadrilateral_edge(i, local),
            bulge(machine, face.nodes[i], face.nodes[next]));
    }
    return result;
}

Vec3 place_in(const Machine& machine, const Cell& cell, const Vec3& local)
{
    return cell.kind == CellKind::tetrahedron ? in_tetrahedron(machine, cell, local)
                                              : in_hexahedron(machine, cell, local);
}

}  // namespace deadpoint
