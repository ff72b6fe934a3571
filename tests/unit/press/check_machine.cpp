#include "deadpoint/press/check/check_machine.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"

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
    CHECK_NOTHROW(press::require_probes_on_parts(input, machine));
    input.probes["off"] = {"a", {2.5, 0.5, 0.5}, ""};
    CHECK_THROWS_WITH_AS(press::require_probes_on_parts(input, machine),
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
    CHECK_NOTHROW(press::require_probes_on_parts(input, machine));
}

TEST_CASE("a body whose parts are not all bonded is named with its pieces")
{
    Machine machine = three_cubes();
    const auto warnings = press::loose_bodies(machine);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings.front().path == "parts.c");
    CHECK(warnings.front().message == "body 'frame' consists of 2 pieces without a bond between them, and each expands "
                                      "separately: a, b | c; 'c' lies 1000 mm along x from 'b'");
    const auto after_move = [&](double x) {
        for (std::size_t n = 16; n < 24; ++n)
            machine.nodes[n][0] += x;  // of c
        return press::loose_bodies(machine).front().message;
    };
    CHECK(after_move(-0.995).ends_with("; 'c' lies 5 mm along x from 'b'"));
    CHECK(after_move(-0.005).ends_with("; 'c' is next to 'b', but no faces of the two lie on each other"));
    machine.parts[2].body = "slide";
    CHECK(press::loose_bodies(machine).empty());
}

TEST_CASE("a body of one part that is in two pieces is named too, unless another part holds both")
{
    Machine machine = three_cubes();
    machine.parts[1].body = machine.parts[2].body = "slide";
    machine.parts[0].pieces = 2;
    machine.piece_of_cell = {0, 0, 0};
    const auto warnings = press::loose_bodies(machine);
    REQUIRE(warnings.size() == 2);
    CHECK(
        warnings.front().message.find("body 'frame' consists of 2 pieces without a bond between them, and each expands "
                                      "separately: a (piece 1 of 2) | a (piece 2 of 2)") == 0);

    Machine held = three_cubes();  // a and b are bonded; piece 2 of a is bonded to c, and c to b
    held.parts[0].pieces = 2;
    held.cells.push_back(held.cells.front());
    held.piece_of_cell = {0, 0, 0, 1};
    Face face;
    face.cell = 3;
    held.faces.push_back(face);
    held.bonds.push_back(held.bonds.front());
    held.bonds.back().points = {{3, 2, {}, {}, {}, 1}, {1, 2, {}, {}, {}, 1}};
    CHECK(press::loose_bodies(held).empty());

    Machine plates = three_cubes();  // a is two plates that turn on one pin of b
    plates.parts[1].body = plates.parts[2].body = "pin";
    plates.parts[0].pieces = 2;
    plates.cells.push_back(plates.cells.front());
    plates.piece_of_cell = {0, 0, 0, 1};
    plates.faces.push_back(face);
    plates.bonds.front().points = {{1, 2, {}, {}, {}, 1}};
    CHECK(press::loose_bodies(plates).size() == 1);
    plates.interfaces.push_back({});
    plates.interfaces.back().points = {{0, 1, {}, {}, {}, 1}, {3, 1, {}, {}, {}, 1}};
    CHECK(press::loose_bodies(plates).empty());
}

TEST_CASE("a formula of the place is held against its surface and the operation: refused at 0 K, warned of below 150 K")
{
    Machine machine = three_cubes();
    Face face;
    face.nodes = {1, 2, 6, 5};  // x = 1 of the first cube
    machine.faces.push_back(face);
    machine.surfaces.push_back({"side", {{static_cast<std::uint32_t>(machine.faces.size() - 1), 1.0}}, 1.0});
    casefile::Case input;
    input.operation.resize(1);
    input.operation[0].duration = 100;
    const auto warnings = [&](const char* formula) {
        input.surfaces["side"].temperature_formula = formula;
        return press::cold_formulas(input, machine);
    };
    CHECK(warnings("293.15 + 10*x").empty());
    CHECK(warnings("150 * x").empty());  // x is 0 on the other side of the cube, which is no part of the surface
    const auto cold = warnings("20 + 10*y");
    REQUIRE(cold.size() == 1);
    CHECK(cold[0].find("surfaces.side.temperature_formula gives 20 K at (1, 0, 0) m, t = 0 s; if degC are meant") == 0);
    CHECK_THROWS_WITH_AS((void)warnings("293.15*x - 3*t"), doctest::Contains("gives -6.85 K"), InputError);
    CHECK_THROWS_WITH_AS((void)warnings("0*x"), doctest::Contains("not above absolute zero"), InputError);
    CHECK_THROWS_AS((void)warnings("293.15/y"), DomainError);
}
