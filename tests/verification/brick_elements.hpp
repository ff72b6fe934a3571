#pragma once

#include "deadpoint/core/vec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/// Shape functions on a brick of a Grid, written apart from the program's, to integrate what a solution misses.
namespace verification {

/// A place in the unit brick with its weight, and the shape functions there: one per node of the lattice of order + 1
/// nodes along each edge, the first axis running fastest.
struct BrickPoint {
    deadpoint::Vec3 at;
    double weight;
    std::vector<double> shape;
};

namespace detail {

struct LinePoint {
    double at, weight;
};

/// Gauss's rule of five points on 0..1, exact for degree 9.
inline std::array<LinePoint, 5> line_rule()
{
    const double root = 2 * std::sqrt(10.0 / 7), near = std::sqrt(5 - root) / 6, far = std::sqrt(5 + root) / 6;
    const double more = (322 + 13 * std::sqrt(70.0)) / 1800, less = (322 - 13 * std::sqrt(70.0)) / 1800;
    return {{{0.5 - far, less}, {0.5 - near, more}, {0.5, 64.0 / 225}, {0.5 + near, more}, {0.5 + far, less}}};
}

/// Polynomials on 0..1 that are 1 at one of order + 1 even places and 0 at the others.
inline std::vector<double> line_shape(int order, double at)
{
    std::vector<double> shape;
    for (int i = 0; i <= order; ++i) {
        double value = 1;
        for (int j = 0; j <= order; ++j)
            if (j != i)
                value *= (order * at - j) / (i - j);
        shape.push_back(value);
    }
    return shape;
}

inline BrickPoint in_hexahedron(int order, const deadpoint::Vec3& at, double weight)
{
    const auto x = line_shape(order, at[0]), y = line_shape(order, at[1]), z = line_shape(order, at[2]);
    BrickPoint point{at, weight, {}};
    for (const double c : z)
        for (const double b : y)
            for (const double a : x)
                point.shape.push_back(a * b * c);
    return point;
}

/// In the tetrahedron that steps to the far corner along the axes in this order, at a place 1 >= r >= s >= t >= 0 along
/// them.
inline BrickPoint in_tetrahedron(int order, const std::array<std::size_t, 3>& axes, const deadpoint::Vec3& along,
                                 double weight)
{
    const auto count = static_cast<std::size_t>(order) + 1;
    const std::array<std::size_t, 3> stride{1, count, count * count};
    std::array<std::size_t, 4> corner{};  // nodes, in steps of an edge
    const std::array<double, 4> share{1 - along[0], along[0] - along[1], along[1] - along[2], along[2]};
    BrickPoint point{{}, weight, std::vector<double>(count * count * count)};
    for (std::size_t i = 0; i < 3; ++i) {
        point.at[axes[i]] = along[i];
        corner[i + 1] = corner[i] + stride[axes[i]];
    }
    for (std::size_t i = 0; i < 4; ++i) {
        point.shape[corner[i] * (count - 1)] = order == 1 ? share[i] : share[i] * (2 * share[i] - 1);
        for (std::size_t j = 0; order == 2 && j < i; ++j)
            point.shape[corner[i] + corner[j]] = 4 * share[i] * share[j];
    }
    return point;
}

}  // namespace detail

/// A rule for integrals over the unit brick, exact for degree 9 along each axis in a hexahedron and for degree 7 in
/// each of the six tetrahedra (r, s, t as products: r^2 s is the volume).
/// @param order  of the elements, 1 or 2
inline std::vector<BrickPoint> brick_rule(int order, bool tetrahedra)
{
    std::vector<BrickPoint> points;
    const auto line = detail::line_rule();
    for (const auto& a : line)
        for (const auto& b : line)
            for (const auto& c : line) {
                const double weight = a.weight * b.weight * c.weight;
                if (!tetrahedra) {
                    points.push_back(detail::in_hexahedron(order, {a.at, b.at, c.at}, weight));
                    continue;
                }
                std::array<std::size_t, 3> axes{0, 1, 2};
                do
                    points.push_back(detail::in_tetrahedron(order, axes, {a.at, a.at * b.at, a.at * b.at * c.at},
                                                            weight * a.at * a.at * b.at));
                while (std::next_permutation(axes.begin(), axes.end()));
            }
    return points;
}

/// The nodes of a box of even bricks, the first axis running fastest.
struct BrickNodes {
    int order;  ///< of the elements, 1 or 2
    std::array<int, 3> bricks;
    deadpoint::Vec3 low, high;

