#include "deadpoint/core/error.hpp"
#include "deadpoint/study/check_machine.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

// Three unit cubes in a row along x, one part each; the first two are bonded.
Machine three_cubes()
{
    Machine machine;
    for (std::uint32_t p = 0; p < 3; ++p) {
        const double x = 2.0 * p;
        const auto first = static_cast<std::uint32_t>(machine.nodes.size());
        for (const double z : {0.0, 1.0})
            for (const Vec2& corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
                machine.nodes.push_back({x + corner[0], corner[1], z});
        Cell cell{CellKind::hexahedron, p, {}};
        for (std::uint32_t i = 0; i < 8; ++i)
            cell.nodes[i] = first + i;
        machine.cells.push_back(cell);
        Face face;
        face.cell = face.part = p;
        machine.faces.push_back(face);
        MeshPart part;
        part.name = std::string(1, static_cast<char>('a' + p));
        part.body = "frame";
        part.first_cell = p;
        part.cell_count = 1;
        machine.parts.push_back(part);
    }
    Contact bond;
    bond.part_a = 0;
    bond.part_b = 1;
    bond.points = {{0, 1, {}, {}, {}, 1}};
    machine.bonds.push_back(bond);
    return machine;
}

}  // namespace

TEST_CASE("a probe must lie on its part, or closer than half a cell's diameter (sqrt(3) / 2 here)")
{
    const Machine machine = three_cubes();
    casefile::Case input;
    input.probes["near"] = {"a", {1.5, 0.5, 0.5}, ""};
    CHECK_NOTHROW(study::require_probes_on_parts(input, machine));
    input.probes["off"] = {"a", {2.5, 0.5, 0.5}, ""};
    CHECK_THROWS_WITH_AS(study::require_probes_on_parts(input, machine),
                         "probes.off: (2500, 500, 500) mm lies 1.5e+03 mm off its part 'a'\n"
                         "  help: move the probe onto the part, or name the part it lies on",
                         InputError);
}

TEST_CASE("in a half model a probe beyond the plane of symmetry stands for its image")
{
    Machine machine = three_cubes();
    for (auto& node : machine.nodes)
        node[0] -= 5;
    machine.half_model = true;
    casefile::Case input;
    input.probes["image"] = {"a", {4.5, 0.5, 0.5}, ""};
    CHECK_NOTHROW(study::require_probes_on_parts(input, machine));
}

TEST_CASE("a body whose parts are not all bonded is named with its pieces")
{
    Machine machine = three_cubes();
    const auto warnings = study::loose_bodies(machine);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings.front() == "body 'frame' falls into 2 pieces that no bond holds together, each of which expands by "
                              "itself: a, b | c; let its parts touch, or make them bodies of their own");
    machine.parts[2].body = "slide";
    CHECK(study::loose_bodies(machine).empty());
}

TEST_CASE("a body of one part that is in two pieces is named too, unless another part holds both")
{
    Machine machine = three_cubes();
    machine.parts[1].body = machine.parts[2].body = "slide";
    machine.parts[0].pieces = 2;
    machine.piece_of_cell = {0, 0, 0};
    const auto warnings = study::loose_bodies(machine);
    REQUIRE(warnings.size() == 2);
    CHECK(
        warnings.front().find("body 'frame' falls into 2 pieces that no bond holds together, each of which expands by "
                              "itself: a (piece 1 of 2) | a (piece 2 of 2)") == 0);

    Machine held = three_cubes();  // a and b are bonded; piece 2 of a is bonded to c, and c to b
    held.parts[0].pieces = 2;
    held.cells.push_back(held.cells.front());
    held.piece_of_cell = {0, 0, 0, 1};
    Face face;
    face.cell = 3;
    held.faces.push_back(face);
    held.bonds.push_back(held.bonds.front());
    held.bonds.back().points = {{3, 2, {}, {}, {}, 1}, {1, 2, {}, {}, {}, 1}};
    CHECK(study::loose_bodies(held).empty());
}
