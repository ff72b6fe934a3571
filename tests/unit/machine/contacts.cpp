#include "deadpoint/machine/assembly/contacts.hpp"

#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/polygon.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <cmath>

using namespace machine_test;

namespace {

const double pi = std::numbers::pi;

double summed(const Contact& contact)
{
    double sum = 0;
    for (const ContactPoint& point : contact.points) {
        sum += point.weight;
    }
    return sum;
}

/// Distance of a point from the plane of its facet, and whether it is inside it, judged by areas.
double off_facet(const Machine& machine, std::uint32_t index, const Vec3& point)
{
    const Face& face = machine.faces[index];
    double fan = 0;
    for (int i = 0; i < face.node_count; ++i) {
        const Vec3& p = machine.nodes[face.nodes[i]];
        const Vec3& q = machine.nodes[face.nodes[(i + 1) % face.node_count]];
        fan += 0.5 * norm(cross(p - point, q - point));
    }
    return fan / machine::area(face, machine.nodes) - 1;
}

/// A pin in a bore, meshed with different sizes; the bore is wider than the pin is long, or the other way.
MachineDescription pin_in_bore(double pin_from, double pin_to)
{
    MachineDescription description;
    description.parts = {part("pin", "a", {add(cylinder(Axis::z, {0.01, 0.02}, 0.08, pin_from, pin_to))}, 0.017),
                         part("eye", "b",
                              {add(BoxShape{{-0.09, -0.08, 0}, {0.11, 0.12, 0.06}}),
                               cut(cylinder(Axis::z, {0.01, 0.02}, 0.08, 0, 0.06))},
                              0.023)};
    InterfaceDescription interface;
    interface.name = "joint.pin";
    interface.a = on_cylinder("eye", {0.01, 0.02}, 0.08);
    interface.b = on_cylinder("pin", {0.01, 0.02}, 0.08);
    description.interfaces = {interface};
    return description;
}

}  // namespace

TEST_CASE("convex polygons are clipped exactly")
{
    using machine::Polygon;
    const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    const Polygon diamond{{2, 1}, {3, 2}, {2, 3}, {1, 2}};
    const Polygon common = machine::intersection(square, diamond);
    CHECK(machine::signed_area(common) == near(0.5, 1e-14));
    CHECK(machine::intersection(square, {{5, 5}, {6, 5}, {6, 6}}).empty());
    std::vector<machine::PlanePoint> points;
    machine::append_points({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}, false, points);  // pentagon of area 5
    double area = 0;
    double moment = 0;
    for (const auto& point : points) {
        area += point.weight;
        moment += point.weight * point.position[0] * point.position[0];
    }
    CHECK(area == near(5, 1e-14));
    // integral of x^2: 16/3 over the square, 11/2 over the tip: that of 2 x^2 (3 - x) from 2 to 3
    CHECK(moment == near(16.0 / 3 + 11.0 / 2, 1e-13));
    points.clear();
    machine::append_points({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}, true, points);
    moment = 0;
    for (const auto& point : points) {
        moment += point.weight * std::pow(point.position[0], 4);
    }
    // integral of x^4: 64/5 over the square, that of 2 x^4 (3 - x) from 2 to 3, 473/15, over the tip
    CHECK(moment == near(64.0 / 5 + 473.0 / 15, 1e-13));
}

TEST_CASE("shifted rectangles touch over their exact overlap")
{
    MachineDescription description;
    description.parts = {part("lower", "b", {add(BoxShape{{0, 0, 0}, {0.2, 0.15, 0.05}})}, 0.03),
                         part("upper", "b", {add(BoxShape{{0.07, 0.04, 0.05}, {0.31, 0.33, 0.1}})}, 0.019)};
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 1);
    const Contact& bond = machine.bonds[0];
    CHECK(bond.name == "lower|upper");
    CHECK(bond.area == near(0.13 * 0.11, 1e-12));  // clipping is exact up to rounding
    CHECK(summed(bond) == near(bond.area, 1e-12));
    CHECK(bond.max_gap < 1e-15);
    for (const ContactPoint& point : bond.points) {
        CHECK(point.normal == Vec3{0, 0, 1});
        CHECK(off_facet(machine, point.face_a, point.position_a) < 1e-9);
        CHECK(off_facet(machine, point.face_b, point.position_b) < 1e-9);
    }
}

