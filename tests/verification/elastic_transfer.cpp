#include "deadpoint/drift/chain.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/press/problem/deformation_mesh.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <memory>

using namespace deadpoint;

namespace {

Observer silent;
constexpr double start = 293.15;

/// A case with a mesh of its own for the deformation, and beside it a model that has that mesh for everything.
struct TwoMeshes {
    Machine heat, deformed;
    std::unique_ptr<fem::Model> model, alone;

    TwoMeshes(const casefile::Case& input, double heat_size, double deformed_size)
        : heat(full::prepare_machine(input, heat_size, silent)),
          deformed(full::prepare_machine(input, deformed_size, silent))
    {
        const auto materials = press::describe_materials(input, heat);
        model = std::make_unique<fem::Model>(heat, materials, input.numerics.order, silent, &deformed);
        alone = std::make_unique<fem::Model>(deformed, materials, input.numerics.order, silent);
        model->support(-1);
        alone->support(-1);
    }
};

/// To a share of the value alone: displacements are small beside 1, which doctest would add to it.
Near relative(double value, double share) { return near(value, share); }

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
    {"shaft-in-block", {}, 0.4, 1.5},
    {"shaft-in-block", {}, 1.5, 0.4},
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
              relative(two.alone->apply(own[0], two.alone->interpolate_field(linear), start), 1e-10));
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
        CHECK(two.model->apply(two.model->adjoints({wanted})[0], field, start) == relative(direct[0], 1e-9));
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
        const double strain = 50 * press::describe_materials(verification::read(meshes.name), machine)[0].expansion;
        double largest = 0;
        for (std::size_t i = 0; i < moved.size(); ++i)
            largest = std::max(largest, norm(moved[i] - moved[0] - strain * (positions[i] - positions[0])));
        CHECK(largest < 1e-8 * strain);  // of one metre: the factor's rounding
    }
}

TEST_CASE("a free bar grows in volume by 3 alpha times the integral of its rise, kept by the fit to a finer mesh")
{
    // Goodier 1937: the mean stress of a body without loads vanishes, here exactly, as u = x is among the shape
    // functions.
    const auto input = verification::read("bar");
    TwoMeshes two(input, 0.7, 2.5);
    Functional volume;
    for (std::uint32_t f = 0; f < two.deformed.faces.size(); ++f) {
        const auto& face = two.deformed.faces[f];
        const auto& x = two.deformed.nodes;
        const Vec3 normal = cross(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]]);
        for (const auto& point : face_points(two.deformed, face))
            volume.points.push_back({f, point.position, point.weight / norm(normal) * normal});
    }
    // 100 K at the front, falling as the sixth power of the depth of 80 mm: its integral is a seventh of the block's
    const auto hot = [](const Vec3& x) { return start + 100 * std::pow(x[2] / 0.08, 6); };
    const double exact = 3 * 1.2e-5 * 100 * (0.1 * 1.04 * 0.08) / 7;
    const auto grown = [&](fem::Model& model) {
        return model.apply(model.adjoints({volume})[0], model.interpolate_field(hot), start);
    };
    const double fitted = grown(*two.model) / exact - 1, at_nodes = grown(*two.alone) / exact - 1;
    // Values at nodes overestimate a convex field by h^2 / 12 of its curvature, on the fine mesh as on the coarse one.
    CHECK(at_nodes > 0.3);
    CHECK(std::abs(fitted) < 0.25 * at_nodes);
}

TEST_CASE("the way to another mesh changes the gap of a press that is warm about its crank by less than 0.5 um")
{
    const auto input =
        casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/starter/case.toml").value;
    TwoMeshes two(input, 1.2, 2);
    const auto linkage = press::describe_linkage(input);
    const auto sensitivity = mechanism::bottom_dead_point(linkage);
    const auto chain = press::describe_chain(input, two.deformed, linkage);
    const auto gap = drift::chain_functionals(two.deformed, linkage, sensitivity, chain)[drift::gap];
    const auto value = [&](fem::Model& model) {
        model.support(press::surface_index(two.deformed, input.chain->ground_surface));
        const auto& crank = linkage.joints[static_cast<std::size_t>(chain.crank_joint)].centre;
        return model.apply(model.adjoints({gap})[0], model.interpolate_field([&](const Vec3& x) {
            const Vec2 arm{x[0] - crank[0], x[1] - crank[1]};
            return start + 30 * std::exp(-dot(arm, arm) / 0.16);
        }),
                           start);
    };
    const double carried = value(*two.model), alone = value(*two.alone);
    CHECK(std::abs(alone) > 10e-6);
    CHECK(std::abs(carried - alone) < 0.5e-6);
    CHECK(carried != alone);
}

TEST_CASE("two meshes of different parts are refused")
{
    const auto bar = verification::read("bar"), shaft = verification::read("shaft-in-block");
    const auto heat = full::prepare_machine(bar, 2, silent), other = full::prepare_machine(shaft, 2, silent);
    CHECK_THROWS_WITH_AS(fem::Model(heat, press::describe_materials(bar, heat), 1, silent, &other),
                         "two meshes of one machine have different parts; both must come from the same case",
                         InputError);
}

TEST_CASE("a deformation of second order beside a heat of first bends a bimetal strip by Timoshenko's curvature")
{
    const auto input = verification::read("bimetal", {"numerics.order=1", "numerics.deformation_order=2"});
    const auto machine = full::prepare_machine(input, 1, silent);
    const auto own = press::case_of_deformation(input);
    const auto deformed = full::prepare_machine(own, 1, silent);
    fem::Model model(machine, press::describe_materials(input, machine), press::describe_orders(input, machine), silent,
                     &deformed, press::describe_orders(own, deformed));
    model.support(-1);
    CHECK(model.size().deformation_unknowns > 6 * model.size().heat_unknowns);
    // mean turn of the ends, each its face's integral of y u_x over that of y^2
    const double second_moment = 2e-3 * std::pow(2e-3, 3) / 12;
    Functional bend{"bend", {}};
    for (const auto& [name, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}})
        for (const auto& entry :
             deformed.surfaces[static_cast<std::size_t>(press::surface_index(deformed, name))].faces)
            for (const auto& point : face_points(deformed, deformed.faces[entry.face]))
                bend.points.push_back({entry.face,
                                       point.position,
                                       {sign * point.weight * point.position[1] / second_moment / 0.04, 0, 0}});
    const auto warm = model.constant_field(start + 100);
    const auto curvature = model.evaluate({bend}, model.displacement(warm, start))[0];
    // pure bending lies in the space of second order; the fit of the temperatures keeps a constant to rounding
    CHECK(std::abs(curvature) == relative(0.75, 1e-7));
    CHECK(model.apply(model.adjoints({bend})[0], warm, start) == relative(curvature, 1e-9));
}
