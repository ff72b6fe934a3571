#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/report/mesh/calculix_deck.hpp"
#include "deadpoint/report/mesh/calculix_mesh.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

// Requirement: other programs read the mesh with its parts, surfaces and contacts. Numbers of faces by the manual of
// CalculiX 2.20: hexahedron S1 1-2-3-4, S2 5-8-7-6, S3 1-5-6-2, S4 2-6-7-3, S5 3-7-8-4, S6 4-8-5-1; tetrahedron S1
// 1-2-3, S2 1-4-2, S3 2-4-3, S4 3-4-1.

namespace {

Machine brick_and_tetrahedron()
{
    Machine machine;
    machine.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
                     {1, 1, 1}, {0, 1, 1}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {2, 0, 0}};
    machine.cells = {{CellKind::hexahedron, 0, {0, 1, 2, 3, 4, 5, 6, 7}}, {CellKind::tetrahedron, 1, {8, 9, 10, 11}}};
    MeshPart brick, tetrahedron;
    brick.name = "brick-1";
    brick.cell_count = 1;
    tetrahedron.name = "tip";
    tetrahedron.kind = CellKind::tetrahedron;
    tetrahedron.first_cell = tetrahedron.cell_count = 1;
    machine.parts = {brick, tetrahedron};
    const std::vector<std::array<std::uint32_t, 4>> sides{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (const auto& nodes : sides) {
        Face face;
        face.nodes = nodes;
        machine.faces.push_back(face);
    }
    for (const auto& nodes :
         {std::array<std::uint32_t, 4>{8, 10, 9, 0}, {8, 9, 11, 0}, {9, 10, 11, 0}, {10, 8, 11, 0}}) {
        Face face;
        face.cell = face.part = 1;
        face.node_count = 3;
        face.nodes = nodes;
        machine.faces.push_back(face);
    }
    machine.faces[5].symmetry = true;
    machine.surfaces = {{"all sides", {}, 0}, {"nothing", {}, 0}};
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        machine.surfaces[0].faces.push_back({f, 1});
    Contact contact;
    contact.name = "pin.bush";
    contact.points = {{3, 6, {}, {}, {}, 0.25}, {3, 6, {}, {}, {}, 0.25}};
    machine.interfaces = {contact};
    return machine;
}

}  // namespace

TEST_CASE("the mesh for CalculiX names parts, surfaces and sides of contacts, with the faces' numbers")
{
    const ScratchFolder folder;
    report::write_calculix_mesh(folder.path / "mesh.inp", brick_and_tetrahedron(), {"deadpoint"});
    const auto text = content(folder.path / "mesh.inp");
    const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
    CHECK(text.starts_with("** deadpoint\n*NODE, NSET=ALL\n1, 0.000000000000e+00, 0.000000000000e+00,"));
    CHECK(has("\n12, 2.000000000000e+00, "));
    CHECK(has("*ELEMENT, TYPE=C3D8, ELSET=PART_brick_1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"));
    CHECK(has("*ELEMENT, TYPE=C3D4, ELSET=PART_tip\n2, 9, 10, 11, 12\n"));
    CHECK(has("*SURFACE, NAME=SURFACE_all_sides, TYPE=ELEMENT\n1, S1\n1, S2\n1, S3\n1, S4\n1, S5\n1, S6\n"
              "2, S1\n2, S2\n2, S3\n2, S4\n"));
    CHECK(has("*SURFACE, NAME=INTERFACE_pin_bush_A, TYPE=ELEMENT\n1, S4\n"
              "*SURFACE, NAME=INTERFACE_pin_bush_B, TYPE=ELEMENT\n2, S1\n"));
    CHECK(text.ends_with("*SURFACE, NAME=SYMMETRY, TYPE=ELEMENT\n1, S6\n"));
    CHECK_FALSE(has("nothing"));
}

TEST_CASE("the deck for CalculiX holds materials, ties, supports without force and temperatures")
{
    auto machine = brick_and_tetrahedron();
    machine.parts[0].body = "bed";
    machine.parts[1].body = "tool";
    machine.cells[1].part = 1;
    Contact bond;
    bond.name = "brick-1|tip";
    bond.points = {{3, 6, {}, {}, {}, 0.25}};
    bond.area_a = 1;
    bond.area_b = 0.5;
    machine.bonds = {bond};
    machine.surfaces[0] = {"feet", {}, 0};
    machine.surfaces[0].faces.push_back({2, 1});  // y = 0
    casefile::Case input;
    input.machine.initial_temperature = 293.15;
    input.materials["iron"].youngs_modulus = 110e9;
    input.materials["iron"].poissons_ratio = 0.26;
    input.materials["iron"].expansion = 1.17e-5;
    input.parts["brick-1"].material = input.parts["tip"].material = "iron";
    input.bodies["bed"].ground = true;
    input.bodies["tool"];
    input.chain.emplace();
    input.chain->ground_surface = "feet";
    std::vector<double> temperatures(machine.nodes.size(), 20);
    temperatures[11] = 31.5;
    const ScratchFolder folder;
    report::write_calculix_deck(folder.path / "deformation.inp", machine, input, temperatures, "mesh.inp", {});
    const auto text = content(folder.path / "deformation.inp");
    const auto has = [&](const std::string& piece) { return text.find(piece) != std::string::npos; };
    CHECK(has(
        "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=M_iron\n*ELASTIC\n1.1e+11, 0.26\n*EXPANSION, ZERO=20\n1.17e-05\n"));
    CHECK(has("*SOLID SECTION, ELSET=PART_brick_1, MATERIAL=M_iron\n"));
    CHECK(has("BOND_brick_1_tip_B, BOND_brick_1_tip_A\n"));  // the triangle has the smaller face
    CHECK(has("\n12, 31.5\n"));
    // The face x = 0 is the plane of symmetry: nodes 1, 4, 5 and 8. The feet keep their height, one of them its z.
    const auto from = text.find("*BOUNDARY\n") + 10;
    const auto supports = text.substr(from, text.find('*', from) - from);
    for (const char* held : {"1, 1, 1\n", "4, 1, 1\n", "5, 1, 1\n", "8, 1, 1\n", "1, 2, 2\n", "2, 2, 2\n", "5, 2, 2\n"})
        CHECK_MESSAGE(supports.find(held) != std::string::npos, held);
    CHECK(supports.find("\n3, 2, 2") == std::string::npos);  // it stands above the feet
    // The tool is held six times, at three nodes.
    int of_tool = 0;
    for (const char* node : {"9, ", "10, ", "11, ", "12, "})
        for (const char* axis : {"1, 1\n", "2, 2\n", "3, 3\n"})
            of_tool += supports.find(std::string("\n") + node + axis) != std::string::npos ? 1 : 0;
    CHECK(of_tool == 6);
}