TEST_CASE("a pin in a bore touches over the area of the true cylinder on non-matching meshes")
{
    const Machine machine = build(pin_in_bore(-0.02, 0.09));
    REQUIRE(machine.interfaces.size() == 1);
    const Contact& contact = machine.interfaces[0];
    CHECK(contact.area == near(pi * 0.08 * 0.06, 1e-9));
    CHECK(contact.area_a == near(pi * 0.08 * 0.06, 1e-9));
    CHECK(contact.area_b == near(pi * 0.08 * 0.11, 1e-9));
    CHECK(contact.coverage() == near(1, 1e-9));
    CHECK(machine.parts[contact.part_a].name == "eye");
    CHECK(machine.parts[contact.part_b].name == "pin");
    const double sagitta = 0.04 * (1 - std::cos(pi / 24));
    CHECK(contact.max_gap < 2 * sagitta);
    Vec3 resultant{};
    for (const ContactPoint& point : contact.points) {
        const Vec3 arm{point.position_a[0] - 0.01, point.position_a[1] - 0.02, 0};
        CHECK(norm(point.normal) == near(1, 1e-12));
        CHECK(dot(point.normal, arm) < 0);  // out of the eye, into the pin
        CHECK(off_facet(machine, point.face_a, point.position_a) < 1e-9);
        CHECK(off_facet(machine, point.face_b, point.position_b) < 1e-9);
        CHECK(std::abs(point.position_a[2] - point.position_b[2]) < 1e-12);
        resultant = resultant + point.weight * point.normal;
    }
    CHECK(norm(resultant) < 1e-5);  // of 0.015 m2: closed but for the quadrature of sine and cosine
    CHECK(machine.bonds.empty());
    CHECK(machine.floating_parts.empty());
    CHECK(machine.overlaps.empty());  // chords do not count
}

TEST_CASE("half of a bore in a half model")
{
    MachineDescription description = pin_in_bore(-0.02, 0.09);
    for (auto& p : description.parts) {
        for (Shape& shape : std::get<std::vector<Shape>>(p.source)) {
            if (auto* c = std::get_if<CylinderShape>(&shape.form)) {
                c->centre = {0, 0.02};
            }
        }
    }
    description.interfaces[0].a.centre = description.interfaces[0].b.centre = {0, 0.02};
    description.half_model = true;
    const Machine machine = build(description);
    CHECK(machine.interfaces[0].area == near(0.5 * pi * 0.08 * 0.06, 1e-9));
    CHECK(machine.interfaces[0].coverage() == near(1, 1e-9));
}

TEST_CASE("a side that is not covered is an error with both numbers and hints")
{
    // the pin ends inside the bore: 40 of 60 mm
    const std::string text = complaint(pin_in_bore(-0.02, 0.04));
    CHECK(contains(text, "interface 'joint.pin'"));
    CHECK(contains(text, "66.7 %"));
    CHECK(contains(text, "98 %"));
    CHECK(contains(text, "10053.1 mm2"));  // pi 80 40
    CHECK(contains(text, "15079.6 mm2"));  // pi 80 60
    CHECK(contains(text, "part 'eye'"));
    CHECK(contains(text, "part 'pin'"));

    // a pin of another diameter: b is found by its own diameter, but nothing touches
    MachineDescription other = pin_in_bore(-0.02, 0.09);
    std::get<std::vector<Shape>>(other.parts[0].source)[0].form = cylinder(Axis::z, {0.01, 0.02}, 0.079, -0.02, 0.09);
    other.interfaces[0].b.diameter = 0.079;
    const std::string loose = complaint(other);
    CHECK(contains(loose, "0.0 %"));
    CHECK(contains(loose, "cylinder of diameter 79 mm along z about (10, 20) mm (0.5 mm away)"));
    other.interfaces[0].gap = 0.6e-3;
    CHECK(build(other).interfaces[0].coverage() == near(1, 1e-9));
}

