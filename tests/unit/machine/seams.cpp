#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <cmath>

using namespace machine_test;

namespace {

const double pi = std::numbers::pi;
constexpr double um = 1e-6;
/// Below zero the shapes lie in each other.
constexpr std::array<double, 15> gaps{-10, -5, -2, -1, -0.1, -0.05, -0.01, 0, 0.01, 0.05, 0.1, 1, 2, 5, 10};

MachineDescription single(std::vector<Shape> shapes, double size, bool tetrahedra = false)
{
    MachineDescription description;
    description.parts = {part("p", "b", std::move(shapes), size)};
    description.parts.front().tetrahedra = tetrahedra;
    return description;
}

double free_area(const Machine& machine)
{
    double sum = 0;
    for (const Face& face : machine.faces) {
        sum += machine::area(face, machine.nodes);
    }
    return sum;
}

/// A corner in a frame that is turned by 20 degrees about (0.3, -0.2) m.
Vec2 turned(double x, double y)
{
    const double c = std::cos(20 * pi / 180);
    const double s = std::sin(20 * pi / 180);
    return {0.3 + c * x - s * y, -0.2 + s * x + c * y};
}

OutlineShape oblique_bar(double left, double right, double bottom, double top)
{
    return {Axis::z, {turned(left, bottom), turned(right, bottom), turned(right, top), turned(left, top)}, {}, 0, 0.04};
}

/// One piece, no crack and no sliver: volume and free area to 0.1 %.
void check_joined(const MachineDescription& description, double volume, double area)
{
    const Machine machine = build(description);
    REQUIRE(machine.parts.size() == 1);
    CHECK(machine.parts[0].pieces == 1);
    CHECK(machine.parts[0].volume == near(volume, 1e-3));
    CHECK(free_area(machine) == near(area, 1e-3));
    CHECK(machine.parts[0].min_quality > 0.2);
}

}  // namespace

TEST_CASE("boxes of one part with a gap or an overlap of micrometres are one piece, hexahedra or not")
{
    for (const double gap : gaps) {
        CAPTURE(gap);
        for (const bool tetrahedra : {false, true}) {
            CAPTURE(tetrahedra);
            for (std::size_t k = 0; k < 3; ++k) {
                BoxShape upper{{0, 0, 0}, {0.04, 0.04, 0.04}};
                upper.min[k] = 0.04 + gap * um;
                upper.max[k] = 0.1;
                check_joined(single({add(BoxShape{{0, 0, 0}, {0.04, 0.04, 0.04}}), add(upper)}, 0.02, tetrahedra),
                             0.04 * 0.04 * 0.1, 2 * 0.04 * 0.04 + 4 * 0.04 * 0.1);
            }
        }
    }
}

TEST_CASE("oblique outlines of one part with a gap or an overlap of micrometres are one piece")
{
    // A bar of 100 x 60 and one of 40 x 50 below it; its corners are beside the middle of the first one's edge.
    const double volume = (0.1 * 0.06 + 0.04 * 0.05) * 0.04;
    const double area = 2 * volume / 0.04 + 0.04 * 2 * (0.1 + 0.06 + 0.05);
    for (const double gap : gaps) {
        CAPTURE(gap);
        for (const bool tetrahedra : {false, true}) {
            CAPTURE(tetrahedra);
            const Shape bar = add(oblique_bar(-0.05, 0.05, 0, 0.06));
            const Shape neck = add(oblique_bar(-0.02, 0.02, -0.05, -gap * um));
            check_joined(single({bar, neck}, 0.012, tetrahedra), volume, area);
            check_joined(single({neck, bar}, 0.012, tetrahedra), volume, area);
        }
    }
}

TEST_CASE("outlines whose edges are staggered along the seam, or meet it askew, are one piece")
{
    const double volume = (0.1 + 0.1) * 0.05 * 0.04;
    const double area = 2 * volume / 0.04 + 0.04 * (4 * 0.1 + 4 * 0.05 - 2 * 0.07);
    for (const double gap : gaps) {
        CAPTURE(gap);
        const Shape upper = add(oblique_bar(0, 0.1, 0, 0.05));
        check_joined(single({upper, add(oblique_bar(0.03, 0.13, -0.05, -gap * um))}, 0.012), volume, area);
        OutlineShape askew = oblique_bar(0.03, 0.13, -0.05, 0);
        askew.points[3] = turned(0.03, -gap * um);  // nothing at one end of the seam, the gap at the other
        check_joined(single({upper, add(askew)}, 0.012), volume, area);
        OutlineShape beside_box = {Axis::z, {{0, 0.06}, {-0.04, 0.08}, {-0.04, 0}, {-gap * um, 0.02}}, {}, 0, 0.04};
        const double side = std::hypot(0.04, 0.02);
        const double section = 0.06 * 0.1 + 0.5 * 0.04 * (0.04 + 0.08);
        check_joined(single({add(beside_box), add(BoxShape{{0, 0, 0}, {0.06, 0.1, 0.04}})}, 0.012), section * 0.04,
                     2 * section + 0.04 * (3 * 0.06 + 2 * 0.1 - 0.04 - 0.06 + 2 * side + 0.08));
    }
}

