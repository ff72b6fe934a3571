#include "deadpoint/machine/assembly/limits.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <cmath>
#include <set>

using namespace machine_test;

namespace {

double faces_area(const Machine& machine, bool symmetry)
{
    double sum = 0;
    for (const Face& face : machine.faces) {
        if (face.symmetry == symmetry) {
            sum += machine::area(face, machine.nodes);
        }
    }
    return sum;
}

/// Largest distance of the nodes of cylindrical faces from their true cylinder.
double worst_radius_error(const Machine& machine)
{
    double worst = 0;
    for (const Face& face : machine.faces) {
        const auto* geometry = std::get_if<CylinderGeometry>(&machine.geometries[face.geometry]);
        if (geometry == nullptr) {
            continue;
        }
        for (int i = 0; i < face.node_count; ++i) {
            const Vec3 arm = machine.nodes[face.nodes[i]] - geometry->point;
            const double distance = norm(arm - dot(arm, geometry->axis) * geometry->axis);
            worst = std::max(worst, std::abs(distance - geometry->radius));
        }
    }
    return worst;
}

/// The closed surface of a part has no resultant area vector; holes or wrongly turned faces would leave one.
double closure_error(const Machine& machine)
{
    Vec3 sum{};
    for (const Face& face : machine.faces) {
        sum = sum + machine::area_vector(face, machine.nodes);
    }
    return norm(sum);
}

/// Volume by the divergence theorem over the exterior faces: positive only if they point outwards.
double volume_from_faces(const Machine& machine)
{
    double sum = 0;
    for (const Face& face : machine.faces) {
        const auto& n = face.nodes;
        const auto wedge = [&](int i, int j, int k) {
            return dot(machine.nodes[n[i]], cross(machine.nodes[n[j]], machine.nodes[n[k]])) / 6;
        };
        sum += wedge(0, 1, 2) + (face.node_count == 4 ? wedge(0, 2, 3) : 0.0);
    }
    return sum;
}

MachineDescription single(std::vector<Shape> shapes, double size)
{
    MachineDescription description;
    description.parts = {part("p", "b", std::move(shapes), size)};
    return description;
}

}  // namespace

TEST_CASE("a box becomes a regular grid with the exact volume")
{
    const Machine machine = build(single({add(BoxShape{{0, 0, 0}, {0.3, 0.1, 0.05}})}, 0.025));
    REQUIRE(machine.parts.size() == 1);
    CHECK(machine.parts[0].cell_count == 12 * 4 * 2);
    CHECK(machine.nodes.size() == 13 * 5 * 3);
    CHECK(machine.parts[0].volume == near(0.3 * 0.1 * 0.05, 1e-13));  // rounding only
    CHECK(machine.parts[0].mass == near(1.5, 1e-13));
    CHECK(machine.parts[0].min_quality == near(1, 1e-12));
    CHECK(machine.parts[0].exterior_area == near(2 * (0.03 + 0.015 + 0.005), 1e-13));
    CHECK(machine.geometries.size() == 6);
}

TEST_CASE("a cylinder loses what its inscribed polygon loses, on every axis")
{
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        CAPTURE(static_cast<int>(axis));
        const Machine machine = build(single({add(cylinder(axis, {0.2, -0.1}, 0.1, -0.03, 0.07))}, 0.05));
        const double exact = std::numbers::pi * 0.05 * 0.05 * 0.1;
        CHECK(machine.parts[0].kind == CellKind::hexahedron);
        CHECK(machine.parts[0].volume <= exact * (1 + 1e-12));
        CHECK(machine.parts[0].volume >= exact * polygon_share(24) * (1 - 1e-9));  // at least 24 segments
        CHECK(worst_radius_error(machine) < 1e-12);
        CHECK(closure_error(machine) < 1e-14);
        CHECK(volume_from_faces(machine) == near(machine.parts[0].volume, 1e-9));
        CHECK(machine.parts[0].min_quality > 0.4);
    }
}

