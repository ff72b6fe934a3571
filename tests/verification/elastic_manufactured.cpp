#include "../record.hpp"
#include "../scratch_folder.hpp"
#include "brick_elements.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "elastic_model.hpp"
#include "grid_mesh.hpp"
#include "near.hpp"

#include <cmath>
#include <numbers>

// Observed orders of the displacement against an exact solution without singularities.
//
// Goodier's potential, u = grad phi, is in equilibrium without body forces where alpha (T - T_0) = (1 - nu) / (1 + nu)
// div u. With phi = c X(x) Y(y) Z(z), whose factors and their slopes vanish at the outside, the box is clamped all
// around; X is even about the symmetry plane x = 0.
//
// The error is that in L2, |u_h - u| <= |u_h - I u| + |I u - u| with I u the exact values at the nodes. Between nodes
// the elements miss h^(p + 1) |D^(p + 1) u|, which nothing can avoid; at the nodes themselves even meshes do better for
// p = 2, h^4. Hence every cell is integrated. At one place of each brick, in one of its six tetrahedra, the first part
// may be small and of the sign of the second, and the sum seems to fall faster: from 4 x 8 x 8 to 12 x 24 x 24 bricks
// of tetrahedra of second order by 3.21, 3.22, 3.17 there, while it is 3.09, 3.09, 3.07 in L2, 2.95 to 2.99 of the
// first part and 3.5 to 3.8 of the second. Bricks are about cubes, since long ones enlarge the second part.

using namespace deadpoint;
using verification::Elastic;

namespace {

constexpr double start = 293.15, expansion = 2.3e-4, poisson = 0.3;
constexpr double depth = 0.1, height = 0.12, width = 0.09;  // of the half box: -depth < x < 0
constexpr double potential = 1e-7;                          // c [m2]

struct Bump {
    double value, slope, curvature;
};

/// (1 - s^2)^2 with s = -1 ... 1 over the length, and its derivatives.
Bump bump(double t, double length)
{
    const double k = 2 / length, s = k * t - 1;
    return {(1 - s * s) * (1 - s * s), -4 * k * s * (1 - s * s), k * k * (12 * s * s - 4)};
}

struct Factors {
    Bump x, y, z;
};
Factors factors(const Vec3& at) { return {bump(at[0] + depth, 2 * depth), bump(at[1], height), bump(at[2], width)}; }

Vec3 exact(const Vec3& at)
{
    const auto [x, y, z] = factors(at);
    return potential * Vec3{x.slope * y.value * z.value, x.value * y.slope * z.value, x.value * y.value * z.slope};
}

double warmth(const Vec3& at)
{
    const auto [x, y, z] = factors(at);
    const double divergence = potential * (x.curvature * y.value * z.value + x.value * y.curvature * z.value +
                                           x.value * y.value * z.curvature);
    return start + (1 - poisson) / (1 + poisson) * divergence / expansion;
}

using Counts = std::array<int, 3>;
using verification::BrickNodes;

/// The half box in one part, or divided at a height into two bonded ones.
struct Mesh {
    int order;
    bool tetrahedra;
    Counts lower;
    Counts upper{};  ///< of the part above `divide`; none: one part
};
constexpr double divide = 0.05;

Counts times(double factor, const Counts& cells)
{
    const auto scaled = [&](int count) { return static_cast<int>(std::lround(factor * count)); };
    return {scaled(cells[0]), scaled(cells[1]), scaled(cells[2])};
}

/// The nodes part by part.
std::vector<BrickNodes> nodes_of(const Mesh& mesh)
{
    const auto nodes = [&](const Counts& bricks, double from, double to) {
        return BrickNodes{mesh.order, bricks, {-depth, from, 0}, {0, to, width}};
    };
    if (mesh.upper[0] == 0)
        return {nodes(mesh.lower, 0, height)};
    return {nodes(mesh.lower, 0, divide), nodes(mesh.upper, divide, height)};
}

std::string write_part(const std::filesystem::path& file, const BrickNodes& part, bool tetrahedra, int cells)
{
    verification::Grid grid{times(cells, part.bricks),
                            verification::box_map(part.low, part.high),
                            tetrahedra,
                            {"feet", "", "feet", "feet", "feet", "feet"}};
    if (part.low[1] > 0)
        grid.sides[2] = "";
    if (part.high[1] < height)
        grid.sides[3] = "";
    verification::write_grid(file, grid);
    return file.string();
}

/// @param cells  along each edge of a brick
casefile::Case box(const std::filesystem::path& folder, const Mesh& mesh, bool tetrahedra, int cells)
{
    const auto parts = nodes_of(mesh);
    auto input = verification::read(
        "imported", {"parts.solid.mesh=" + write_part(folder / "solid.msh", parts[0], tetrahedra, cells),
                     "numerics.order=" + std::to_string(mesh.order)});
    if (parts.size() == 2) {
        input.parts["upper"] = input.parts["solid"];
        input.parts["upper"].mesh = write_part(folder / "upper.msh", parts[1], tetrahedra, cells);
    }
    return input;
}

/// The displacement at the nodes, part by part.
std::vector<std::vector<Vec3>> displacement_at_nodes(const Mesh& mesh)
{
    const ScratchFolder folder, sampled_folder;
    Elastic solved(box(folder.path, mesh, mesh.tetrahedra, 1));
    solved.model.support({press::surface_index(solved.machine, "feet"), Foundation::Kind::clamped});
    const auto displacement = solved.model.displacement(solved.model.interpolate_field(warmth), start);

    // Its nodes are the corners of hexahedra that divide each brick's edge by the order.
    const auto input = box(sampled_folder.path, mesh, false, mesh.order);
    Observer silent;
    const auto machine = full::prepare_machine(input, 1, silent);
    const auto nodes = nodes_of(mesh);
    const fem::Model samples(machine, press::describe_materials(input, machine), std::vector<int>(nodes.size(), 1),
                             silent, &solved.machine, std::vector<int>(nodes.size(), mesh.order));
    std::vector<std::vector<Vec3>> values;
    for (std::size_t part = 0; part < nodes.size(); ++part) {
        std::vector<CellCorner> corners(nodes[part].count(), {std::uint32_t(-1), 0});
        for (std::uint32_t cell = 0; cell < machine.cells.size(); ++cell)
            for (std::uint32_t corner = 0; corner < 8 && machine.cells[cell].part == part; ++corner)
                corners[nodes[part].nearest(machine.nodes[machine.cells[cell].nodes[corner]])] = {cell, corner};
        values.push_back(samples.at_corners(corners, displacement));
    }
    return values;
}

/// Root of the mean square error over the box [m].
double mean_error(const Mesh& mesh, const std::vector<std::vector<Vec3>>& values)
{
    const auto nodes = nodes_of(mesh);
    double sum = 0;
    for (std::size_t part = 0; part < nodes.size(); ++part)
        sum += verification::missed_square(nodes[part], mesh.tetrahedra, values[part], exact);
    return std::sqrt(sum / (depth * height * width));
}

double interpolation_error(const Mesh& mesh)
{
    std::vector<std::vector<Vec3>> values;
    for (const auto& part : nodes_of(mesh))
        values.push_back(verification::at_nodes(part, exact));
    return mean_error(mesh, values);
}

void check_order(const Mesh& coarse, const std::string& what)
{
    const Mesh fine{coarse.order, coarse.tetrahedra, times(1.5, coarse.lower), times(1.5, coarse.upper)};
    const auto order = [](double first, double second) { return std::log(first / second) / std::log(1.5); };
    const double first = mean_error(coarse, displacement_at_nodes(coarse));
    const double second = mean_error(fine, displacement_at_nodes(fine));
    const double first_between = interpolation_error(coarse), second_between = interpolation_error(fine);
    const std::string name = std::string(coarse.tetrahedra ? "tetrahedra" : "hexahedra") + " of order " +
                             std::to_string(coarse.order) + what;
    MESSAGE(name << ": errors " << first << ", " << second << " m, order " << order(first, second)
                 << "; of the exact values at the nodes " << first_between << ", " << second_between << " m, order "
                 << order(first_between, second_between));
    record_order({"order in space, displacement, " + name, "p + 1, manufactured solution", "", coarse.order + 1.0, 0.1,
                  "0.1 asked; error in L2, every cell integrated"},
                 "m", {{1.5, first}, {1, second}});
}

}  // namespace

