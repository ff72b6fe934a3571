#pragma once

#include "deadpoint/core/vec.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

/// Structured meshes as Gmsh files, for sequences of meshes that are alike: each halves the one before exactly.
namespace verification {

struct Grid {
    std::array<int, 3> cells{1, 1, 1};
    /// From the unit cube to the body; must keep the sense of rotation.
    std::function<deadpoint::Vec3(double, double, double)> map;
    /// Each brick as six tetrahedra around one diagonal (Kuhn); bricks side by side match.
    bool tetrahedra = false;
    /// Names of the sides x = 0, x = 1, y = 0, ... of the unit cube; equal names make one surface, empty ones none.
    std::array<std::string, 6> sides{};
};

/// A box, as a map of the unit cube.
inline std::function<deadpoint::Vec3(double, double, double)> box_map(const deadpoint::Vec3& low,
                                                                      const deadpoint::Vec3& high)
{
    return [=](double u, double v, double w) {
        return deadpoint::Vec3{low[0] + u * (high[0] - low[0]), low[1] + v * (high[1] - low[1]),
                               low[2] + w * (high[2] - low[2])};
    };
}

namespace detail {

using Corner = std::array<int, 3>;

inline int node_of(const Grid& grid, const Corner& at)
{
    return 1 + at[0] + (grid.cells[0] + 1) * (at[1] + (grid.cells[1] + 1) * at[2]);
}

inline std::string element(int type, int group, const std::vector<int>& nodes)
{
    std::ostringstream text;
    text << ' ' << type << " 2 " << group << ' ' << group;
    for (const int node : nodes)
        text << ' ' << node;
    text << '\n';
    return text.str();
}

/// The six tetrahedra of a brick: one per order in which the three steps to the far corner are taken.
inline void add_tetrahedra(const Grid& grid, const Corner& low, int group, std::vector<std::string>& elements)
{
    std::array<int, 3> axes{0, 1, 2};
    do {
        std::vector<int> nodes{node_of(grid, low)};
        auto at = low;
        for (const int axis : axes) {
            ++at[static_cast<std::size_t>(axis)];
            nodes.push_back(node_of(grid, at));
        }
        const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
        if (!even)
            std::swap(nodes[1], nodes[2]);
        elements.push_back(element(4, group, nodes));
    } while (std::next_permutation(axes.begin(), axes.end()));
}

inline void add_side(const Grid& grid, std::size_t side, int group, std::vector<std::string>& elements)
{
    const std::size_t axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Corner low{};
    low[axis] = side % 2 == 1 ? grid.cells[axis] : 0;
    for (low[u] = 0; low[u] < grid.cells[u]; ++low[u])
        for (low[v] = 0; low[v] < grid.cells[v]; ++low[v]) {
            auto right = low, across = low, up = low;
            ++right[u], ++across[u], ++across[v], ++up[v];
            const std::array<int, 4> n{node_of(grid, low), node_of(grid, right), node_of(grid, across),
                                       node_of(grid, up)};
            if (grid.tetrahedra) {  // the diagonal through the low corner is Kuhn's
                elements.push_back(element(2, group, {n[0], n[1], n[2]}));
                elements.push_back(element(2, group, {n[0], n[2], n[3]}));
            } else {
                elements.push_back(element(3, group, {n[0], n[1], n[2], n[3]}));
            }
        }
}

}  // namespace detail

/// Writes the mesh as a Gmsh 2.2 file.
inline void write_grid(const std::filesystem::path& path, const Grid& grid)
{
    std::vector<std::string> names{"solid"};  // its group is 1
    std::vector<std::string> elements;
    for (std::size_t side = 0; side < 6; ++side) {
        const auto& name = grid.sides[side];
        if (name.empty())
            continue;
        if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
        const auto group = 1 + static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
        detail::add_side(grid, side, group, elements);
    }
    for (int k = 0; k < grid.cells[2]; ++k)
        for (int j = 0; j < grid.cells[1]; ++j)
            for (int i = 0; i < grid.cells[0]; ++i) {
                const auto n = [&](int a, int b, int c) { return detail::node_of(grid, {i + a, j + b, k + c}); };
                if (grid.tetrahedra)
                    detail::add_tetrahedra(grid, {i, j, k}, 1, elements);
                else
                    elements.push_back(detail::element(5, 1,
                                                       {n(0, 0, 0), n(1, 0, 0), n(1, 1, 0), n(0, 1, 0), n(0, 0, 1),
                                                        n(1, 0, 1), n(1, 1, 1), n(0, 1, 1)}));
            }

    std::ofstream out(path);
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << names.size() << "\n";
    for (std::size_t i = 0; i < names.size(); ++i)
        out << (i == 0 ? 3 : 2) << " " << i + 1 << " \"" << names[i] << "\"\n";
    out << "$EndPhysicalNames\n$Nodes\n" << (grid.cells[0] + 1) * (grid.cells[1] + 1) * (grid.cells[2] + 1) << "\n";
    int number = 0;
    for (int k = 0; k <= grid.cells[2]; ++k)
        for (int j = 0; j <= grid.cells[1]; ++j)
            for (int i = 0; i <= grid.cells[0]; ++i) {
                const auto x = grid.map(static_cast<double>(i) / grid.cells[0], static_cast<double>(j) / grid.cells[1],
                                        static_cast<double>(k) / grid.cells[2]);
                out << ++number << " " << x[0] << " " << x[1] << " " << x[2] << "\n";
            }
    out << "$EndNodes\n$Elements\n" << elements.size() << "\n";
    for (std::size_t i = 0; i < elements.size(); ++i)
        out << i + 1 << elements[i];
    out << "$EndElements\n";
}

}  // namespace verification