TEST_CASE("a cylinder on a box, along any axis, and a plug in a bore are one piece")
{
    const double disc = pi * 0.015 * 0.015;
    for (const double gap : gaps) {
        CAPTURE(gap);
        const Shape block = add(BoxShape{{-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}});
        const double volume = std::pow(0.06, 3) + disc * 0.04;
        const double area = 6 * 0.06 * 0.06 + 2 * pi * 0.015 * 0.04;
        for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
            const Shape boss = add(cylinder(axis, {0, 0}, 0.03, 0.03 + gap * um, 0.07));
            Machine machine = build(single({block, boss}, 0.006));
            CHECK(machine.parts[0].pieces == 1);
            CHECK(machine.parts[0].volume == near(volume, 2e-3));  // chords: 1.1 % of the boss
            CHECK(free_area(machine) == near(area, 1e-3));
        }
        const Shape plug = add(cylinder(Axis::z, {gap * um / 4, 0}, 0.03 - gap * um, -0.03, 0.03));
        const Machine filled = build(single({block, cut(cylinder(Axis::z, {0, 0}, 0.03, -0.03, 0.03)), plug}, 0.01));
        CHECK(filled.parts[0].pieces == 1);
        CHECK(filled.parts[0].volume == near(std::pow(0.06, 3), 1e-3));
        CHECK(free_area(filled) == near(6 * 0.06 * 0.06, 1e-3));
    }
}

TEST_CASE("in a half model a part that ends micrometres beside the plane of symmetry is cut by it")
{
    for (const double gap : gaps) {
        CAPTURE(gap);
        MachineDescription description = single({add(BoxShape{{-0.1, 0, 0}, {-gap * um, 0.04, 0.04}})}, 0.02);
        description.half_model = true;
        const Machine machine = build(description);
        CHECK(machine.parts[0].cut);
        CHECK(machine.parts[0].volume == near(0.1 * 0.04 * 0.04, 1e-3));
    }
}

TEST_CASE("the seam tolerance says what is joined; what stays open within it is refused, beyond it warned about")
{
    const Shape lower = add(BoxShape{{0, 0, 0}, {0.04, 0.04, 0.04}});
    const Shape upper = add(BoxShape{{0, 0, 0.04 + 20 * um}, {0.04, 0.04, 0.1}});
    MachineDescription description = single({lower, upper}, 0.02);
    Log log;
    Machine machine = machine::build_machine(description, log);
    CHECK(machine.parts[0].pieces == 2);
    REQUIRE(log.warnings.size() == 1);
    CHECK(log.warnings[0] ==
          "part 'p': it has a slit of 20 um at (10.0000, 10.0000, 40.0000) mm (8 faces, 32 cm2), far "
          "thinner than its cells; no heat crosses it, and its sides count as exposed; if no slit is intended, raise "
          "numerics.seam_tolerance or join the shapes");
    description.seam_tolerance = 20 * um;
    CHECK(build(description).parts[0].pieces == 1);
    description.parts.front().source = std::vector<Shape>{lower, add(BoxShape{{0, 0, 0.04}, {0.04, 0.04, 0.04002}})};
    CHECK(complaint(description) ==
          "parts.p.shapes.1: part 'p', shape 2: it is not thicker than the seam tolerance of 20 um; make it "
          "thicker, or lower numerics.seam_tolerance");
}

TEST_CASE("what is moved is said, with the place")
{
    Log log;
    machine::build_machine(single({add(BoxShape{{0, 0, 0}, {0.04, 0.04, 0.04}}),
                                   add(BoxShape{{0.01, 0.01, 0.04 + 2 * um}, {0.03, 0.03, 0.1}})},
                                  0.02),
                           log);
    REQUIRE(log.infos.size() == 1);
    CHECK(log.infos[0] == "part 'p': surfaces of its shapes that nearly meet were joined; the largest move is 2 um, "
                          "near (10.0, 10.0, 40.0) mm");
}

TEST_CASE("pieces are counted, hinges and flat cells are warned about with their place")
{
    const auto warnings = [](std::vector<Shape> shapes, double size) {
        Log log;
        const Machine machine = machine::build_machine(single(std::move(shapes), size), log);
        CHECK(machine.parts[0].pieces ==
              (log.warnings.empty() || log.warnings[0].find("flat") == std::string::npos ? 2 : 1));
        return log.warnings;
    };
    const Shape cube = add(BoxShape{{0, 0, 0}, {0.02, 0.02, 0.02}});
    CHECK(warnings({cube, add(BoxShape{{0, 0, 0.05}, {0.02, 0.02, 0.06}})}, 0.02).empty());  // two plates
    const auto hinge = warnings({cube, add(BoxShape{{0.02, 0.02, 0}, {0.04, 0.04, 0.02}})}, 0.02);
    REQUIRE(hinge.size() == 1);
    CHECK(contains(hinge[0],
                   "part 'p': two of its pieces touch only along an edge or in a point, at (20.0000, 20.0000,"));
    const auto flat = warnings({cube, add(BoxShape{{0.02, 0, 0}, {0.04, 0.02, 0.02 + 30 * um}})}, 0.02);
    REQUIRE(flat.size() == 1);
    CHECK(contains(flat[0], "part 'p': it has flat cells: one at (30.0000, 10.0000, 20.0150) mm is 30 um thin"));
}