TEST_CASE("a plate with a hole and an outline with a hole")
{
    const Shape plate = add(BoxShape{{-0.3, -0.2, 0}, {0.3, 0.2, 0.04}});
    const Shape hole = cut(cylinder(Axis::z, {0.1, 0.02}, 0.12, 0, 0.04));
    const Machine machine = build(single({plate, hole}, 0.03));
    const double disc = std::numbers::pi * 0.06 * 0.06;
    CHECK(machine.parts[0].volume >= (0.24 - disc) * 0.04);
    CHECK(machine.parts[0].volume <= (0.24 - disc * polygon_share(24)) * 0.04 * (1 + 1e-9));
    CHECK(machine.parts[0].min_quality > 0.4);
    CHECK(closure_error(machine) < 1e-13);
    bool bore = false;
    for (const FaceGeometry& geometry : machine.geometries) {
        if (const auto* c = std::get_if<CylinderGeometry>(&geometry)) {
            bore = c->bore && c->radius == near(0.06, 1e-5);
        }
    }
    CHECK(bore);

    OutlineShape outline{Axis::y,
                         {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0.1, 0.2}, {0, 0.1}},
                         {{{0.05, 0.03}, {0.1, 0.03}, {0.1, 0.08}, {0.05, 0.08}}},
                         0,
                         0.05};
    const Machine second = build(single({add(outline)}, 0.03));
    // pentagon 0.02 + 0.01, square hole 0.0025
    CHECK(second.parts[0].volume == near((0.03 - 0.0025) * 0.05, 1e-9));
    CHECK(second.parts[0].min_quality > 0.3);
}

TEST_CASE("a stepped shaft with a throw is one conforming mesh of hexahedra")
{
    ShaftShape shaft;
    shaft.from = -0.1;
    shaft.sections = {{0.1, 0.08, {0, 0}},
                      {0.05, 0.17, {0, 0}},
                      {0.06, 0.25, {0, -0.025}},
                      {0.1, 0.2, {0, -0.025}},
                      {0.05, 0.16, {0, 0}}};
    const Machine machine = build(single({add(shaft)}, 0.03));
    double exact = 0;
    for (const ShaftSection& section : shaft.sections) {
        exact += std::numbers::pi / 4 * section.diameter * section.diameter * section.length;
    }
    CHECK(machine.parts[0].kind == CellKind::hexahedron);
    CHECK(machine.parts[0].volume < exact);
    CHECK(machine.parts[0].volume > exact * polygon_share(24));
    CHECK(machine.parts[0].min_quality > machine::poor_quality);  // circles that cross at 10 degrees
    CHECK(machine.parts[0].mean_quality > 0.7);
    CHECK(closure_error(machine) < 1e-13);
    CHECK(worst_radius_error(machine) < 1e-6);  // nodes where two circles cross lie on both to the kernel's tolerance
    // one connected part: walk over shared nodes
    std::vector<std::uint32_t> root(machine.nodes.size());
    for (std::uint32_t i = 0; i < root.size(); ++i) {
        root[i] = i;
    }
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i) {
            i = root[i] = root[root[i]];
        }
        return i;
    };
    for (const Cell& cell : machine.cells) {
        for (int i = 1; i < 8; ++i) {
            root[find(cell.nodes[i])] = find(cell.nodes[0]);
        }
    }
    std::set<std::uint32_t> roots;
    for (std::uint32_t i = 0; i < root.size(); ++i) {
        roots.insert(find(i));
    }
    CHECK(roots.size() == 1);
}

TEST_CASE("shapes apply in their order")
{
    const BoxShape whole{{0, 0, 0}, {0.1, 0.1, 0.1}};
    const BoxShape half{{0, 0, 0}, {0.05, 0.1, 0.1}};
    CHECK(build(single({add(whole), cut(half)}, 0.05)).parts[0].volume == near(0.5e-3, 1e-12));
    CHECK(build(single({cut(half), add(whole)}, 0.05)).parts[0].volume == near(1e-3, 1e-12));
    CHECK(build(single({add(whole), cut(half), add(half)}, 0.05)).parts[0].volume == near(1e-3, 1e-12));
}

TEST_CASE("an imprint divides faces without changing the solid")
{
    Shape mark{Shape::Operation::imprint, cylinder(Axis::z, {0, 0}, 0.1, 0, 0.02)};
    const Machine machine = build(single({add(BoxShape{{-0.1, -0.1, 0}, {0.1, 0.1, 0.02}}), mark}, 0.03));
    CHECK(machine.parts[0].volume == near(0.04 * 0.02, 1e-9));
    int on_circle = 0;
    for (const Vec3& node : machine.nodes) {
        on_circle += std::abs(std::hypot(node[0], node[1]) - 0.05) < 1e-9 ? 1 : 0;
    }
    CHECK(on_circle >= 2 * 24);  // both ends of a layer
}

