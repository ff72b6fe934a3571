#include "../../scratch_folder.hpp"
#include "fixture.hpp"

#include <fmt/format.h>

using namespace machine_test;

namespace {

/// A mesh as it is written to a file, in metres.
struct Cells {
    std::vector<Vec3> nodes;
    std::vector<std::vector<std::size_t>> cells;
};

/// A block of unit cubes from `first` to `first + count`, with nodes of its own.
void add_block(Cells& mesh, const Vec3& first, const std::array<std::size_t, 3>& count)
{
    const std::size_t start = mesh.nodes.size();
    const auto node = [&](std::size_t i, std::size_t j, std::size_t k) {
        return start + (k * (count[1] + 1) + j) * (count[0] + 1) + i;
    };
    for (std::size_t k = 0; k <= count[2]; ++k) {
        for (std::size_t j = 0; j <= count[1]; ++j) {
            for (std::size_t i = 0; i <= count[0]; ++i) {
                mesh.nodes.push_back(first +
                                     Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
            }
        }
    }
    for (std::size_t k = 0; k < count[2]; ++k) {
        for (std::size_t j = 0; j < count[1]; ++j) {
            for (std::size_t i = 0; i < count[0]; ++i) {
                mesh.cells.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                                      node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                      node(i, j + 1, k + 1)});
            }
        }
    }
}

/// A cube of five tetrahedra.
Cells tetrahedral_cube()
{
    Cells mesh;
    add_block(mesh, {0, 0, 0}, {1, 1, 1});
    mesh.cells = {{0, 1, 2, 4}, {1, 3, 2, 7}, {1, 4, 7, 5}, {2, 4, 6, 7}, {1, 2, 4, 7}};
    return mesh;
}

/// A Gmsh 2.2 file of the mesh.
std::string text_of(const Cells& mesh)
{
    std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec3& p = mesh.nodes[i];
        text += fmt::format("{} {} {} {}\n", i + 1, p[0], p[1], p[2]);
    }
    text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.cells.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        text += fmt::format("{} {} 2 1 1", i + 1, mesh.cells[i].size() == 4 ? 4 : 5);
        for (const std::size_t node : mesh.cells[i]) {
            text += fmt::format(" {}", node + 1);
        }
        text += "\n";
    }
    return text + "$EndElements\n";
}

/// What building a machine of one imported part says: the error, or the first warning, or nothing.
std::string said_about(const Cells& mesh)
{
    ScratchFolder folder;
    MachineDescription description;
    PartDescription import;
    import.name = "import";
    import.body = "b";
    import.source = MeshSource{folder.file("part.msh", text_of(mesh)).string(), 1.0};
    description.parts = {import};
    Log log;
    try {
        machine::build_machine(description, log);
    } catch (const InputError& error) {
        return error.what();
    }
    return log.warnings.empty() ? "" : log.warnings.front();
}

}  // namespace

TEST_CASE("a cell that a mesh file holds twice is refused with its place, on the same nodes or on nodes of its own")
{
    Cells mesh = tetrahedral_cube();
    CHECK(said_about(mesh).empty());
    Cells twice = mesh;
    twice.cells.push_back(mesh.cells.back());
    CHECK(said_about(twice) ==
          "parts.import: part 'import': cells overlap at (500.0000, 500.0000, 500.0000) mm: two of them "
          "are on the same side of one face; mesh it again without overlaps");
    Cells corner = mesh;
    corner.cells.push_back(mesh.cells.front());
    CHECK(contains(said_about(corner), "cells overlap at (250.0000, 250.0000, 250.0000) mm"));

    Cells copied = mesh;
    for (const std::size_t node : mesh.cells.front()) {
        copied.nodes.push_back(mesh.nodes[node]);
    }
    copied.cells.push_back({8, 9, 10, 11});
    CHECK(contains(said_about(copied), "part 'import': cells overlap at ("));
}

TEST_CASE("blocks of a mesh file that lie in each other are refused with the place, however they lie")
{
    for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0.5, 0.25, 0}, Vec3{1.9, 0, 0}, Vec3{1.97, 0.5, 0.5}}) {
        CAPTURE(at[0]);
        Cells mesh;
        add_block(mesh, {0, 0, 0}, {2, 2, 2});
        add_block(mesh, at, {2, 2, 2});
        CHECK(contains(said_about(mesh), "part 'import': cells overlap at ("));
    }
}

TEST_CASE("blocks of a mesh file on doubled nodes, or micrometres apart, are refused with the place")
{
    for (const double gap : {-1e-5, -1e-6, 0.0, 1e-9, 1e-6, 1e-5}) {
        CAPTURE(gap);
        Cells mesh;
        add_block(mesh, {0, 0, 0}, {2, 2, 2});
        add_block(mesh, {2 + gap, 0.25, 0}, {2, 2, 2});
        const std::string text = said_about(mesh);
        CHECK(contains(text, "part 'import': free faces coincide at (2000."));
        CHECK(contains(text, "and no heat would cross there; make one solid"));
    }
    Cells mesh;
    add_block(mesh, {0, 0, 0}, {2, 2, 2});
    add_block(mesh, {2.001, 0, 0}, {2, 2, 2});
    CHECK(contains(said_about(mesh),
                   "part 'import': it has a slit of 1e+03 um at (2000.0000, 500.0000, 500.0000) mm (8 "
                   "faces, 8e+04 cm2)"));
    Cells apart;
    add_block(apart, {0, 0, 0}, {2, 2, 2});
    add_block(apart, {2.1, 0, 0}, {2, 2, 2});
    CHECK(said_about(apart).empty());
}

TEST_CASE("free faces of a wedge that closes to an edge, and both sides of a thin sheet, are no slit")
{
    Cells wedge;  // two cubes with a common edge at x = z = 1, the faces between them 0.3 degrees apart
    add_block(wedge, {0, 0, 0}, {1, 1, 1});
    add_block(wedge, {0, 0, 1}, {1, 1, 1});
    wedge.cells[1][1] = wedge.cells[0][5];
    wedge.cells[1][2] = wedge.cells[0][6];
    wedge.nodes[8][2] = wedge.nodes[10][2] = 1.005;
    CHECK(contains(said_about(wedge), "touch only along an edge or in a point"));  // a hinge, but no error

    Cells sheet;
    add_block(sheet, {0, 0, 0}, {3, 3, 3});
    for (Vec3& node : sheet.nodes) {
        node[2] *= 0.5e-4;
    }
    CHECK(contains(said_about(sheet), "it has flat cells"));
}
