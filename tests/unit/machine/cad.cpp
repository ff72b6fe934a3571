#include "../../scratch_folder.hpp"
#include "deadpoint/machine/cad/cad_contacts.hpp"
#include "deadpoint/machine/cad/identity.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

using namespace machine_test;
using namespace deadpoint::machine;

namespace {

const double pi = std::numbers::pi;
const std::string data = DEADPOINT_TEST_DATA;
const std::string press = data + "/../../cases/c-frame/press.step";

CadModel read(const std::string& path, std::optional<double> unit = {}) { return read_cad("import", path, unit, {}); }

/// A square of 100 mm in the plane z = `z`, its lower corner at (x, 0).
CadFace square(double x, double z, double up)
{
    CadPlane plane{{0, 0, up}, up * z, {{{x, 0, z}, {x + 0.1, 0, z}, {x + 0.1, 0.1, z}, {x, 0.1, z}}}};
    return {"", 0.01, plane};
}

/// Half of a cylinder about z: angles from `start`, length 40 mm from `from`.
CadFace half_cylinder(double radius, bool bore, double start, double from)
{
    CadCylinder cylinder{{0.2, 0.1, 0}, {0, 0, 1}, {1, 0, 0}, radius, bore, {start, start + pi}, {from, from + 0.04}};
    return {"", pi * radius * 0.04, cylinder};
}

CadModel pair(std::vector<CadFace> a, std::vector<CadFace> b)
{
    const BoxShape everywhere{{-1, -1, -1}, {1, 1, 1}};
    CadModel model;
    model.solids = {{"a", "", "", 1, everywhere, std::move(a)}, {"b", "", "", 1, everywhere, std::move(b)}};
    return model;
}

}  // namespace

TEST_CASE("planes that face each other share the area of their common outline")
{
    const auto found = find_contacts(pair({square(0, 0.05, 1)}, {square(0.03, 0.0502, -1)}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].area == near(0.07 * 0.1, 1e-12));
    CHECK(found[0].clearance == near(0.2e-3, 1e-9));
    CHECK(find_contacts(pair({square(0, 0.05, 1)}, {square(0.03, 0.05, 1)})).empty());     // they look the same way
    CHECK(find_contacts(pair({square(0, 0.05, 1)}, {square(0.03, 0.052, -1)})).empty());   // 2 mm apart
    CHECK(find_contacts(pair({square(0, 0.05, 1)}, {square(0.2, 0.05, -1)})).empty());     // side by side
    CHECK(find_contacts(pair({square(0, 0.05, 1)}, {square(0.0999, 0.05, -1)})).empty());  // 10 mm2
}

TEST_CASE("a hole in one of two planes carries nothing")
{
    CadFace holed = square(0, 0, 1);
    std::get<CadPlane>(holed.form)
        .loops.push_back({{0.02, 0.02, 0}, {0.02, 0.05, 0}, {0.05, 0.05, 0}, {0.05, 0.02, 0}});
    const auto found = find_contacts(pair({holed}, {square(0, 0, -1)}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].area == near(0.01 - 0.03 * 0.03, 1e-12));
}

TEST_CASE("halves of cylinders in one bore count together, whatever their seams and directions")
{
    CadFace back = half_cylinder(0.02, false, 2.0, 0.01);  // drawn from the other end
    auto& turned = std::get<CadCylinder>(back.form);
    turned.axis = {0, 0, -1};
    turned.point = {0.2, 0.1, 0.03};
    turned.angles = {-2.0 - 2 * pi, -2.0 - pi};
    turned.range = {-0.02, 0.02};
    const auto found = find_contacts(pair({half_cylinder(0.02004, true, 0, 0), half_cylinder(0.02004, true, pi, 0)},
                                          {half_cylinder(0.02, false, 2.0, 0.01), back}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == CadContact::Kind::cylinder);
    CHECK(found[0].a == 0);  // the bore
    CHECK(found[0].diameter == near(0.04, 1e-5));
    CHECK(found[0].clearance == near(0.08e-3, 1e-9));
    CHECK(found[0].area == near(2 * pi * 0.02 * 0.03, 1e-9));  // 30 mm of 40 mm lie in the bore
    CHECK(find_contacts(pair({half_cylinder(0.02, true, 0, 0)}, {half_cylinder(0.02, true, 0, 0)})).empty());
    CHECK(find_contacts(pair({half_cylinder(0.021, true, 0, 0)}, {half_cylinder(0.02, false, 0, 0)}))
              .empty());  // 2 mm play
}

TEST_CASE("a ball in a socket is one contact, whatever faces it has")
{
    const auto face = [](double radius, bool hollow, double share, Vec3 centre = {0.1, 0.2, 0.3}) {
        return CadFace{"", share * 4 * pi * radius * radius, CadSphere{centre, radius, hollow}};
    };
    // A ball in two halves; a socket that covers 40 % of it, in two quarters, 0.1 mm wider.
    const auto found = find_contacts(
        pair({face(0.04, false, 0.5), face(0.04, false, 0.4)}, {face(0.04005, true, 0.2), face(0.04005, true, 0.2)}));
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == CadContact::Kind::sphere);
    CHECK(found[0].a == 1);  // the socket
    CHECK(found[0].diameter == near(0.08, 1e-5));
    CHECK(found[0].clearance == near(1e-4, 1e-9));
    CHECK(found[0].area == near(0.4 * 4 * pi * 0.04005 * 0.04005, 1e-12));
    CHECK(found[0].point == Vec3{0.1, 0.2, 0.3});
    CHECK(find_contacts(pair({face(0.04, false, 1)}, {face(0.04, false, 1)})).empty());  // two balls
    CHECK(find_contacts(pair({face(0.04, false, 1)}, {face(0.042, true, 1)})).empty());  // 4 mm of clearance
    CHECK(find_contacts(pair({face(0.04, false, 1)}, {face(0.04, true, 1, {0.1, 0.2, 0.302})})).empty());  // 2 mm off
}

