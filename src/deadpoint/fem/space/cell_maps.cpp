#include "deadpoint/fem/space/cell_maps.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/round_edges.hpp"
#include "deadpoint/fem/space/unknowns.hpp"
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

using Point = dealii::Point<3>;
using Linear = dealii::GeometryInfo<3>;  // shape functions of first degree on the unit cube

// The sum of x_v times the slopes of its shape function.
void add_slope(dealii::Tensor<2, 3>& jacobian, const Point& x, const dealii::Tensor<1, 3>& slope)
{
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
            jacobian[i][j] += x[i] * slope[j];
}

}  // namespace

Point to_point(const Vec3& x) { return {x[0], x[1], x[2]}; }

dealii::hp::FECollection<3> lagrange_elements()
{
    return dealii::hp::FECollection<3>(dealii::FE_Q<3>(1), dealii::FE_SimplexP<3>(1), dealii::FE_Q<3>(2),
                                       dealii::FE_SimplexP<3>(2));
}

CellMaps::CellMaps(const Machine& machine, const std::vector<int>& orders, const dealii::hp::FECollection<3>& elements)
    : machine_(machine), orders_(orders), elements_(elements)
{
    if (machine.round_edges.empty())
        return;
    for (const auto& cell : machine.cells)
        round_.push_back(orders[cell.part] == 2 && deadpoint::is_round(machine, cell));
}

unsigned CellMaps::element_index(std::uint32_t cell) const
{
    return 2 * static_cast<unsigned>(orders_[machine_.cells[cell].part] - 1) + (is_hexahedron(cell) ? 0 : 1);
}

bool CellMaps::is_hexahedron(std::uint32_t cell) const { return machine_.cells[cell].kind == CellKind::hexahedron; }

Point CellMaps::corner(std::uint32_t cell, unsigned corner) const
{
    return to_point(machine_.nodes[node_at(machine_.cells[cell], corner)]);
}

Point CellMaps::position(std::uint32_t cell, const Point& unit) const
{
    if (is_round(cell))
        return to_point(place_in(machine_, machine_.cells[cell], {unit[0], unit[1], unit[2]}));
    if (!is_hexahedron(cell))
        return corner(cell, 0) + jacobian(cell, unit) * unit;
    Point sum;
    for (unsigned v = 0; v < Linear::vertices_per_cell; ++v)
        sum += Linear::d_linear_shape_function(unit, v) * corner(cell, v);
    return sum;
}

void CellMaps::corners(std::uint32_t cell, std::vector<Point>& corners) const
{
    corners.clear();
    if (is_round(cell))
        for (const auto& unit : elements_[element_index(cell)].get_unit_support_points())
            corners.push_back(position(cell, unit));
    else
        for (unsigned v = 0; v < corner_count(machine_.cells[cell]); ++v)
            corners.push_back(corner(cell, v));
}

dealii::Tensor<2, 3> CellMaps::jacobian(std::uint32_t cell, const Point& unit) const
{
    dealii::Tensor<2, 3> result;
    if (!is_round(cell))
        return straight_jacobian(cell, unit);
    const auto& element = elements_[element_index(cell)];
    std::vector<Point> places;
    corners(cell, places);
    for (unsigned v = 0; v < places.size(); ++v)
        add_slope(result, places[v], element.shape_grad(v, unit));
    return result;
}

dealii::Tensor<2, 3> CellMaps::straight_jacobian(std::uint32_t cell, const Point& unit) const
{
    dealii::Tensor<2, 3> result;
    if (is_hexahedron(cell)) {
        for (unsigned v = 0; v < Linear::vertices_per_cell; ++v)
            add_slope(result, corner(cell, v), Linear::d_linear_shape_function_gradient(unit, v));
    } else {
        const Point origin = corner(cell, 0);
        for (unsigned j = 0; j < 3; ++j) {
            const dealii::Tensor<1, 3> edge = corner(cell, j + 1) - origin;
            for (unsigned i = 0; i < 3; ++i)
                result[i][j] = edge[i];
        }
    }
    return result;
}

// Newton's method, with shorter steps where a whole one leads farther away. Its last step squares a small error.
bool CellMaps::unit_position(std::uint32_t cell, const Vec3& wanted, Point& unit) const
{
    constexpr int most_steps = 40, most_halvings = 8;
    constexpr double last_step = 1e-8;  // in reference coordinates
    const Point target = to_point(wanted);
    unit = is_hexahedron(cell) ? Point(0.5, 0.5, 0.5) : Point(0.25, 0.25, 0.25);
    dealii::Tensor<1, 3> miss = target - position(cell, unit);
    for (int k = 0; k < most_steps; ++k) {
        const auto slopes = jacobian(cell, unit);
        if (!(std::abs(dealii::determinant(slopes)) > 0))
            return false;
        dealii::Tensor<1, 3> step = dealii::invert(slopes) * miss;
        if (step.norm() < last_step) {
            unit += step;
            return true;
        }
        for (int half = 0;; ++half) {
            const auto left = target - position(cell, unit + step);
            if (left.norm() < miss.norm()) {
                unit += step;
                miss = left;
                break;
            }
            if (half == most_halvings)
                return false;
            step *= 0.5;
        }
    }
    return false;
}

Point CellMaps::nearest_inside(std::uint32_t cell, const Point& unit) const
{
    if (is_hexahedron(cell))
        return Linear::project_to_unit_cell(unit);
    Point inside;
    for (unsigned i = 0; i < 3; ++i)
        inside[i] = std::max(unit[i], 0.0);
    const double sum = inside[0] + inside[1] + inside[2];
    return sum > 1 ? Point(inside / sum) : inside;
}

Point CellMaps::centre(std::uint32_t cell) const
{
    const unsigned count = corner_count(machine_.cells[cell]);
    Point sum;
    for (unsigned v = 0; v < count; ++v)
        sum += corner(cell, v);
    return sum / count;
}

double CellMaps::diameter(std::uint32_t cell) const
{
    const unsigned count = corner_count(machine_.cells[cell]);
    double largest = 0;
    for (unsigned a = 0; a < count; ++a)
        for (unsigned b = a + 1; b < count; ++b)
            largest = std::max(largest, corner(cell, a).distance_square(corner(cell, b)));
    return std::sqrt(largest);
}

double CellMaps::volume(std::uint32_t cell) const
{
    if (!is_hexahedron(cell))
        return dealii::determinant(straight_jacobian(cell, {})) / 6;
    static const dealii::QGauss<3> rule(2);
    double sum = 0;
    for (unsigned q = 0; q < rule.size(); ++q)
        sum += rule.weight(q) * dealii::determinant(straight_jacobian(cell, rule.point(q)));
    return sum;
}

}  // namespace deadpoint::fem