    [[nodiscard]] int along(std::size_t axis) const { return order * bricks[axis] + 1; }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(along(0) * along(1) * along(2)); }
    [[nodiscard]] std::size_t index(const std::array<int, 3>& node) const
    {
        return static_cast<std::size_t>(node[0] + along(0) * (node[1] + along(1) * node[2]));
    }
    [[nodiscard]] double spacing(std::size_t axis) const { return (high[axis] - low[axis]) / (along(axis) - 1); }
    /// The node at a place.
    [[nodiscard]] std::size_t nearest(const deadpoint::Vec3& place) const
    {
        std::array<int, 3> node{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            node[axis] = static_cast<int>(std::lround((place[axis] - low[axis]) / spacing(axis)));
        return index(node);
    }
    [[nodiscard]] deadpoint::Vec3 place(const std::array<int, 3>& node) const
    {
        return {low[0] + node[0] * spacing(0), low[1] + node[1] * spacing(1), low[2] + node[2] * spacing(2)};
    }
};

/// Calls visit for each triple below these counts, the first running fastest.
template <class Visitor>
void for_each_triple(const std::array<int, 3>& counts, const Visitor& visit)
{
    for (int k = 0; k < counts[2]; ++k)
        for (int j = 0; j < counts[1]; ++j)
            for (int i = 0; i < counts[0]; ++i)
                visit(std::array<int, 3>{i, j, k});
}

using VectorField = std::function<deadpoint::Vec3(const deadpoint::Vec3&)>;

/// The integral of |u_h - u|^2 over the box, where u_h has these values at the nodes.
inline double missed_square(const BrickNodes& nodes, bool tetrahedra, const std::vector<deadpoint::Vec3>& values,
                            const VectorField& field)
{
    using namespace deadpoint;
    const auto rule = brick_rule(nodes.order, tetrahedra);
    const double p = nodes.order;
    const Vec3 edge{p * nodes.spacing(0), p * nodes.spacing(1), p * nodes.spacing(2)};
    double sum = 0;
    std::vector<deadpoint::Vec3> of_brick;
    for_each_triple(nodes.bricks, [&](const std::array<int, 3>& brick) {
        const std::array<int, 3> first{nodes.order * brick[0], nodes.order * brick[1], nodes.order * brick[2]};
        of_brick.clear();
        for_each_triple({nodes.order + 1, nodes.order + 1, nodes.order + 1}, [&](const std::array<int, 3>& step) {
            of_brick.push_back(values[nodes.index({first[0] + step[0], first[1] + step[1], first[2] + step[2]})]);
        });
        const auto low = nodes.place(first);
        for (const auto& point : rule) {
            const auto& at = point.at;
            auto error = -1.0 * field(low + Vec3{at[0] * edge[0], at[1] * edge[1], at[2] * edge[2]});
            for (std::size_t i = 0; i < of_brick.size(); ++i)
                error = error + point.shape[i] * of_brick[i];
            sum += point.weight * edge[0] * edge[1] * edge[2] * dot(error, error);
        }
    });
    return sum;
}

/// A field's values at the nodes.
inline std::vector<deadpoint::Vec3> at_nodes(const BrickNodes& nodes, const VectorField& field)
{
    std::vector<deadpoint::Vec3> values;
    for_each_triple({nodes.along(0), nodes.along(1), nodes.along(2)},
                    [&](const std::array<int, 3>& node) { values.push_back(field(nodes.place(node))); });
    return values;
}

}  // namespace verification
