#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/machine/machine.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using press::describe_machine;
using Kind = SurfaceSelector::Kind;

namespace {

casefile::Case two_links()
{
    casefile::Case input;
    input.machine.half_model = true;
    input.machine.unbonded = {"a|b"};
    input.numerics.size = 0.02;
    input.materials["iron"].density = 7200;
    input.bodies["left"] = {};
    input.bodies["right"] = {};
    casefile::Part part;
    part.body = "left";
    part.material = "iron";
    part.shapes = {{Shape::Operation::add, BoxShape{{0, 0, 0}, {1, 1, 1}}}};
    part.size = 0.01;
    input.parts["link"] = part;
    part.body = "right";
    part.size.reset();
    part.shapes.clear();
    part.mesh = "pin.msh";
    part.position = {0, 0, 0.5};
    input.parts["pin"] = part;
    casefile::Surface gib;
    gib.parts = {"link"};
    gib.select = casefile::Surface::Select::plane;
    gib.axis = Axis::x;
    gib.position = 0.25;
    input.surfaces["gib"] = gib;
    casefile::Joint joint;
    joint.bodies = {"left", "right"};
    joint.centre = {0.3, -0.1};
    casefile::Interface bore;
    bore.name = "bore";
    bore.a = "link";
    bore.b = "pin";
    bore.diameter = 0.08;
    casefile::Interface face;
    face.name = "face";
    face.a = "gib";
    face.b = "gib";
    joint.interfaces = {bore, face};
    input.joints["knuckle"] = joint;
    return input;
}

}  // namespace

TEST_CASE("a normal of any length becomes a direction")
{
    casefile::Case input = two_links();
    casefile::Surface& gib = input.surfaces["gib"];
    gib.axis.reset();
    gib.position.reset();
    gib.normal = {0, -3, 4};
    gib.point = {0.1, 0.2, 0.3};
    const SurfaceSelector selector = describe_machine(input, 1).interfaces.at(1).a;
    CHECK(selector.kind == Kind::plane);
    REQUIRE(selector.normal);
    CHECK(norm(*selector.normal - Vec3{0, -0.6, 0.8}) < 1e-15);
    CHECK(selector.point == Vec3{0.1, 0.2, 0.3});
}

TEST_CASE("a case becomes the description of its machine")
{
    const MachineDescription machine = describe_machine(two_links(), 0.5);
    CHECK(machine.half_model);
    CHECK(machine.size == 0.02);
    CHECK(machine.size_scale == 0.5);
    CHECK(machine.unbonded == std::vector<std::string>{"a|b"});
    REQUIRE(machine.parts.size() == 2);
    CHECK(machine.parts[0].name == "link");
    CHECK(machine.parts[0].size == 0.01);
    CHECK(machine.parts[0].density == 7200);
    CHECK(std::get<std::vector<Shape>>(machine.parts[0].source).size() == 1);
    CHECK(machine.parts[1].size == 0);
    CHECK(std::get<MeshSource>(machine.parts[1].source).path == "pin.msh");
    CHECK(machine.parts[1].translation == Vec3{0, 0, 0.5});
}

TEST_CASE("interfaces are cylinders about the joint's centre, or named surfaces")
{
    const MachineDescription machine = describe_machine(two_links());
    REQUIRE(machine.interfaces.size() == 2);
    const InterfaceDescription& bore = machine.interfaces[0];
    CHECK(bore.name == "knuckle.bore");
    CHECK(bore.a.kind == Kind::cylinder);
    CHECK(bore.a.axis == Axis::z);
    CHECK(bore.a.parts == std::vector<std::string>{"link"});
    CHECK(bore.b.parts == std::vector<std::string>{"pin"});
    CHECK(bore.a.centre == Vec2{0.3, -0.1});
    CHECK(bore.b.diameter == 0.08);
    CHECK(machine.interfaces[1].a.kind == Kind::plane);
    CHECK(machine.interfaces[1].a.position == 0.25);
}

TEST_CASE("a box selects all faces in it")
{
    casefile::Surface surface;
    surface.select = casefile::Surface::Select::box;
    CHECK_THROWS_WITH_AS(press::selector_of(surface, "inside"), doctest::Contains("surfaces.inside"), InputError);
    surface.within = BoxShape{{0, 0, 0}, {1, 1, 1}};
    CHECK(press::selector_of(surface, "inside").kind == Kind::all);
    CHECK(press::selector_of(surface, "inside").within->max == Vec3{1, 1, 1});
}

TEST_CASE("names that lead nowhere and missing numbers are refused")
{
    using doctest::Contains;
    const auto refused = [](const casefile::Case& input, const char* part_of_message) {
        CHECK_THROWS_WITH_AS((void)describe_machine(input), Contains(part_of_message), InputError);
    };
    casefile::Case input = two_links();
    input.parts["link"].material = "stone";
    refused(input, "parts.link.material: there is no material 'stone'");

    input = two_links();
    input.parts["link"].mesh = "also.msh";
    refused(input, "exactly one of 'shapes', 'step' and 'mesh'");

    input = two_links();
    input.joints["knuckle"].interfaces[0].diameter.reset();
    refused(input, "add the diameter");

    input = two_links();
    input.joints["knuckle"].interfaces[1].b = "nothing";
    refused(input, "neither a surface nor a part");

    input = two_links();
    input.surfaces["gib"].position.reset();
    refused(input, "needs 'position'");

    CHECK_THROWS_AS((void)describe_machine(two_links(), 0), InputError);
}
