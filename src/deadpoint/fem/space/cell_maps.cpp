#include "deadpoint/fem/space/cell_maps.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/round_edges.hpp"
#include "deadpoint/fem/reference/quadrature.hpp"
#include "deadpoint/fem/space/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace deadpoint::fem {
std::vector<ReferenceElement> lagrange_elements()
{
    return {
        {CellKind::hexahedron, 1}, {CellKind::tetrahedron, 1}, {CellKind::hexahedron, 2}, {CellKind::tetrahedron, 2}};
}

CellMaps::CellMaps(const Machine& machine, const std::vector<int>& orders,
                   const std::vector<ReferenceElement>& elements)
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

Vec3 CellMaps::corner(std::uint32_t cell, unsigned corner) const
{
    return machine_.nodes[node_at(machine_.cells[cell], corner)];
}

Vec3 CellMaps::position(std::uint32_t cell, const Vec3& unit) const
{
    if (is_round(cell))
        return place_in(machine_, machine_.cells[cell], unit);
    const auto& functions = of_first_degree(cell);
    Vec3 sum{};
    for (unsigned v = 0; v < functions.size(); ++v)
        sum = sum + functions.value(v, unit) * corner(cell, v);
    return sum;
}

void CellMaps::corners(std::uint32_t cell, std::vector<Vec3>& corners) const
{
    corners.clear();
    if (is_round(cell))
        for (const auto& unit : elements_[element_index(cell)].nodes())
            corners.push_back(position(cell, unit));
    else
        for (unsigned v = 0; v < corner_count(machine_.cells[cell]); ++v)
            corners.push_back(corner(cell, v));
}

Matrix3 CellMaps::jacobian(std::uint32_t cell, const Vec3& unit) const
{
    if (!is_round(cell))
        return straight_jacobian(cell, unit);
    const auto& element = elements_[element_index(cell)];
    std::vector<Vec3> places;
    corners(cell, places);
    Matrix3 result{};
    for (unsigned v = 0; v < places.size(); ++v)
        add_outer(result, places[v], element.slope(v, unit));
    return result;
}

Matrix3 CellMaps::straight_jacobian(std::uint32_t cell, const Vec3& unit) const
{
    const auto& functions = of_first_degree(cell);
    Matrix3 result{};
    for (unsigned v = 0; v < functions.size(); ++v)
        add_outer(result, corner(cell, v), functions.slope(v, unit));
    return result;
}

// Newton's method, with shorter steps where a whole one leads farther away. Its last step squares a small error.
bool CellMaps::unit_position(std::uint32_t cell, const Vec3& target, Vec3& unit) const
{
    constexpr int most_steps = 40, most_halvings = 8;
    constexpr double last_step = 1e-8;  // in reference coordinates
    unit = is_hexahedron(cell) ? Vec3{0.5, 0.5, 0.5} : Vec3{0.25, 0.25, 0.25};
    Vec3 miss = target - position(cell, unit);
    for (int k = 0; k < most_steps; ++k) {
        const auto slopes = jacobian(cell, unit);
        if (!(std::abs(determinant(slopes)) > 0))
            return false;
        Vec3 step = times_transposed(inverse_transposed(slopes), miss);
        if (norm(step) < last_step) {
            unit = unit + step;
            return true;
        }
        for (int half = 0;; ++half) {
            const auto left = target - position(cell, unit + step);
            if (norm(left) < norm(miss)) {
                unit = unit + step;
                miss = left;
                break;
            }
            if (half == most_halvings)
                return false;
            step = 0.5 * step;
        }
    }
    return false;
}

Vec3 CellMaps::nearest_inside(std::uint32_t cell, const Vec3& unit) const
{
    const double most = is_hexahedron(cell) ? 1.0 : std::numeric_limits<double>::infinity();
    Vec3 inside{};
    for (unsigned i = 0; i < 3; ++i)
        inside[i] = std::clamp(unit[i], 0.0, most);
    const double sum = inside[0] + inside[1] + inside[2];
    return is_hexahedron(cell) || sum <= 1 ? inside : (1 / sum) * inside;
}

Vec3 CellMaps::centre(std::uint32_t cell) const
{
    const unsigned count = corner_count(machine_.cells[cell]);
    Vec3 sum{};
    for (unsigned v = 0; v < count; ++v)
        sum = sum + corner(cell, v);
    return (1.0 / count) * sum;
}

double CellMaps::diameter(std::uint32_t cell) const
{
    const unsigned count = corner_count(machine_.cells[cell]);
    double largest = 0;
    for (unsigned a = 0; a < count; ++a)
        for (unsigned b = a + 1; b < count; ++b)
            largest = std::max(largest, norm(corner(cell, a) - corner(cell, b)));
    return largest;
}

double CellMaps::volume(std::uint32_t cell) const
{
    if (!is_hexahedron(cell))
        return determinant(straight_jacobian(cell, {})) / 6;
    static const Quadrature rule = gauss_on_cube(2);
    double sum = 0;
    for (unsigned q = 0; q < rule.size(); ++q)
        sum += rule.weights[q] * determinant(straight_jacobian(cell, rule.points[q]));
    return sum;
}

}  // namespace deadpoint::fem
