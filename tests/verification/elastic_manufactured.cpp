#include "../record.hpp"
#include "../scratch_folder.hpp"
#include "elastic_model.hpp"
#include "grid_mesh.hpp"

#include <cmath>
#include <numbers>

// Observed orders of the displacement against an exact solution without singularities.
//
// Goodier's potential, u = grad phi, is in equilibrium without body forces where alpha (T - T_0) = (1 - nu) / (1 + nu)
// div u. With phi = c X(x) Y(y) Z(z), whose factors and their slopes vanish at the outside, the box is clamped all
// around; X is even about the symmetry plane x = 0.

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

/// The half box in one part, or divided at a height into two bonded ones.
struct Mesh {
    int order;
    bool tetrahedra;
    Counts lower;
    Counts upper{};  ///< of the part above `divide`; none: one part
};
constexpr double divide = 0.05;

/// Places 0..1 of the nodes of a mesh that samples another of one cell less: one in each of its cells, at the same
/// place there, and both ends.
double within_cells(double evenly, int count, double inside)
{
    const double i = std::round(evenly * count);
    return i == 0 || i == count ? evenly : (i - 1 + inside) / (count - 1);
}
Counts one_more(const Counts& cells) { return {cells[0] + 1, cells[1] + 1, cells[2] + 1}; }

casefile::Case box(const std::filesystem::path& folder, const Mesh& mesh, bool sampling = false)
{
    const bool two = mesh.upper[0] > 0;
    const auto write = [&](const std::string& name, const Counts& cells, double from, double to) {
        const auto place = verification::box_map({-depth, from, 0}, {0, to, width});
        verification::Grid grid{cells, place, mesh.tetrahedra, {}};
        if (sampling)
            grid.map = [=](double u, double v, double w) {
                return place(within_cells(u, cells[0], 0.29), within_cells(v, cells[1], 0.38),
                             within_cells(w, cells[2], 0.71));
            };
        grid.sides = {"feet", "", "feet", "feet", "feet", "feet"};
        if (two)
            grid.sides[from > 0 ? 2 : 3] = "";
        const auto file = folder / (name + ".msh");
        verification::write_grid(file, grid);
        return file.string();
    };
    auto input =
        verification::read("imported", {"parts.solid.mesh=" + write("solid", mesh.lower, 0, two ? divide : height),
                                        "numerics.order=" + std::to_string(mesh.order)});
    if (two) {
        input.parts["upper"] = input.parts["solid"];
        input.parts["upper"].mesh = write("upper", mesh.upper, divide, height);
    }
    return input;
}

/// Root mean square error of the displacement over a point in each cell, always at the same place in it [m].
double displacement_error(const Mesh& mesh)
{
    const ScratchFolder folder, sampled_folder;
    Elastic solved(box(folder.path, mesh));
    solved.model.support({study::surface_index(solved.machine, "feet"), Foundation::Kind::clamped});
    const auto displacement = solved.model.displacement(solved.model.interpolate_field(warmth), start);

    const bool two = mesh.upper[0] > 0;
    const auto input = box(sampled_folder.path,
                           {mesh.order, false, one_more(mesh.lower), two ? one_more(mesh.upper) : Counts{}}, true);
    Observer silent;
    const auto machine = study::prepare_machine(input, 1, silent);
    const fem::Model samples(machine, study::describe_materials(input, machine), mesh.order, silent, &solved.machine);
    std::vector<CellCorner> corners;
    for (std::uint32_t c = 0; c < machine.cells.size(); ++c) {
        const auto& x = machine.nodes[machine.cells[c].nodes[6]];
        const bool inside = x[0] < -1e-9 && x[1] < height - 1e-9 && x[2] < width - 1e-9;
        if (inside && (!two || std::abs(x[1] - divide) > 1e-9))
            corners.push_back({c, 6});
    }
    const auto u = samples.at_corners(corners, displacement);
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const Vec3 error = u[i] - exact(machine.nodes[machine.cells[corners[i].cell].nodes[6]]);
        sum += dot(error, error);
    }
    return std::sqrt(sum / static_cast<double>(u.size()));
}

Counts finer(const Counts& cells) { return {3 * cells[0] / 2, 3 * cells[1] / 2, 3 * cells[2] / 2}; }

void check_order(const Mesh& coarse, const std::string& what)
{
    const double first = displacement_error(coarse);
    const double second =
        displacement_error({coarse.order, coarse.tetrahedra, finer(coarse.lower), finer(coarse.upper)});
    const double order = std::log(first / second) / std::log(1.5);
    const std::string name = std::string(coarse.tetrahedra ? "tetrahedra" : "hexahedra") + " of order " +
                             std::to_string(coarse.order) + what;
    MESSAGE(name << ": errors " << first << ", " << second << " m, order " << order);
    const bool above = coarse.tetrahedra && coarse.order == 2;
    record({"order in space, displacement, " + name, "p + 1, manufactured solution", "", coarse.order + 1.0,
            above ? 0.3 : 0.1,
            above ? "0.1 asked and not seen on these meshes: falls faster than it should" : "0.1 asked"},
           order);
}

}  // namespace

TEST_CASE("order in space: the displacement of a box that is clamped all around")
{
    check_order({1, false, {8, 16, 16}}, "");
    check_order({1, true, {10, 20, 20}}, "");
    check_order({2, false, {4, 8, 8}}, "");
    check_order({2, true, {4, 8, 8}}, "");
}

TEST_CASE("order in space: the displacement of two bonded blocks whose meshes do not match")
{
    const std::string what = ", two blocks of meshes that do not match";
    check_order({1, false, {8, 6, 16}, {10, 10, 18}}, what);
    check_order({1, true, {8, 6, 16}, {10, 10, 18}}, what);
    check_order({2, false, {4, 4, 8}, {6, 6, 10}}, what);
    check_order({2, true, {4, 4, 8}, {6, 6, 10}}, what);
}
