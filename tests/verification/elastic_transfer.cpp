#include "deadpoint/core/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/study/translate_heat.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <memory>

using namespace deadpoint;
using doctest::Approx;

namespace {

Observer silent;
constexpr double start = 293.15;

/// A case with a mesh of its own for the deformation, and beside it a model that has that mesh for everything.
struct TwoMeshes {
    Machine heat, deformed;
    std::unique_ptr<fem::Model> model, alone;

    TwoMeshes(const casefile::Case& input, double heat_size, double deformed_size)
        : heat(study::prepare_machine(input, heat_size, silent)),
          deformed(study::prepare_machine(input, deformed_size, silent))
    {
        const auto materials = study::describe_materials(input, heat);
        model = std::make_unique<fem::Model>(heat, materials, input.numerics.order, silent, &deformed);
        alone = std::make_unique<fem::Model>(deformed, materials, input.numerics.order, silent);
        model->support(-1);
        alone->support(-1);
    }
};

/// Integral of u . (A x) over the outside of a machine, a functional in which every part and direction counts.
Functional stretch(const Machine& machine)
{
    Functional result;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        for (const auto& point : face_points(machine, machine.faces[f])) {
            const auto& x = point.position;
            result.points.push_back({f, x, point.weight * Vec3{x[0] + 2 * x[1], 3 * x[1] - x[2], x[2] + 0.5 * x[0]}});
        }
    return result;
}

double linear(const Vec3& x) { return start + 7 + 40 * x[0] - 25 * x[1] + 60 * x[2]; }
double bending(const Vec3& x) { return start + 40 * x[0] / 0.1 * x[1] + 30 * std::sin(9 * x[2]); }

struct Meshes {
    const char* name;
    std::vector<std::string> overrides;
    double heat, deformed;
};

// Blocks whose meshes fit on no plane, a shaft in a bore whose facets leave nodes outside, tetrahedra, second order.
const std::vector<Meshes> all_meshes{
    {"bar", {}, 1, 1.7},
    {"bar", {}, 1.7, 1},
    {"bar", {"parts.upper.tetrahedra=true", "parts.lower.tetrahedra=true"}, 1.2, 1.9},
    {"bar", {"numerics.order=2"}, 1.3, 2},
    {"shaft-in-block", {}, 1, 1.6},
    {"shaft-in-block", {}, 1.6, 1},
};

}  // namespace

TEST_CASE("a linear temperature moves the machine as on one mesh, whatever the mesh it comes from")
{
    for (const auto& meshes : all_meshes) {
        CAPTURE(meshes.name);
        CAPTURE(meshes.deformed);
        TwoMeshes two(verification::read(meshes.name, meshes.overrides), meshes.heat, meshes.deformed);
        const auto wanted = stretch(two.deformed);
        const auto carried = two.model->adjoints({wanted}), own = two.alone->adjoints({wanted});
        // Shape functions hold linear fields exactly, also beside their cell: both sums are of the same values at the
        // same nodes, so that rounding and the factor are all there is between them.
        CHECK(two.model->apply(carried[0], two.model->interpolate_field(linear), start) ==
              Approx(two.alone->apply(own[0], two.alone->interpolate_field(linear), start)).epsilon(1e-10));
    }
}

TEST_CASE("adjoint and direct deformation agree through another mesh")
{
    for (const auto& meshes : all_meshes) {
        CAPTURE(meshes.name);
        CAPTURE(meshes.deformed);
        TwoMeshes two(verification::read(meshes.name, meshes.overrides), meshes.heat, meshes.deformed);
        const auto wanted = stretch(two.deformed);
        const auto field = two.model->interpolate_field(bending);
        const auto direct = two.model->evaluate({wanted}, two.model->displacement(field, start));
        // both are the same linear algebra, solved to 1e-10
        CHECK(two.model->apply(two.model->adjoints({wanted})[0], field, start) == Approx(direct[0]).epsilon(1e-9));
    }
}

TEST_CASE("even warmth moves every node of the heat's mesh by alpha dT x, though another mesh was solved")
{
    for (const auto& meshes : all_meshes) {
        CAPTURE(meshes.name);
        CAPTURE(meshes.deformed);
        TwoMeshes two(verification::read(meshes.name, meshes.overrides), meshes.heat, meshes.deformed);
        const auto u = two.model->displacement(two.model->constant_field(start + 50), start);
        const auto& machine = two.heat;
        std::vector<CellCorner> corners;
        std::vector<Vec3> positions;
        for (std::uint32_t c = machine.parts[0].first_cell; c < machine.parts[0].cell_count; ++c)
            for (std::uint32_t k = 0; k < (machine.parts[0].kind == CellKind::hexahedron ? 8 : 4); ++k) {
                corners.push_back({c, k});
                positions.push_back(machine.nodes[machine.cells[c].nodes[k]]);
            }
        const auto moved = two.model->at_corners(corners, u);
        const double strain = 50 * study::describe_materials(verification::read(meshes.name), machine)[0].expansion;
        double largest = 0;
        for (std::size_t i = 0; i < moved.size(); ++i)
            largest = std::max(largest, norm(moved[i] - moved[0] - strain * (positions[i] - positions[0])));
        CHECK(largest < 1e-8 * strain);  // of one metre: the factor's rounding
    }
}

TEST_CASE("two meshes of different parts are refused")
{
    const auto bar = verification::read("bar"), shaft = verification::read("shaft-in-block");
    const auto heat = study::prepare_machine(bar, 2, silent), other = study::prepare_machine(shaft, 2, silent);
    CHECK_THROWS_WITH_AS(fem::Model(heat, study::describe_materials(bar, heat), 1, silent, &other),
                         "two meshes of one machine have different parts; both must come from the same case",
                         InputError);
}