TEST_CASE("what measures the error integrates a polynomial's as on paper")
{
    // x^(p + 1) less its values at even nodes: h^(p + 1) times s (s - 1) or s (s - 1/2) (s - 1), whose squares have the
    // integrals 1/30 and 1/840. In the tetrahedra too, since all their nodes lie at those s.
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            const BrickNodes nodes{order, {2, 3, 4}, {-1, 0, 2}, {0.5, 1, 3}};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto power = [&](const Vec3& x) { return Vec3{0, std::pow(x[axis], order + 1), 0}; };
                const double got = verification::missed_square(nodes, tetrahedra, at_nodes(nodes, power), power);
                const double edge = order * nodes.spacing(axis);
                const double wanted = 1.5 * std::pow(edge, 2 * order + 2) / (order == 1 ? 30 : 840);
                CHECK(got == near(wanted, 1e-10));  // rounding
            }
        }
}

TEST_CASE("order in space: the displacement of a box that is clamped all around")
{
    check_order({1, false, {10, 12, 10}}, "");
    check_order({1, true, {10, 12, 10}}, "");
    check_order({2, false, {4, 6, 4}}, "");
    check_order({2, true, {6, 8, 6}}, "");
}

TEST_CASE("order in space: the displacement of two bonded blocks whose meshes do not match")
{
    const std::string what = ", two blocks of meshes that do not match";
    check_order({1, false, {8, 4, 8}, {10, 8, 10}}, what);
    check_order({1, true, {12, 6, 12}, {14, 8, 14}}, what);
    check_order({2, false, {4, 2, 4}, {6, 4, 6}}, what);
    check_order({2, true, {6, 4, 6}, {8, 6, 8}}, what);
}
