#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// Machines of a few bricks, made without a mesher: meshes whose integrals are known on paper.
namespace bricks {

using deadpoint::cross;
using deadpoint::dot;
using deadpoint::norm;
using deadpoint::operator+;
using deadpoint::operator-;
using deadpoint::operator*;
using deadpoint::Cell;
using deadpoint::CellKind;
using deadpoint::Contact;
using deadpoint::Face;
using deadpoint::Machine;
using deadpoint::Material;
using deadpoint::Vec3;
using deadpoint::fem::Discretisation;
using deadpoint::fem::OwnedVec;
using Scalar = std::function<double(const Vec3&)>;

/// A part: a box of even cells.
struct Brick {
    Vec3 low{0, 0, 0}, high{1, 1, 1};
    std::array<int, 3> cells{1, 1, 1};
    bool tetrahedra = false;        ///< each cell as six around one diagonal
    std::function<Vec3(Vec3)> map;  ///< moves the nodes; empty: none
};

namespace detail {

inline void add_cells(Machine& machine, const Brick& brick, std::uint32_t part, std::uint32_t first_node)
{
    const auto [nx, ny, nz] = brick.cells;
    const auto node = [&](int i, int j, int k) {
        return first_node + static_cast<std::uint32_t>(i + (nx + 1) * (j + (ny + 1) * k));
    };
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                if (!brick.tetrahedra) {
                    machine.cells.push_back(
                        {CellKind::hexahedron,
                         part,
                         {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
                          node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)}});
                    continue;
                }
                std::array<std::size_t, 3> axes{0, 1, 2};
                do {
                    std::array<int, 3> at{i, j, k};
                    std::array<std::uint32_t, 8> nodes{node(i, j, k)};
                    for (std::size_t step = 0; step < 3; ++step) {
                        ++at[axes[step]];
                        nodes[step + 1] = node(at[0], at[1], at[2]);
                    }
                    if ((axes[1] + 3 - axes[0]) % 3 != 1)  // an odd order turns the tetrahedron inside out
                        std::swap(nodes[1], nodes[2]);
                    machine.cells.push_back({CellKind::tetrahedron, part, nodes});
                } while (std::next_permutation(axes.begin(), axes.end()));
            }
}

inline void add_nodes(Machine& machine, const Brick& brick)
{
    const auto [nx, ny, nz] = brick.cells;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) {
                const Vec3 share{1.0 * i / nx, 1.0 * j / ny, 1.0 * k / nz};
                Vec3 x{};
                for (std::size_t c = 0; c < 3; ++c)
                    x[c] = brick.low[c] + share[c] * (brick.high[c] - brick.low[c]);
                machine.nodes.push_back(brick.map ? brick.map(x) : x);
            }
}

inline Vec3 normal_of(const Machine& machine, const Face& face)
{
    const auto& x = machine.nodes;
    return deadpoint::normalised(cross(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]]));
}

inline std::uint32_t geometry_of(Machine& machine, const Face& face)
{
    const Vec3 normal = normal_of(machine, face);
    const double offset = dot(normal, machine.nodes[face.nodes[0]]);
    for (std::uint32_t g = 0; g < machine.geometries.size(); ++g) {
        const auto& plane = std::get<deadpoint::PlaneGeometry>(machine.geometries[g]);
        if (norm(plane.normal - normal) < 1e-9 && std::abs(plane.offset - offset) < 1e-9)
            return g;
    }
    machine.geometries.emplace_back(deadpoint::PlaneGeometry{normal, offset});
    return static_cast<std::uint32_t>(machine.geometries.size() - 1);
}

/// Faces of cells that no other cell has.
inline void add_faces(Machine& machine)
{
    const std::vector<std::vector<std::size_t>> of_hexahedron{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const std::vector<std::vector<std::size_t>> of_tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    std::map<std::vector<std::uint32_t>, std::pair<int, Face>> found;
    for (std::uint32_t c = 0; c < machine.cells.size(); ++c) {
        const auto& cell = machine.cells[c];
        for (const auto& local : cell.kind == CellKind::hexahedron ? of_hexahedron : of_tetrahedron) {
            Face face;
            face.cell = c;
            face.part = cell.part;
            face.node_count = static_cast<std::uint8_t>(local.size());
            std::vector<std::uint32_t> key;
            for (std::size_t i = 0; i < local.size(); ++i)
                key.push_back(face.nodes[i] = cell.nodes[local[i]]);
            std::ranges::sort(key);
            auto& entry = found[key];
            ++entry.first;
            entry.second = face;
        }
    }
    for (auto& [key, entry] : found)
        if (entry.first == 1) {
            entry.second.geometry = geometry_of(machine, entry.second);
            machine.faces.push_back(entry.second);
        }
}

/// Smallest and largest coordinates of a face.
inline std::pair<Vec3, Vec3> box_of(const Machine& machine, const Face& face)
{
    Vec3 low = machine.nodes[face.nodes[0]], high = low;
    for (std::size_t i = 1; i < face.node_count; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], machine.nodes[face.nodes[i]][c]);
            high[c] = std::max(high[c], machine.nodes[face.nodes[i]][c]);
        }
    return {low, high};
}

}  // namespace detail

