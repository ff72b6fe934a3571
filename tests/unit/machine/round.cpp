/// Requirement: parts of second order have the round edges of their cylinders, and all areas and volumes follow.
#include "deadpoint/machine/assembly/round.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <set>

using namespace machine_test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.04;

/// A pin in the bore of an eye, both between z = 0 and 60 mm.
MachineDescription pin_in_eye(bool second_order, bool tetrahedra = false, double size = 0.02)
{
    MachineDescription description;
    description.parts = {part("pin", "a", {add(cylinder(Axis::z, {0.01, 0.02}, 2 * radius, 0, 0.06))}, size),
                         part("eye", "b",
                              {add(BoxShape{{-0.09, -0.08, 0}, {0.11, 0.12, 0.06}}),
                               cut(cylinder(Axis::z, {0.01, 0.02}, 2 * radius, 0, 0.06))},
                              1.3 * size)};
    for (PartDescription& own : description.parts) {
        own.second_order = second_order;
        own.tetrahedra = tetrahedra;
    }
    InterfaceDescription interface;
    interface.name = "joint.pin";
    interface.a = on_cylinder("eye", {0.01, 0.02}, 2 * radius);
    interface.b = on_cylinder("pin", {0.01, 0.02}, 2 * radius);
    description.interfaces = {interface};
    description.surfaces = {{"end", on_plane("pin", Axis::z, 0.06)},
                            {"side", on_cylinder("pin", {0.01, 0.02}, 2 * radius)}};
    return description;
}

double from_axis(const Vec3& x) { return std::hypot(x[0] - 0.01, x[1] - 0.02); }

/// What parabolas through the middles of arcs lose, measured by the segments of a circle: at half angles below
/// pi / 24 less than 2e-5 of the whole, in place of 1.1e-2 by chords.
constexpr double parabola = 2e-5;

}  // namespace

TEST_CASE("round edges: volumes and areas of a cylinder and of its bore, of either shape of cell")
{
    for (const bool tetrahedra : {false, true}) {
        CAPTURE(tetrahedra);
        const Machine chords = build(pin_in_eye(false, tetrahedra));
        CHECK(chords.round_edges.empty());
        const Machine machine = build(pin_in_eye(true, tetrahedra));
        const double disk = pi * radius * radius, block = 0.2 * 0.2;
        CHECK(chords.parts[0].volume < (1 - 1e-3) * disk * 0.06);
        CHECK(machine.parts[0].volume == near(disk * 0.06, parabola));
        CHECK(machine.parts[0].mass == near(1000 * machine.parts[0].volume, 1e-12));
        CHECK(machine.parts[1].volume == near((block - disk) * 0.06, parabola));
        CHECK(machine.surfaces[0].area == near(disk, parabola));
        CHECK(machine.surfaces[1].area == near(2 * pi * radius * 0.06, parabola));
        CHECK(machine.parts[0].exterior_area == near(2 * disk + 2 * pi * radius * 0.06, parabola));
        // what touches is hidden to rounding
        CHECK(machine.parts[0].exposed_area == near(2 * disk, parabola));
    }
}

TEST_CASE("round edges: their volume converges at fourth order")
{
    std::array<double, 2> loss{}, count{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Machine machine = build(pin_in_eye(true, false, i == 0 ? 0.0105 : 0.00525));
        loss[i] = std::abs(machine.parts[0].volume / (pi * radius * radius * 0.06) - 1);
        std::set<std::uint32_t> circle;
        for (const Face& face : machine.faces) {
            for (int k = 0; face.part == 0 && k < face.node_count; ++k) {
                const Vec3& x = machine.nodes[face.nodes[k]];
                if (x[2] == 0 && std::abs(from_axis(x) - radius) < 1e-9) {
                    circle.insert(face.nodes[k]);
                }
            }
        }
        count[i] = static_cast<double>(circle.size());
    }
    CHECK(std::log(loss[0] / loss[1]) / std::log(count[1] / count[0]) == near(4, 0.05));
}

