#include "deadpoint/machine/assembly/sketch.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/machine/assembly/build.hpp"
#include "deadpoint/machine/parts/meshed_parts.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>

using namespace machine_test;

namespace {

/// A pin of 40 mm in a bore, and a cap on the pin's end; `bore` is what the joint says of the diameter.
MachineDescription pin_in_bore(double bore)
{
    MachineDescription description;
    description.size = 0.02;
    description.parts = {
        part("block", "frame",
             {add(BoxShape{{-0.05, -0.05, 0}, {0.05, 0.05, 0.06}}), cut(cylinder(Axis::z, {0, 0}, 0.04, -1, 1))}),
        part("pin", "link", {add(cylinder(Axis::z, {0, 0}, 0.04, 0, 0.06))})};
    description.interfaces = {{"knuckle.bore", on_cylinder("pin", {0, 0}, 0.04), on_cylinder("block", {0, 0}, bore)}};
    description.surfaces = {{"end", on_plane("pin", Axis::z, 0)}};
    return description;
}

machine::Sketch sketched(const MachineDescription& description)
{
    Log log;
    return machine::sketch_machine(description, log);
}

bool misses(const machine::Sketch& sketch, const std::string& path)
{
    return std::ranges::any_of(sketch.missing, [&](const Diagnostic& d) { return d.path == path; });
}

double area(const Machine& machine, const std::vector<std::uint32_t>& faces)
{
    double sum = 0;
    for (const auto face : faces)
        sum += face_area(machine, machine.faces[face]);
    return sum;
}

}  // namespace

TEST_CASE("the sketch of a machine without mistakes is the machine, with the faces that touch")
{
    const auto description = pin_in_bore(0.04);
    const auto sketch = sketched(description);
    const auto machine = build(description);
    CHECK(sketch.missing.empty());
    CHECK(sketch.machine.nodes == machine.nodes);
    CHECK(sketch.machine.bonds.size() == machine.bonds.size());
    REQUIRE(sketch.interfaces.size() == 1);
    CHECK(sketch.interfaces[0].joined);
    // The bore is all of the pin's mantle: chords of 24 or more segments are up to 0.3 % shorter than the circle.
    const double mantle = std::numbers::pi * 0.04 * 0.06;
    for (const auto& side : sketch.interfaces[0].sides)
        CHECK(area(sketch.machine, side) == near(mantle, 0.004));
}

TEST_CASE("an interface without a face on one side keeps the faces of the other and is named")
{
    const auto sketch = sketched(pin_in_bore(0.05));
    CHECK(sketch.machine.parts.size() == 2);
    CHECK(sketch.machine.interfaces.empty());
    REQUIRE(sketch.interfaces.size() == 1);
    CHECK_FALSE(sketch.interfaces[0].joined);
    CHECK(sketch.interfaces[0].sides[0].size() > 0);
    CHECK(sketch.interfaces[0].sides[1].empty());
    CHECK(misses(sketch, "joints.knuckle.interfaces.bore.b"));
    CHECK(sketch.machine.surfaces.size() == 1);
}

TEST_CASE("a part that cannot be made leaves the others in the sketch")
{
    auto description = pin_in_bore(0.04);
    description.parts.push_back(part("nothing", "frame", {add(cylinder(Axis::z, {0.2, 0}, 0.04, 0, 0.06, 0.04))}));
    PartDescription lost = part("lost", "frame", {});
    lost.source = StepSource{"/no/such/file.step"};
    description.parts.push_back(lost);
    CHECK_THROWS(build(description));
    const auto sketch = sketched(description);
    REQUIRE(sketch.machine.parts.size() == 2);
    CHECK(sketch.machine.parts[1].name == "pin");
    CHECK(sketch.machine.interfaces.size() == 1);
    CHECK(misses(sketch, "parts.lost"));
    CHECK(std::ranges::any_of(sketch.missing, [](const Diagnostic& d) { return d.path.starts_with("parts.nothing"); }));
}

TEST_CASE("a sketch takes the parts that the build before it has made, and its failures")
{
    const auto description = pin_in_bore(0.05);  // the joint's diameter is wrong
    MeshedParts kept;
    int made = 0;
    const auto count = [&] {
        ++made;
        return machine::PartMesh{};
    };
    Log log;
    CHECK_THROWS(machine::build_machine(description, log, &kept));
    kept.once("pin", count);
    kept.once("block", count);
    CHECK(made == 0);
    const auto sketch = machine::sketch_machine(description, log, &kept);
    CHECK(sketch.machine.parts.size() == 2);
    CHECK(sketch.machine.nodes == sketched(description).machine.nodes);
    int failed = 0;
    const auto fail = [&]() -> machine::PartMesh {
        ++failed;
        throw InputError("flat cells");
    };
    CHECK_THROWS_AS(kept.once("other", fail), InputError);
    CHECK_THROWS_AS(kept.once("other", fail), InputError);
    CHECK(failed == 1);
}
