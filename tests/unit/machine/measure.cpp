/// Requirement: figures of parts and surfaces are those of their geometry, so that laws and masses need no mesh.
#include "deadpoint/machine/assembly/measure.hpp"

#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>

using namespace machine_test;

namespace {

constexpr double exact = 1e-12;  // polynomials of which the rules are exact: only rounding remains

const SurfaceFigures& figures(const Machine& machine, const std::string& name)
{
    return std::ranges::find(machine.surfaces, name, &MeshSurface::name)->figures;
}

SurfaceSelector all_of(std::vector<std::string> parts)
{
    SurfaceSelector selector;
    selector.parts = std::move(parts);
    return selector;
}

double third_power(double from, double to) { return (to * to * to - from * from * from) / 3; }

/// A plate 0.3 x 0.1 x 0.02 m and a round bar of diameter 0.1 m that stands apart, in cells of 30 mm.
MachineDescription plate_and_bar()
{
    MachineDescription description;
    description.parts = {
        part("plate", "frame", {add(BoxShape{{-0.1, 0.5, 0}, {0.2, 0.6, 0.02}})}),
        part("bar", "shaft", {add(cylinder(Axis::z, {1, 0.3}, 0.1, 0, 0.2))}),
    };
    description.surfaces = {
        {"face", on_plane("plate", Axis::z, 0.02)},
        {"end", on_plane("bar", Axis::z, 0.2)},
        {"mantle", on_cylinder("bar", {1, 0.3}, 0.1)},
        {"plate", all_of({"plate"})},
        {"both", all_of({"plate", "bar"})},
    };
    return description;
}

}  // namespace

TEST_CASE("volume moments of a box far from the origin are its integrals, of hexahedra and of tetrahedra")
{
    const Vec3 low{3, -2, 5}, high{3.3, -1.9, 5.02};
    const Vec3 edges = high - low;
    auto block = part("block", "frame", {add(BoxShape{low, high})});
    for (const bool tetrahedra : {false, true}) {
        CAPTURE(tetrahedra);
        block.tetrahedra = tetrahedra;
        MachineDescription description;
        description.parts = {block};
        const Machine machine = build(description);
        const auto& moments = machine.parts.at(0).moments;
        REQUIRE((machine.parts[0].kind == CellKind::tetrahedron) == tetrahedra);
        const double volume = edges[0] * edges[1] * edges[2];
        CHECK(moments.volume == near(volume, exact));
        CHECK(moments.first[0] == near(volume * 3.15, exact));
        CHECK(moments.first[1] == near(volume * -1.95, exact));
        CHECK(moments.second == near(third_power(low[0], high[0]) * edges[1] * edges[2] +
                                         third_power(low[1], high[1]) * edges[0] * edges[2],
                                     exact));
    }
}

TEST_CASE("volume moments of a round bar are those of its polygon, with round edges too")
{
    auto description = plate_and_bar();
    const Machine straight = build(description);
    description.parts.at(1).second_order = true;
    const Machine round = build(description);
    const auto& moments = straight.parts.at(1).moments;
    CHECK(moments.volume == near(straight.parts[1].volume, exact));
    CHECK(moments.first[0] == near(moments.volume * 1, exact));  // symmetric about its axis
    CHECK(moments.first[1] == near(moments.volume * 0.3, exact));
    // About the axis a disk has r^2 / 2 in the mean; of 24 segments or more, 1 - (2 pi / 24)^2 / 6 of it or more
    const double about_axis = moments.second / moments.volume - 1.09;
    CHECK(about_axis < 0.05 * 0.05 / 2);
    CHECK(about_axis > 0.988 * 0.05 * 0.05 / 2);
    REQUIRE(round.parts.at(1).volume > 1.001 * moments.volume);
    CHECK(round.parts[1].moments.volume == near(moments.volume, exact));
}

TEST_CASE("figures of a plane are those of its rectangle")
{
    const Machine machine = build(plate_and_bar());
    const auto& face = figures(machine, "face");
    CHECK(*face.height == near(0.1, exact));
    CHECK(*face.area_over_perimeter == near(0.3 * 0.1 / 0.8, exact));
    CHECK_FALSE(face.cylinder_diameter);
    CHECK_FALSE(face.disk_diameter);
    CHECK(face.moments.mean[0] == near(0.05, exact));
    CHECK(face.moments.mean[1] == near(0.55, exact));
    // One point per face misses h^2 / 12 each way; cells are at most 30 mm wide
    const double square = third_power(-0.1, 0.2) / 0.3 + third_power(0.5, 0.6) / 0.1;
    CHECK(face.moments.mean_square < square);
    CHECK(face.moments.mean_square > square - 2 * 0.03 * 0.03 / 12);
    REQUIRE(face.parts.size() == 1);
    CHECK(face.parts[0].part == 0);
    CHECK(face.parts[0].area == near(0.03, exact));
}

TEST_CASE("figures of a bar know its cylinder and the disk at its end")
{
    const Machine machine = build(plate_and_bar());
    const auto& end = figures(machine, "end");
    CHECK(*end.disk_diameter == near(0.1, exact));
    CHECK_FALSE(end.cylinder_diameter);
    const auto& mantle = figures(machine, "mantle");
    CHECK(*mantle.cylinder_diameter == near(0.1, exact));
    CHECK_FALSE(mantle.disk_diameter);
    CHECK_FALSE(mantle.area_over_perimeter);
}

TEST_CASE("a surface on several parts has areas on each, but neither height nor diameter")
{
    const Machine machine = build(plate_and_bar());
    const auto& plate = figures(machine, "plate");
    CHECK(*plate.height == near(0.1, exact));
    CHECK_FALSE(plate.area_over_perimeter);  // six planes
    const auto& both = figures(machine, "both");
    CHECK_FALSE(both.height);
    CHECK_FALSE(both.disk_diameter);
    REQUIRE(both.parts.size() == 2);
    CHECK(both.parts[0].part == 0);
    CHECK(both.parts[0].area == near(2 * (0.03 + 0.006 + 0.002), exact));
    CHECK(both.parts[1].part == 1);
    CHECK(both.parts[0].area + both.parts[1].area == near(machine.surfaces.back().area, exact));
}