inline Machine machine_of(const std::vector<Brick>& all)
{
    Machine machine;
    for (std::uint32_t p = 0; p < all.size(); ++p) {
        const auto& brick = all[p];
        deadpoint::MeshPart part;
        part.name = "part " + std::to_string(p);
        part.body = "body " + std::to_string(p);
        part.first_cell = static_cast<std::uint32_t>(machine.cells.size());
        part.kind = brick.tetrahedra ? CellKind::tetrahedron : CellKind::hexahedron;
        const auto first_node = static_cast<std::uint32_t>(machine.nodes.size());
        detail::add_nodes(machine, brick);
        detail::add_cells(machine, brick, p, first_node);
        part.cell_count = static_cast<std::uint32_t>(machine.cells.size()) - part.first_cell;
        const Vec3 size = brick.high - brick.low;
        part.volume = size[0] * size[1] * size[2];
        machine.parts.push_back(part);
    }
    detail::add_faces(machine);
    machine.exposed_fraction.assign(machine.faces.size(), 1.0);
    return machine;
}

/// Faces of a part that look along an axis, up or down.
inline std::vector<std::uint32_t> side(const Machine& machine, std::uint32_t part, std::size_t axis, bool up)
{
    std::vector<std::uint32_t> result;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        if (machine.faces[f].part == part &&
            (up ? 1 : -1) * detail::normal_of(machine, machine.faces[f])[axis] > 1 - 1e-9)
            result.push_back(f);
    return result;
}

/// Adds a side as a surface; returns its index.
inline int add_surface(Machine& machine, std::uint32_t part, std::size_t axis, bool up, double fraction = 1)
{
    deadpoint::MeshSurface surface;
    surface.name = "surface " + std::to_string(machine.surfaces.size());
    for (const auto face : side(machine, part, axis, up))
        surface.faces.push_back({face, fraction, true});
    machine.surfaces.push_back(surface);
    return static_cast<int>(machine.surfaces.size() - 1);
}

/// The contact of part a's upper side along an axis with part b's lower one, whose meshes need not match: Gauss's nine
/// points on what each pair of faces shares.
inline Contact contact(const Machine& machine, std::uint32_t a, std::uint32_t b, std::size_t axis)
{
    const std::array<double, 3> at{-std::sqrt(0.6), 0, std::sqrt(0.6)}, weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Contact result;
    result.name = "part " + std::to_string(a) + "|part " + std::to_string(b);
    result.part_a = a;
    result.part_b = b;
    Vec3 normal{};
    normal[axis] = 1;
    for (const auto face_a : side(machine, a, axis, true))
        for (const auto face_b : side(machine, b, axis, false)) {
            const auto [low_a, high_a] = detail::box_of(machine, machine.faces[face_a]);
            const auto [low_b, high_b] = detail::box_of(machine, machine.faces[face_b]);
            const double from_u = std::max(low_a[u], low_b[u]), to_u = std::min(high_a[u], high_b[u]);
            const double from_v = std::max(low_a[v], low_b[v]), to_v = std::min(high_a[v], high_b[v]);
            if (to_u - from_u < 1e-9 || to_v - from_v < 1e-9)
                continue;
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j) {
                    Vec3 x{};
                    x[axis] = low_a[axis];
                    x[u] = 0.5 * (from_u + to_u + at[i] * (to_u - from_u));
                    x[v] = 0.5 * (from_v + to_v + at[j] * (to_v - from_v));
                    const double area = weight[i] * weight[j] * (to_u - from_u) * (to_v - from_v);
                    result.points.push_back({face_a, face_b, x, x, normal, area});
                    result.area += area;
                }
        }
    result.geometry =
        deadpoint::PlaneGeometry{normal, machine.nodes[machine.faces[side(machine, a, axis, true)[0]].nodes[0]][axis]};
    result.drawn_area = result.least_area = result.area_a = result.area_b = result.area;
    return result;
}

/// One part's space.
struct Space {
    Space(Machine machine_, std::vector<int> orders) : machine(std::move(machine_)), space(machine, std::move(orders))
    {}
    explicit Space(const Brick& brick, int order = 1) : Space(machine_of({brick}), {order}) {}
    Space(const Space&) = delete;
    Machine machine;
    Discretisation space;
};

inline Material steel()
{
    Material material;
    material.density = 7800;
    material.conductivity = 45;
    material.specific_heat = 500;
    material.expansion = 1.2e-5;
    material.youngs_modulus = 2.1e11;
    material.poissons_ratio = 0.3;
    return material;
}

/// A field by its values at the unknowns.
inline std::vector<double> values_of(const Discretisation& space, const Scalar& field)
{
    std::vector<double> result;
    for (const auto& x : space.support_points())
        result.push_back(field(x));
    return result;
}

inline OwnedVec vector_of(const Discretisation& space, const std::vector<double>& values, int block = 1)
{
    auto vector = deadpoint::fem::create_vector(space, block);
    std::ranges::copy(values, deadpoint::fem::Entries(vector).data());
    return vector;
}
inline OwnedVec vector_of(const Discretisation& space, const Scalar& field)
{
    return vector_of(space, values_of(space, field));
}

inline Eigen::VectorXd dense(Vec vector)
{
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(vector, &count));
    const deadpoint::fem::ConstEntries values(vector);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), count);
}

inline Eigen::MatrixXd dense(Mat matrix)
{
    PetscInt rows = 0, columns = 0;
    DEADPOINT_PETSC(MatGetSize(matrix, &rows, &columns));
    Eigen::MatrixXd result(rows, columns);
    for (PetscInt i = 0; i < rows; ++i)
        for (PetscInt j = 0; j < columns; ++j)
            DEADPOINT_PETSC(MatGetValues(matrix, 1, &i, 1, &j, &result(i, j)));
    return result;
}

inline Eigen::VectorXd column(const std::vector<double>& values)
{
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}
inline Eigen::VectorXd column(const Discretisation& space, const Scalar& field)
{
    return column(values_of(space, field));
}

}  // namespace bricks
