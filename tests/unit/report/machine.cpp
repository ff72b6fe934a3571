#include "deadpoint/exchange/machine.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_films.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/press/check/plausibility.hpp"
#include "deadpoint/press/check/whole_mass.hpp"
#include "deadpoint/report/mesh/mesh_files.hpp"
#include "deadpoint/report/mesh/plan_text.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::report;
namespace fs = std::filesystem;

namespace {

MeshPart part(const std::string& name, const std::string& body, double mass, bool cut)
{
    MeshPart result;
    result.name = name;
    result.body = body;
    result.mass = mass;
    result.cut = cut;
    result.cell_count = 1;
    return result;
}

/// Half a press in miniature: a frame of a cut beam and a column (with a dropped twin), and an uncut link.
Machine small_machine()
{
    Machine machine;
    machine.half_model = true;
    machine.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {9, 9, 9}};
    machine.cells = {{CellKind::hexahedron, 0, {0, 1, 2, 3, 4, 5, 6, 7}}, {CellKind::tetrahedron, 2, {0, 1, 2, 8}}};
    Face quad;
    quad.nodes = {0, 3, 2, 1};
    Face triangle;
    triangle.node_count = 3;
    triangle.part = 2;
    triangle.nodes = {1, 2, 8, 0};
    machine.faces = {quad, triangle};
    machine.exposed_fraction = {0.25, 1};
    machine.parts = {part("beam", "frame", 50, true), part("column", "frame", 20, false),
                     part("rod", "link", 10, false)};
    machine.surfaces = {{"air", {{0, 0.25}, {1, 1}}, 3.0}, {"top", {{0, 1}}, 1.0}};
    Contact contact;
    contact.name = "pin.bush";
    contact.points = {{1, 0, {}, {}, {}, 0.0123}};
    contact.area = 0.0123;
    contact.area_a = 0.0125;
    contact.drawn_area = 0.0123;
    contact.stroke = 0.06;
    contact.least_area = 0.01;
    contact.part_a = 2;
    machine.interfaces = {contact};
    machine.dropped_parts = {"column_right"};
    return machine;
}

casefile::Case small_case()
{
    casefile::Case description;
    description.machine.name = "small";
    description.bodies["frame"].mass = 140;
    description.bodies["link"].mass = 9.7;  // 10 kg computed: +3.1 %
    description.parts["column_right"].body = "frame";
    auto& film = description.surfaces["air"].film.emplace();
    film.law = casefile::FilmCoefficient{5};
    film.emissivity = 0.9;
    description.joints["pin"].kind = casefile::Joint::Kind::revolute;
    return description;
}

}  // namespace

TEST_CASE("in a half model a body across the plane counts twice, a twin once")
{
    const auto masses = press::whole_masses(small_case(), small_machine());
    REQUIRE(masses.size() == 2);
    CHECK(masses[0].parts == 2);
    CHECK(masses[0].computed == near(140, 1e-5));  // 2 (50 + 20)
    CHECK(masses[1].computed == near(10, 1e-5));
    CHECK(masses[1].deviation().value() == near(0.0309, 1e-3));

    auto no_cut = small_machine();
    no_cut.parts[0].cut = false;  // the dropped column still says that the frame has a far side
    CHECK(press::whole_masses(small_case(), no_cut)[0].computed == near(140, 1e-5));
    no_cut.dropped_parts.clear();
    CHECK(press::whole_masses(small_case(), no_cut)[0].computed == near(70, 1e-5));
}

TEST_CASE("a mesh is questioned for masses beyond 2 %, overlaps and floating parts")
{
    auto machine = small_machine();
    machine.overlaps = {{"beam", "rod", {0.1, 0, 0}, 0.002}};
    machine.floating_parts = {"rod"};
    std::vector<std::string> texts;
    for (const auto& finding : press::question_machine(small_case(), machine, 1))
        if (finding.code != "implausible")
            texts.push_back(finding.path + ": " + finding.message);
    CHECK(texts == std::vector<std::string>{
                       "bodies.link.mass: body 'link' has 10 kg by its parts, but 9.7 kg are stated (+3.1 %)",
                       "parts.rod: parts 'beam' and 'rod' overlap by 2 mm near (100.0, 0.0, 0.0) mm",
                       "parts.rod: part 'rod' is not connected: no bond and no interface joins it to another part"});
}

TEST_CASE("unknowns and memory follow order and dimension chain")
{
    auto description = small_case();
    const auto heat = estimate_size(description, small_machine());
    CHECK(heat.hexahedra == 1);
    CHECK(heat.tetrahedra == 1);
    CHECK(heat.heat_unknowns == 9);
    CHECK(heat.deformation_unknowns == 0);
    CHECK(heat.memory == near(0.25e9 + 9 * 2.2e3, 1e-5));
    description.chain.emplace();
    description.numerics.order = 2;
    const auto drift = estimate_size(description, small_machine());
    CHECK(drift.heat_unknowns == 72);
    CHECK(drift.deformation_unknowns == 216);
    CHECK(drift.memory == near(0.25e9 + 2.5 * (72 * 2.2e3 + 216 * 3.2e3), 1e-5));
    description.parts["rod"].order = 1;  // the tetrahedron: one node of its own
    auto apart = small_machine();
    apart.nodes.insert(apart.nodes.end(), {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    apart.cells[1].nodes = {9, 10, 11, 8};
    CHECK(estimate_size(description, apart).heat_unknowns == 8 * 8 + 4);
}

TEST_CASE("the plan names what there is, with area, coverage and condition")
{
    const auto text = plan_text(small_case(), small_machine());
    CHECK(text.find("small (half model, x <= 0)") == 0);
    CHECK(text.find("  pin.bush   revolute  rod      beam       123.0   98.4 %       0.0         60.0  80.0 %\n") !=
          std::string::npos);
    CHECK(text.find("air          3.000  convection 5.00 W/m2/K, emissivity 0.900\n") != std::string::npos);
    CHECK(text.find("top          1.000  \n") == std::string::npos);  // no trailing blanks
    CHECK(text.find("beyond the symmetry plane: column_right") != std::string::npos);
    CHECK(text.find("Bonded pairs") == std::string::npos);  // there are none
}

TEST_CASE("mesh files hold all cells and faces, and a list of names")
{
    const fs::path folder = fs::temp_directory_path() / ("deadpoint-mesh-" + std::to_string(std::random_device{}()));
    fs::create_directories(folder);
    write_mesh_files(folder, small_machine(), {"deadpoint test"});
    const auto content = [&](const char* name) {
        std::ifstream in(folder / name, std::ios::binary);
        std::ostringstream out;
        out << in.rdbuf();
        return out.str();
    };
    CHECK(content("mesh.vtu").find("NumberOfPoints=\"9\" NumberOfCells=\"2\"") != std::string::npos);
    const auto faces = content("surfaces.vtu");
    CHECK(faces.find("NumberOfPoints=\"5\" NumberOfCells=\"2\"") != std::string::npos);  // nodes 0 1 2 3 and 8
    for (const char* name : {"part", "body", "surface", "interface", "symmetry", "exposed"}) {
        CHECK(faces.find("Name=\"" + std::string(name) + "\"") != std::string::npos);
    }
    CHECK(content("names.csv") ==
          "# deadpoint test\n# columns: kind, number, name\nkind,number,name\npart,0,beam\npart,1,column\npart,2,rod\n"
          "body,0,frame\nbody,1,link\nsurface,0,air\nsurface,1,top\ninterface,0,pin.bush\n");
    fs::remove_all(folder);
}