TEST_CASE("all faulty interfaces are reported at once, with what is there instead")
{
    MachineDescription description = pin_in_bore(-0.02, 0.09);
    InterfaceDescription wrong = description.interfaces[0];
    wrong.name = "joint.second";
    wrong.a.diameter = 0.09;
    description.interfaces[0].b.parts = {"pun"};
    description.interfaces.push_back(wrong);
    const std::string text = complaint(description);
    CHECK(contains(text, "there is no part 'pun'; the parts are: pin, eye"));
    CHECK(contains(text, "interface 'joint.second', side a: cylinder of diameter 90 mm"));
    CHECK(contains(text, "bore of diameter 80 mm along z about (10, 20) mm of 'eye'"));
}

TEST_CASE("'within' clips contacts exactly")
{
    MachineDescription description;
    description.parts = {part("slide", "a", {add(BoxShape{{0, 0, 0}, {0.2, 0.15, 0.05}})}, 0.03),
                         part("guide", "b", {add(BoxShape{{-0.1, 0.02, 0.05}, {0.4, 0.12, 0.1}})}, 0.041)};
    InterfaceDescription interface;
    interface.name = "guide.face";
    interface.a = on_plane("slide", Axis::z, 0.05);
    interface.b = on_plane("guide", Axis::z, 0.05);
    description.interfaces = {interface};
    // side a is wider than the guide: 100 of 150 mm
    CHECK(contains(complaint(description), "66.7 %"));
    description.interfaces[0].a.within = BoxShape{{0.013, 0.02, 0.04}, {0.177, 0.12, 0.06}};
    const Machine machine = build(description);
    CHECK(machine.interfaces[0].area == near(0.164 * 0.1, 1e-12));
    CHECK(machine.interfaces[0].area_a == near(0.164 * 0.1, 1e-12));

    MachineDescription pin = pin_in_bore(-0.02, 0.04);
    pin.interfaces[0].a.within = BoxShape{{-1, -1, 0.005}, {1, 1, 0.033}};
    CHECK(build(pin).interfaces[0].area == near(pi * 0.08 * 0.028, 1e-9));
}

TEST_CASE("a box takes shares of faces, on cylinders by the arc")
{
    // A pin of 100 mm about (10, 20) mm, 24 segments or more, its faces cut by the box at any angle.
    MachineDescription description;
    description.parts = {part("pin", "a", {add(cylinder(Axis::z, {0.01, 0.02}, 0.1, 0, 0.06))}, 0.02)};
    SurfaceDescription side{"side", on_cylinder("pin", {0.01, 0.02}, 0.1)};
    const auto share = [&](const BoxShape& box) {
        side.selector.within = std::nullopt;
        SurfaceDescription part_of_it = side;
        part_of_it.selector.within = box;
        description.surfaces = {side, part_of_it};
        const Machine machine = build(description);
        return machine.surfaces[1].area / machine.surfaces[0].area;
    };
    constexpr double everywhere = 1000;
    // half of it, a third that ends beside the faces' edges, a strip through faces, two strips with nothing between
    const auto right_of = [&](double x) {
        return BoxShape{{x, -everywhere, -everywhere}, {everywhere, everywhere, everywhere}};
    };
    CHECK(share(right_of(0.01)) == near(0.5, 1e-9));
    CHECK(share(right_of(0.01 + 0.05 * std::cos(1.0))) == near(1 / pi, 1e-9));
    const auto strip = [&](double from, double to) {
        return BoxShape{{-everywhere, 0.02 + from, -everywhere}, {everywhere, 0.02 + to, everywhere}};
    };
    CHECK(share(strip(-0.05 * std::sin(0.1), 0.05 * std::sin(0.2))) == near(2 * 0.3 / (2 * pi), 1e-9));
    // the cap left out lies within one face's sagitta
    const double cap = 0.05 * std::cos(0.06);
    CHECK(share(strip(-0.06, cap)) == near(1 - 2 * 0.06 / (2 * pi), 1e-9));
    // along the axis, 17 of 60 mm, between the layers of cells
    CHECK(share({{-everywhere, -everywhere, 0.013}, {everywhere, everywhere, 0.03}}) == near(17.0 / 60, 1e-9));
}

