#include "deadpoint/machine/parts/layers.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::machine {

namespace {

constexpr int sweeps = 12;

double corner_sine(const PlaneMesh& mesh, const std::array<std::uint32_t, 4>& quad, std::size_t i)
{
    const Vec2 a = mesh.nodes[quad[(i + 1) % 4]] - mesh.nodes[quad[i]];
    const Vec2 b = mesh.nodes[quad[(i + 3) % 4]] - mesh.nodes[quad[i]];
    const double lengths = norm(a) * norm(b);
    return lengths > 0 ? (a[0] * b[1] - a[1] * b[0]) / lengths : -1.0;
}

double worst_around(const PlaneMesh& mesh, const std::vector<std::uint32_t>& quads)
{
    double worst = 1;
    for (const std::uint32_t quad : quads) {
        worst = std::min(worst, worst_corner(mesh, quad));
    }
    return worst;
}

/// Target of a node: the mean of the other ends of its edges.
Vec2 mean_of_neighbours(const PlaneMesh& mesh, const std::vector<std::uint32_t>& quads, std::uint32_t node)
{
    Vec2 sum{};
    for (const std::uint32_t q : quads) {
        const auto& quad = mesh.quads[q];
        const auto at = static_cast<std::size_t>(std::find(quad.begin(), quad.end(), node) - quad.begin());
        sum = sum + mesh.nodes[quad[(at + 1) % 4]] + mesh.nodes[quad[(at + 3) % 4]];
    }
    return (0.5 / static_cast<double>(quads.size())) * sum;
}

/// Tries the full and half the way to the neighbours' mean; keeps a move that improves the worst corner around.
bool improve(PlaneMesh& mesh, const std::vector<std::uint32_t>& quads, std::uint32_t node)
{
    const Vec2 old = mesh.nodes[node];
    const Vec2 way = mean_of_neighbours(mesh, quads, node) - old;
    const double before = worst_around(mesh, quads);
    for (const double share : {1.0, 0.5, 0.2}) {
        mesh.nodes[node] = old + share * way;
        if (worst_around(mesh, quads) > before + 1e-6) {
            return true;
        }
    }
    mesh.nodes[node] = old;
    return false;
}

}  // namespace

double worst_corner(const PlaneMesh& mesh, std::size_t quad)
{
    double worst = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        worst = std::min(worst, corner_sine(mesh, mesh.quads[quad], i));
    }
    return worst;
}

void smooth(PlaneMesh& mesh)
{
    std::vector<char> fixed(mesh.nodes.size(), 0);
    for (const auto& edge : mesh.curve_edges) {
        fixed[edge.from] = fixed[edge.to] = 1;
    }
    std::vector<std::vector<std::uint32_t>> around(mesh.nodes.size());
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) {
        for (const std::uint32_t node : mesh.quads[q]) {
            around[node].push_back(q);
        }
    }
    bool moved = true;
    for (int sweep = 0; sweep < sweeps && moved; ++sweep) {
        moved = false;
        for (std::uint32_t node = 0; node < mesh.nodes.size(); ++node) {
            if (fixed[node] == 0 && !around[node].empty()) {
                moved = improve(mesh, around[node], node) || moved;
            }
        }
    }
}

}  // namespace deadpoint::machine