TEST_CASE("the solids of an assembly come with names, volumes and places")
{
    const CadModel model = read(press);
    CHECK(model.unit == "millimetre");
    REQUIRE(model.solids.size() == 17);
    const auto solid = [&](const std::string& name) {
        const auto found = std::ranges::find(model.solids, name, &CadSolid::name);
        REQUIRE(found != model.solids.end());
        return *found;
    };
    CHECK(solid("bolster").volume == near(0.5 * 0.06 * 0.4, 1e-9));
    CHECK(solid("bearing_front_outer_ring").volume == near(pi * (0.0825 * 0.0825 - 0.072 * 0.072) * 0.052, 1e-9));
    CHECK(solid("gib_left").bounds.min[0] == near(-0.22, 1e-9));
    CHECK(solid("wrist_pin").bounds.max[2] == near(0.12, 1e-9));  // this one has a placement of its own
    CHECK(solid("bearing_front_outer_ring").faces.size() == 4);
}

TEST_CASE("umlauts in names become two letters, however the file writes them")
{
    const ScratchFolder folder;
    for (const std::string name : {"St\\X2\\00F600DF\\X0\\el oben", "St\\X\\F6\\X\\DFel oben",
                                   "St\xc3\xb6\xc3\x9f"
                                   "el oben"}) {
        std::ifstream stream(data + "/plate_with_hole.step");
        std::string text(std::istreambuf_iterator<char>(stream), {});
        const std::string old = "'Open CASCADE STEP translator 7.6 1'";
        for (auto at = text.find(old); at != std::string::npos; at = text.find(old)) {
            text.replace(at, old.size(), "'" + name + "'");
        }
        CAPTURE(name);
        CHECK(read(folder.file("plate.step", text).string()).solids.at(0).name == "Stoessel_oben");
    }
}

TEST_CASE("every contact of the drawn press is found, and no other")
{
    const CadModel model = read(press);
    struct Truth {
        const char* one;
        const char* other;
        double area;
    };
    // What make.tcl draws: cylinders 2 pi r l, planes by their edges. An oil hole of 8 mm goes straight through the
    // front bore; it counts evenly over the 60 mm of the bore, of which the ring covers 52. One of 10 mm cuts the rod's
    // bore 80 mm beside its axis: the integral of dA / cos over the hole is 175.7 mm2 above, 138.8 mm2 below, where it
    // begins.
    const double length_of_rod = 0.1;
    const double oil_hole = pi * 0.004 * 0.004 * 52 / 60, slanting_hole = 314.5e-6;
    const std::vector<Truth> truth{{"frame", "bearing_front_outer_ring", 2 * pi * 0.0825 * 0.052 - oil_hole},
                                   {"frame", "bearing_back_outer_ring", 2 * pi * 0.0825 * 0.052},
                                   {"bearing_front_inner_ring", "crankshaft", 2 * pi * 0.05 * 0.052},
                                   {"bearing_back_inner_ring", "crankshaft", 2 * pi * 0.05 * 0.052},
                                   {"flywheel", "crankshaft", 2 * pi * 0.05 * 0.06},
                                   {"connecting_rod", "crankshaft", 2 * pi * 0.09 * length_of_rod - slanting_hole},
                                   {"connecting_rod", "wrist_pin", 2 * pi * 0.035 * length_of_rod},
                                   {"slide", "wrist_pin", 2 * pi * 0.035 * 0.136},
                                   {"slide", "gib_left", 0.34 * 0.24},
                                   {"slide", "gib_right", 0.34 * 0.24},
                                   {"bracket_left", "gib_left", 0.34 * 0.35},
                                   {"bracket_right", "gib_right", 0.34 * 0.35},
                                   {"frame", "bracket_left", 0.36 * 0.08},
                                   {"frame", "bracket_right", 0.36 * 0.08},
                                   {"frame", "bolster", 0.5 * 0.4},
                                   {"frame", "motor_foot", 0.2 * 0.25},
                                   {"motor", "motor_foot", 0.12 * 0.15}};
    const auto found = find_contacts(model);
    for (const Truth& expected : truth) {
        CAPTURE(expected.one);
        CAPTURE(expected.other);
        const auto fits = [&](const CadContact& contact) {
            const std::string a = model.solids[contact.a].name;
            const std::string b = model.solids[contact.b].name;
            return (a == expected.one && b == expected.other) || (b == expected.one && a == expected.other);
        };
        REQUIRE(std::ranges::count_if(found, fits) == 1);
        CHECK(std::ranges::find_if(found, fits)->area == near(expected.area, 1e-4));
    }
    CHECK(found.size() == truth.size());
    // Across the gap of the rollers, 24 mm on the diameter, the rings of each bearing face each other.
    const auto across = find_contacts(model, {.plane = -1, .into = 0, .cylinder = 0.21});
    const auto rings = [&](const CadContact& contact) {
        return model.solids[contact.a].name == "bearing_front_outer_ring" &&
               model.solids[contact.b].name == "bearing_front_inner_ring" &&
               std::abs(contact.area - 2 * pi * 0.06 * 0.052) < 1e-6;
    };
    CHECK(std::ranges::count_if(across, rings) == 1);
}