TEST_CASE("a box cuts planes that are inclined, and faces whose middle lies outside go by area alone")
{
    // the long side of a triangle of 300 x 400 mm, 100 mm thick; what of it lies left of x = 113 mm
    MachineDescription description;
    OutlineShape triangle{Axis::z, {{0, 0}, {0.3, 0}, {0, 0.4}}, {}, 0, 0.1};
    description.parts = {part("wedge", "a", {add(triangle)}, 0.07)};
    SurfaceDescription left{"left", {}};
    left.selector.within = BoxShape{{0.001, 0.001, 0.001}, {0.113, 1, 0.099}};
    description.surfaces = {left};
    const Machine machine = build(description);
    CHECK(machine.surfaces[0].area == near(0.112 * 5.0 / 3 * 0.098, 1e-9));
    for (const SurfaceFace& entry : machine.surfaces[0].faces) {
        const Face& face = machine.faces[entry.face];
        double middle = 0;
        for (const std::uint32_t node : face.nodes) {
            middle += machine.nodes[node][0] / 4;
        }
        CHECK(entry.central == (middle < 0.113));
    }
}

namespace {

/// The long side of a triangle of 300 x 400 mm, 100 mm thick, as a surface that a normal and a point select.
MachineDescription wedge(const Vec3& normal, const Vec3& point)
{
    MachineDescription description;
    OutlineShape triangle{Axis::z, {{0, 0}, {0.3, 0}, {0, 0.4}}, {}, 0, 0.1};
    description.parts = {part("wedge", "a", {add(triangle)}, 0.07)};
    SurfaceDescription slope{"slope", {}};
    slope.selector.kind = SurfaceSelector::Kind::plane;
    slope.selector.normal = normalised(normal);
    slope.selector.point = point;
    description.surfaces = {slope};
    return description;
}

/// The normal of that side, turned by an angle within the paper and out of it.
Vec3 tilted(double within, double out)
{
    const double angle = std::atan2(0.3, 0.4) + within;
    return {std::cos(angle), std::sin(angle), std::tan(out)};
}

}  // namespace

TEST_CASE("a plane that is inclined is selected by its normal and a point")
{
    const auto area = [](const Vec3& normal, const Vec3& point) {
        return build(wedge(normal, point)).surfaces.at(0).area;
    };
    const double side = 0.5 * 0.1;
    CHECK(area(tilted(0, 0), {0.3, 0, 0}) == near(side, 1e-9));
    CHECK(area(-1.0 * tilted(0, 0), {0.15, 0.2, 0.07}) == near(side, 1e-9));
    // of the plane, though outside of the face
    CHECK(area(tilted(0, 0), {0.6, -0.4, -3}) == near(side, 1e-9));
    // a direction within 1 mrad and a point within 10 um
    for (const double angle : {-0.9e-3, 0.9e-3}) {
        CHECK(area(tilted(angle, 0), {0, 0.4, 0}) == near(side, 1e-9));
        CHECK(area(tilted(0, angle), {0, 0.4, 0}) == near(side, 1e-9));
    }
    CHECK(area(tilted(0, 0), Vec3{0.3, 0, 0} + 9e-6 * tilted(0, 0)) == near(side, 1e-9));
}

TEST_CASE("a plane of another direction or place than those of the parts is not found, and the message says what is")
{
    for (const double angle : {-1.1e-3, 1.1e-3}) {
        for (const Vec3& normal : {tilted(angle, 0), tilted(0, angle)}) {
            const std::string text = complaint(wedge(normal, {0.3, 0, 0}));
            CAPTURE(text);
            CHECK(contains(text, "surface 'slope': plane of normal (0."));
            CHECK(contains(text, "through (300, 0, 0) mm of any part matches no face; there are no planes of normal"));
        }
    }
    for (const double away : {-11e-6, 11e-6}) {
        const std::string text = complaint(wedge(tilted(0, 0), Vec3{0.3, 0, 0} + away * tilted(0, 0)));
        CAPTURE(text);
        CHECK(contains(text, "matches no face; the nearest there: plane of normal (0.8000, 0.6000, 0.0000) through "
                             "(192, 144, 0) mm of 'wedge'"));
    }
}

TEST_CASE("a contact clipped to half of its cylinder has half of its area")
{
    MachineDescription description = pin_in_bore(0, 0.06);
    description.interfaces[0].a.within = BoxShape{{-1, 0.02 + 0.04 * std::sin(0.3), -1}, {1, 1, 1}};
    const Machine machine = build(description);
    CHECK(machine.interfaces[0].area == near((pi - 0.6) * 0.04 * 0.06, 1e-9));
    CHECK(machine.interfaces[0].coverage() == near(1, 1e-9));
}