TEST_CASE("round edges: a contact keeps its area, and its points lie on both faces where they meet")
{
    for (const bool tetrahedra : {false, true}) {
        const Machine machine = build(pin_in_eye(true, tetrahedra, 0.008));
        const Contact& contact = machine.interfaces[0];
        CHECK(contact.area == near(2 * pi * radius * 0.06, 1e-9));
        CHECK(contact.max_gap < parabola * radius);
        for (const ContactPoint& point : contact.points) {
            CHECK(from_axis(point.position_a) == near(radius, parabola));
            CHECK(from_axis(point.position_b) == near(radius, parabola));
            CHECK(norm(point.position_a - point.position_b) < parabola * radius);
        }
    }
    // 32 chords in 24
    CHECK(build(pin_in_eye(false, false, 0.008)).interfaces[0].max_gap > 1e-3 * radius);
}

TEST_CASE("round edges: flat contacts between them count the true areas of their faces")
{
    // two disks on each other, whose meshes differ
    MachineDescription description;
    description.parts = {part("lower", "a", {add(cylinder(Axis::z, {0, 0}, 0.08, 0, 0.02))}, 0.011),
                         part("upper", "a", {add(cylinder(Axis::z, {0, 0}, 0.08, 0.02, 0.04))}, 0.007)};
    for (PartDescription& own : description.parts) {
        own.second_order = true;
    }
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 1);
    // within what chords of a sixth of each edge leave out: 1.1e-2 / 36
    CHECK(machine.bonds[0].area == near(pi * 0.04 * 0.04, 4e-4));
    CHECK(machine.bonds[0].coverage() == near(1, 4e-4));
}

TEST_CASE("round edges: a cell too thin for them stays straight")
{
    // one cell on a bore of 1 m, 60 degrees wide: its chord lies 134 mm off the bore
    const auto straightened = [](double thickness) {
        Machine machine;
        for (const double z : {0.0, 1.0}) {
            for (const auto& [angle, away] :
                 {std::pair{-pi / 6, 0.0}, {-pi / 6, thickness}, {pi / 6, thickness}, {pi / 6, 0.0}}) {
                machine.nodes.push_back({std::cos(angle) + away, std::sin(angle), z});
            }
        }
        machine.cells = {{CellKind::hexahedron, 0, {0, 1, 2, 3, 4, 5, 6, 7}}};
        machine.faces = machine::exterior_faces(machine.cells);
        machine.geometries = {FreeformGeometry{}, CylinderGeometry{{}, {0, 0, 1}, 1, true}};
        for (Face& face : machine.faces) {
            const bool inner =
                std::ranges::all_of(face.nodes, [](std::uint32_t n) { return n % 4 == 0 || n % 4 == 3; });
            face.geometry = inner ? 1 : 0;
        }
        machine.parts.resize(1);
        machine.parts[0].cell_count = 1;
        const std::size_t cells = machine::add_round_edges(machine, 1);
        return std::pair{cells, machine.round_edges.size()};
    };
    CHECK(straightened(0.1) == std::pair<std::size_t, std::size_t>{1, 0});
    CHECK(straightened(1) == std::pair<std::size_t, std::size_t>{0, 2});
}

TEST_CASE("round edges: an edge where two cylinders meet lies on both")
{
    MachineDescription description;
    description.parts = {
        part("tee", "a", {add(cylinder(Axis::z, {0, 0}, 0.1, 0, 0.2)), add(cylinder(Axis::x, {0, 0.1}, 0.06, 0, 0.15))},
             0.03)};
    description.parts[0].second_order = true;
    const Machine machine = build(description);
    int on_both = 0;
    for (const RoundEdge& edge : machine.round_edges) {
        const Vec3 middle = 0.5 * (machine.nodes[edge.nodes[0]] + machine.nodes[edge.nodes[1]]) + edge.bulge;
        const double off_z = std::abs(std::hypot(middle[0], middle[1]) - 0.05);
        const double off_x = std::abs(std::hypot(middle[1], middle[2] - 0.1) - 0.03);
        CHECK(std::min(off_z, off_x) < 1e-9);
        on_both += off_z < 1e-9 && off_x < 1e-9 ? 1 : 0;
    }
    CHECK(on_both > 8);
}
