#include "deadpoint/fem/reference/element.hpp"

#include "deadpoint/exchange/machine.hpp"

#include <array>

namespace deadpoint::fem {
namespace {

// The corners of the cube are numbered with x fastest; its edges and faces, and the edges of the tetrahedron, follow in
// the order of the unknowns (fem/space/unknowns).
const std::vector<Vec3> cube_nodes{
    {0, 0, 0},     {1, 0, 0},     {0, 1, 0},     {1, 1, 0},     {0, 0, 1},     {1, 0, 1},      {0, 1, 1},
    {1, 1, 1},     {0, 0.5, 0},   {1, 0.5, 0},   {0.5, 0, 0},   {0.5, 1, 0},   {0, 0.5, 1},    {1, 0.5, 1},
    {0.5, 0, 1},   {0.5, 1, 1},   {0, 0, 0.5},   {1, 0, 0.5},   {0, 1, 0.5},   {1, 1, 0.5},    {0, 0.5, 0.5},
    {1, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 1, 0.5}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {0.5, 0.5, 0.5}};
const std::vector<Vec3> tetrahedron_nodes{{0, 0, 0},     {1, 0, 0},   {0, 1, 0},   {0, 0, 1},     {0.5, 0, 0},
                                          {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
constexpr std::array<std::array<unsigned, 2>, 6> tetrahedron_edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<Vec3, 4> barycentric_slopes{{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

struct LineFunction {
    double value;
    double slope;
};

// Lagrange polynomial on the unit interval with nodes 0, 1 or 0, 1/2, 1.
LineFunction on_line(int degree, double node, double x)
{
    if (degree == 1)
        return node < 0.5 ? LineFunction{1 - x, -1} : LineFunction{x, 1};
    if (node == 0.5)
        return {4 * x * (1 - x), 4 - 8 * x};
    return node < 0.5 ? LineFunction{(1 - x) * (1 - 2 * x), 4 * x - 3} : LineFunction{x * (2 * x - 1), 4 * x - 1};
}

double barycentric(unsigned i, const Vec3& x) { return i == 0 ? 1 - x[0] - x[1] - x[2] : x[i - 1]; }

}  // namespace

ReferenceElement::ReferenceElement(CellKind kind, int degree) : cube_(kind == CellKind::hexahedron), degree_(degree)
{
    const auto& all = cube_ ? cube_nodes : tetrahedron_nodes;
    const std::ptrdiff_t corners = cube_ ? 8 : 4;
    nodes_.assign(all.begin(), degree == 1 ? all.begin() + corners : all.end());
}

double ReferenceElement::value(unsigned i, const Vec3& unit) const
{
    if (cube_) {
        double product = 1;
        for (std::size_t c = 0; c < 3; ++c)
            product *= on_line(degree_, nodes_[i][c], unit[c]).value;
        return product;
    }
    if (i >= 4)
        return 4 * barycentric(tetrahedron_edges[i - 4][0], unit) * barycentric(tetrahedron_edges[i - 4][1], unit);
    const double l = barycentric(i, unit);
    return degree_ == 1 ? l : l * (2 * l - 1);
}

Vec3 ReferenceElement::slope(unsigned i, const Vec3& unit) const
{
    if (cube_) {
        std::array<LineFunction, 3> f{};
        for (std::size_t c = 0; c < 3; ++c)
            f[c] = on_line(degree_, nodes_[i][c], unit[c]);
        return {f[0].slope * f[1].value * f[2].value, f[0].value * f[1].slope * f[2].value,
                f[0].value * f[1].value * f[2].slope};
    }
    if (i >= 4) {
        const auto [a, b] = tetrahedron_edges[i - 4];
        return 4 * barycentric(a, unit) * barycentric_slopes[b] + 4 * barycentric(b, unit) * barycentric_slopes[a];
    }
    return (degree_ == 1 ? 1 : 4 * barycentric(i, unit) - 1) * barycentric_slopes[i];
}

}  // namespace deadpoint::fem