TEST_CASE("an interface joins one part to one part")
{
    MachineDescription description;
    description.parts = {part("slide", "a", {add(BoxShape{{0, 0, 0}, {0.2, 0.1, 0.05}})}),
                         part("left", "b", {add(BoxShape{{0, 0, 0.05}, {0.1, 0.1, 0.1}})}),
                         part("right", "b", {add(BoxShape{{0.1, 0, 0.05}, {0.2, 0.1, 0.1}})})};
    InterfaceDescription interface;
    interface.name = "guide.face";
    interface.a = on_plane("slide", Axis::z, 0.05);
    interface.b = on_plane("*", Axis::z, 0.05);
    description.interfaces = {interface};
    const std::string text = complaint(description);
    CHECK(contains(text, "exactly one part to one part"));
    CHECK(contains(text, "left, right"));
}

TEST_CASE("touching boxes of one body are bonded, others are not")
{
    MachineDescription description;
    description.parts = {part("foot", "frame", {add(BoxShape{{0, 0, 0}, {0.3, 0.1, 0.1}})}, 0.03),
                         part("wall", "frame", {add(BoxShape{{0, 0.1, 0}, {0.1, 0.3, 0.1}})}, 0.04),
                         part("shelf", "frame", {add(BoxShape{{0.1, 0.2, 0.02}, {0.3, 0.3, 0.08}})}, 0.025),
                         part("loose", "slide", {add(BoxShape{{0, 0.3, 0}, {0.1, 0.4, 0.1}})}, 0.05)};
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 2);
    CHECK(machine.bonds[0].name == "foot|wall");
    CHECK(machine.bonds[0].area == near(0.01, 1e-12));
    CHECK(machine.bonds[1].name == "wall|shelf");
    CHECK(machine.bonds[1].area == near(0.1 * 0.06, 1e-12));
    CHECK(machine.floating_parts == std::vector<std::string>{"loose"});
    description.unbonded = {"shelf|w*"};
    const Machine apart = build(description);
    CHECK(apart.bonds.size() == 1);
    CHECK(apart.floating_parts == std::vector<std::string>{"shelf", "loose"});
    description.unbonded = {"shelf"};
    CHECK(contains(complaint(description), "'part|part'"));
}

TEST_CASE("a bond with a conductance is an interface too, an open one none")
{
    MachineDescription description;
    description.parts = {part("foot", "frame", {add(BoxShape{{0, 0, 0}, {0.3, 0.1, 0.1}})}, 0.03),
                         part("wall", "frame", {add(BoxShape{{0, 0.1, 0}, {0.1, 0.3, 0.1}})}, 0.04),
                         part("shelf", "frame", {add(BoxShape{{0.1, 0.2, 0.02}, {0.3, 0.3, 0.08}})}, 0.025)};
    description.bonds = {{"bolts", {"w*|foot"}, false}, {"shims", {"shelf|wall"}, true}};
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 2);
    CHECK_FALSE(machine.bonds[0].perfect);
    CHECK_FALSE(machine.bonds[1].perfect);
    REQUIRE(machine.interfaces.size() == 1);
    CHECK(machine.interfaces[0].name == "foot|wall");
    CHECK(machine.interfaces[0].points.size() == machine.bonds[0].points.size());
    CHECK(machine.floating_parts.empty());
    description.bonds = {{"bolts", {"foot|shelf", "wall|shelf"}, false}};
    CHECK(contains(complaint(description), "'foot|shelf' do not touch"));
    description.unbonded = {"shelf|w*"};
    CHECK(contains(complaint(description), "'wall|shelf' are left unbonded"));
    description.bonds = {{"bolts", {"foot|wall"}, false}, {"more", {"wall|*"}, true}};
    CHECK(contains(complaint(description), "the bond of 'foot' and 'wall' is stated twice"));
}