TEST_CASE("a half model halves the volume and flags the symmetry plane")
{
    const Shape plate = add(BoxShape{{-0.3, -0.2, 0}, {0.3, 0.2, 0.04}});
    const Shape hole = cut(cylinder(Axis::z, {0, 0.02}, 0.12, 0, 0.04));
    const Shape rod = add(cylinder(Axis::x, {0.5, 0}, 0.04, -0.2, 0.2));
    MachineDescription description = single({plate, hole}, 0.03);
    description.parts.push_back(part("rod", "c", {rod}, 0.02));
    description.parts.push_back(part("far", "d", {add(BoxShape{{0.5, 0, 0}, {0.6, 0.1, 0.1}})}));
    const Machine full = build(description);
    description.half_model = true;
    const Machine half = build(description);
    REQUIRE(half.parts.size() == 2);
    CHECK(half.dropped_parts == std::vector<std::string>{"far"});
    for (int i = 0; i < 2; ++i) {
        CAPTURE(i);
        CHECK(half.parts[i].cut);
        // both meshes inscribe polygons of at least 24 corners, but not the same ones
        CHECK(half.parts[i].volume == near(0.5 * full.parts[i].volume, 0.012));
    }
    for (const Vec3& node : half.nodes) {
        CHECK(node[0] <= 0);
    }
    const double plate_cut = (0.4 - 0.12) * 0.04;
    const double rod_disc = std::numbers::pi * 0.02 * 0.02;
    CHECK(faces_area(half, true) > plate_cut + rod_disc * polygon_share(24) - 1e-9);
    CHECK(faces_area(half, true) < plate_cut + rod_disc + 1e-9);
    for (std::size_t i = 0; i < half.faces.size(); ++i) {
        if (half.faces[i].symmetry) {
            CHECK(half.exposed_fraction[i] == 0);
        }
    }
    CHECK(closure_error(half) < 1e-13);
}

TEST_CASE("parts without a common axis, or on request, become tetrahedra")
{
    const Shape plate = add(BoxShape{{-0.2, 0, -0.2}, {0.2, 0.1, 0.2}});
    const Shape hole = cut(cylinder(Axis::y, {0.05, 0}, 0.1, 0, 0.1));
    const Shape groove = cut(cylinder(Axis::z, {-0.1, 0.1}, 0.1, -0.2, 0.2));
    MachineDescription description = single({plate, hole, groove}, 0.03);
    Log log;
    const Machine machine = machine::build_machine(description, log);
    CHECK(machine.parts[0].kind == CellKind::tetrahedron);
    REQUIRE(log.infos.size() == 1);
    CHECK(contains(log.infos[0], "'p' gets tetrahedra: its shapes have no axis in common"));
    const double exact = 0.4 * 0.4 * 0.1 - std::numbers::pi * (0.05 * 0.05 * 0.1 + 0.5 * 0.05 * 0.05 * 0.4);
    CHECK(machine.parts[0].volume == near(exact, 0.005));  // chords of 24 segments per circle
    CHECK(machine.parts[0].min_quality > 0.15);
    CHECK(closure_error(machine) < 1e-12);
    CHECK(worst_radius_error(machine) < 1e-8);
    int bores = 0;
    for (const FaceGeometry& geometry : machine.geometries) {
        CHECK(!std::holds_alternative<FreeformGeometry>(geometry));
        if (const auto* c = std::get_if<CylinderGeometry>(&geometry)) {
            bores += c->bore ? 1 : 0;
        }
    }
    CHECK(bores == 2);

    MachineDescription asked = single({plate}, 0.05);
    asked.parts[0].tetrahedra = true;
    asked.half_model = true;
    const Machine half = build(asked);
    CHECK(half.parts[0].kind == CellKind::tetrahedron);
    CHECK(half.parts[0].volume == near(0.008, 1e-9));
    CHECK(faces_area(half, true) == near(0.04, 1e-9));
    // no interior face counts as exterior: bottom and top, two ends in z, one side left
    CHECK(half.parts[0].exterior_area == near(2 * 0.2 * 0.4 + 2 * 0.2 * 0.1 + 0.4 * 0.1, 1e-9));
}

TEST_CASE("quality tells flat from thin cells")
{
    Cell cell;
    cell.kind = CellKind::tetrahedron;
    cell.nodes = {0, 1, 2, 3};
    const auto of = [&](const std::vector<Vec3>& nodes) { return machine::quality(cell, nodes); };
    CHECK(of({{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}}) == near(1, 1e-12));  // regular
    // A corner of right angles has det = |a||b||c|, and sqrt(2) of that counts as 1, however thin the cell.
    CHECK(of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == near(1, 1e-12));
    CHECK(of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-3}}) == near(1, 1e-12));
    // A square with two corners lifted by h: each corner has det 2 h and edges sqrt(2), twice sqrt(1 + h^2).
    const double h = 1e-3;
    CHECK(of({{0, 0, 0}, {1, 0, h}, {1, 1, 0}, {0, 1, h}}) ==
          near(std::sqrt(2.0) * 2 * h / (std::sqrt(2.0) * (1 + h * h)), 1e-9));
    CHECK(of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}) < 0);  // inside out
}