TEST_CASE("a part names its solid")
{
    const SolidPrint print{1e-3, {0.1, 0.1, 0.1}, {}};
    const std::vector<SolidIdentity> solids{
        {"frame", "frame", print}, {"gib_left", "gib_left", print}, {"gib_right", "gib_right", print}};
    const auto chosen = [&](const std::string& solid) { return chosen_solids("p", {"a.step", solid}, solids).solids; };
    CHECK(chosen("gib_*") == std::vector<std::size_t>{1, 2});
    CHECK(chosen_solids("p", {"a.step"}, {solids[0]}).solids == std::vector<std::size_t>{0});
    CHECK_THROWS_WITH_AS(
        chosen(""),
        "part 'p': 'a.step' holds 3 solids: frame, gib_left, gib_right\n  help: choose one by solid = "
        "\"frame\"; solid = \"*\" makes all of them one piece; `deadpoint init --step` writes a part for each",
        InputError);
    CHECK_THROWS_WITH_AS(
        chosen("fram"),
        "part 'p': 'a.step' holds no solid 'fram'; it holds frame, gib_left, gib_right\n  help: did you mean "
        "'frame'?",
        InputError);
}

TEST_CASE("a stated unit counts instead of that of the file")
{
    const CadModel inches = read(data + "/plate_with_hole.step", 0.0254);
    CHECK(inches.scale == near(25.4, 1e-12));
    CHECK(extent(inches) == near(2.54, 1e-9));  // 100 units
    CHECK(read(data + "/plate_with_hole.step").scale == 1);
}

TEST_CASE("small holes are left out before meshing, large ones stay")
{
    MachineDescription description;
    PartDescription import;
    import.name = "slide";
    import.body = "b";
    import.density = 1000;
    StepSource source{press, "slide"};
    import.source = source;
    description.parts = {import};
    description.size = 0.06;
    Log log;
    const Machine without = build_machine(description, log);
    REQUIRE(log.infos.size() == 1);
    CHECK(log.infos[0].starts_with(
        "part 'slide': holes and roundings up to 20 mm are left out: 4 of 4"));  // M12, a third of 60 mm
    source.rules.omit = 0;
    description.parts[0].source = source;
    const Machine with = build(description);
    CHECK(with.cells.size() > without.cells.size());
    // Four holes of 12 mm, 40 mm deep from below: at (+-100, -780, +-80) mm.
    const auto on_floors_of_holes = [](const Machine& machine) {
        return std::ranges::count_if(machine.nodes, [](const Vec3& x) {
            const double off_axis = std::hypot(std::abs(x[0]) - 0.1, std::abs(x[2]) - 0.08);
            return std::abs(x[1] + 0.74) < 1e-6 && off_axis < 0.006 + 1e-6;
        });
    };
    CHECK(on_floors_of_holes(without) == 0);
    CHECK(on_floors_of_holes(with) >= 4 * 4);  // corners of each floor
}

TEST_CASE("a part may be turned from the axes of its file")
{
    MachineDescription description;
    PartDescription import;
    import.name = "bolster";
    import.body = "b";
    import.density = 1000;
    StepSource source{press, "bolster"};
    source.axes = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};  // z, x and y of the file are x, y and z
    import.source = source;
    description.parts = {import};
    description.size = 0.06;
    const Machine machine = build(description);
    double least[3]{1, 1, 1};
    for (const Vec3& node : machine.nodes) {
        for (std::size_t i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], node[i]);
        }
    }
    CHECK(least[0] == near(-0.15, 1e-9));
    CHECK(least[1] == near(-0.25, 1e-9));
    CHECK(least[2] == near(-0.95, 1e-9));
}