TEST_CASE("exterior = exposed + contacts + bonds, and surfaces select")
{
    MachineDescription description = pin_in_bore(0, 0.09);
    description.parts.push_back(part("block", "b", {add(BoxShape{{0.11, -0.08, 0}, {0.2, 0.12, 0.1}})}, 0.031));
    SurfaceDescription exposed{"air", {}};
    exposed.selector.kind = SurfaceSelector::Kind::exposed;
    SurfaceDescription top{"top", on_plane("block", Axis::y, 0.12)};
    SurfaceDescription box{"corner", {}};
    box.selector.within = BoxShape{{0.105, -1, -1}, {0.3, 1, -0.0 + 1e-6}};
    description.surfaces = {exposed, top, box};
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 1);
    CHECK(machine.bonds[0].area == near(0.2 * 0.06, 1e-12));

    // facets: the pin's side and the bore's are chords, so that their covered area is that of their facets
    const auto facets = [&](const std::string& name) {
        double sum = 0;
        for (const Face& face : machine.faces) {
            const bool round = std::holds_alternative<CylinderGeometry>(machine.geometries[face.geometry]);
            if (machine.parts[face.part].name == name && round) {
                sum += machine::area(face, machine.nodes);
            }
        }
        return sum;
    };
    CHECK(machine.parts[1].exterior_area - machine.parts[1].exposed_area == near(facets("eye") + 0.012, 1e-9));
    CHECK(machine.parts[0].exterior_area - machine.parts[0].exposed_area == near(facets("pin") * 6 / 9, 1e-9));
    CHECK(machine.parts[2].exterior_area - machine.parts[2].exposed_area == near(0.012, 1e-12));
    double open = 0;
    for (const MeshPart& p : machine.parts) {
        open += p.exposed_area;
    }
    CHECK(machine.surfaces[0].area == near(open, 1e-12));
    CHECK(machine.surfaces[1].area == near(0.09 * 0.1, 1e-12));
    // the undersides of block and eye, and of their upright faces a strip of 1 um
    CHECK(machine.surfaces[2].area == near(0.095 * 0.2 + 1e-6 * 0.6, 1e-4));

    description.surfaces = {{"none", on_plane("block", Axis::y, 0.125)}};
    CHECK(contains(complaint(description), "surface 'none': plane y = 125 mm of part 'block' matches no face; the "
                                           "nearest there: plane y = 120 mm of 'block'"));
}

TEST_CASE("tetrahedra and hexahedra are bonded over the exact area")
{
    MachineDescription description;
    description.parts = {
        part("hex", "b",
             {add(BoxShape{{0, 0, 0}, {0.2, 0.15, 0.05}}), cut(cylinder(Axis::z, {0.1, 0.08}, 0.06, 0, 0.05))}, 0.02),
        part("tet", "b", {add(BoxShape{{0.05, -0.1, 0.05}, {0.31, 0.05, 0.1}})}, 0.03),
        part("pin", "b", {add(cylinder(Axis::z, {0.1, 0.08}, 0.06, 0, 0.05))}, 0.02)};
    description.parts[1].tetrahedra = true;
    description.parts[2].tetrahedra = true;
    const Machine machine = build(description);
    REQUIRE(machine.bonds.size() == 2);
    // the bore's polygon reaches neither: it stays 1 mm away from the tetrahedral block's edge at y = 50 mm
    CHECK(machine.bonds[0].area == near(0.15 * 0.05, 1e-9));
    CHECK(machine.bonds[1].area == near(pi * 0.06 * 0.05, 1e-7));  // nodes of the kernel's cylinder: 1e-8
    for (const ContactPoint& point : machine.bonds[1].points) {
        CHECK(off_facet(machine, point.face_b, point.position_b) < 1e-6);
    }
}

TEST_CASE("interpenetrating parts are found with their depth")
{
    MachineDescription description;
    description.parts = {part("plate", "a", {add(BoxShape{{0, 0, 0}, {0.2, 0.2, 0.1}})}, 0.03),
                         part("block", "b", {add(BoxShape{{0.05, 0.05, 0.097}, {0.15, 0.15, 0.2}})}, 0.03),
                         part("beside", "c", {add(BoxShape{{0.2, 0, 0}, {0.3, 0.2, 0.1}})}, 0.04)};
    const Machine machine = build(description);
    REQUIRE(machine.overlaps.size() == 1);
    CHECK(machine.overlaps[0].part_a == "plate");
    CHECK(machine.overlaps[0].part_b == "block");
    CHECK(machine.overlaps[0].depth == near(0.003, 1e-9));
}