TEST_CASE("a way that gives bad cells is not the last one that is tried")
{
    // Gmsh's frontal algorithm leaves quadrilaterals in each other around this bore, at each of the sizes.
    MachineDescription column;
    column.half_model = true;
    column.parts = {part("column", "frame",
                         {add(BoxShape{{-0.72, -1.8284324, 0.1}, {-0.52, -0.9, 0.3}}),
                          cut(cylinder(Axis::y, {-0.62, 0.1745}, 0.1, -1.8284324, -0.9))},
                         0.23),
                    part("elsewhere", "frame", {add(BoxShape{{-0.03, -0.2, -0.3}, {0, 0.2, -0.2}})}, 0.1)};
    const Machine bored = build(column);
    CHECK(bored.parts[0].kind == CellKind::hexahedron);
    CHECK(bored.parts[0].min_quality > 0.1);  // the tetrahedra that it fell back to had 0.001

    // A sliver of quality 0.014 at the size itself.
    MachineDescription bar;
    bar.parts = {part("bar", "frame", {add(BoxShape{{0, 0, 0}, {0.1, 0.45, 0.08}})}, 0.0589)};
    bar.parts[0].tetrahedra = true;
    const Machine tetrahedra = build(bar);
    CHECK(tetrahedra.parts[0].min_quality > 0.1);
    CHECK(tetrahedra.parts[0].volume == near(0.1 * 0.45 * 0.08, 1e-5));
}

TEST_CASE("equal descriptions give identical machines")
{
    MachineDescription description = single(
        {add(BoxShape{{-0.3, -0.2, 0}, {0.3, 0.2, 0.04}}), cut(cylinder(Axis::z, {0.1, 0.02}, 0.12, 0, 0.04))}, 0.03);
    description.parts.push_back(part("pin", "b", {add(cylinder(Axis::z, {0.1, 0.02}, 0.12, -0.1, 0.1))}, 0.02));
    description.parts.push_back(part("block", "b", {add(BoxShape{{-0.3, -0.2, 0.04}, {-0.1, 0.2, 0.1}})}));
    description.parts.back().tetrahedra = true;
    const Machine first = build(description);
    const Machine second = build(description);
    CHECK(first.nodes == second.nodes);
    REQUIRE(first.cells.size() == second.cells.size());
    for (std::size_t i = 0; i < first.cells.size(); ++i) {
        REQUIRE(first.cells[i].nodes == second.cells[i].nodes);
    }
    REQUIRE(first.bonds.size() == second.bonds.size());
    for (std::size_t i = 0; i < first.bonds.size(); ++i) {
        REQUIRE(first.bonds[i].points.size() == second.bonds[i].points.size());
        CHECK(first.bonds[i].area == second.bonds[i].area);
    }
}

TEST_CASE("size and size_scale set the cell size")
{
    MachineDescription description = single({add(BoxShape{{0, 0, 0}, {0.12, 0.12, 0.12}})}, 0);
    description.size = 0.04;
    CHECK(build(description).cells.size() == 27);
    description.size_scale = 0.5;
    CHECK(build(description).cells.size() == 216);
    description.parts[0].size = 0.06;
    CHECK(build(description).cells.size() == 64);
}

TEST_CASE("wrong shapes are refused by part and number")
{
    CHECK(contains(complaint(single({add(BoxShape{{0, 0, 0}, {0.1, 0, 0.1}})}, 0.1)), "part 'p', shape 1"));
    CHECK(contains(complaint(single({add(cylinder(Axis::z, {0, 0}, 0.1, 0, 0.1, 0.2))}, 0.1)), "bore must be smaller"));
    CHECK(contains(complaint(single({add(OutlineShape{Axis::z, {{0, 0}, {1, 0}}, {}, 0, 1})}, 0.1)),
                   "at least 3 points"));
    CHECK(contains(complaint(single({cut(BoxShape{{0, 0, 0}, {1, 1, 1}})}, 0.1)), "no shape that adds"));
    const BoxShape box{{0, 0, 0}, {1, 1, 1}};
    CHECK(contains(complaint(single({add(box), cut(box)}, 0.5)), "no material left"));
    MachineDescription twice = single({add(box)}, 0.5);
    twice.parts.push_back(twice.parts[0]);
    CHECK(contains(complaint(twice), "two parts are called 'p'"));
}
