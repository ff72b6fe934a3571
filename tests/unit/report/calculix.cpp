#include "../../scratch_folder.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/report/files/calculix_mesh.hpp"

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
