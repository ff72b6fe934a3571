#include "../../scratch_folder.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sys/stat.h>

using namespace machine_test;

namespace {

const double pi = std::numbers::pi;
const std::string data = DEADPOINT_TEST_DATA;

/// A file in a folder of its own, removed at the end.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, const std::string& text) : path_(folder_.file(name, text)) {}
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    ScratchFolder folder_;
    std::filesystem::path path_;
};

/// A bar of unit cubes along x from `first`, as a Gmsh 2.2 file with the end at the largest x as surface "tip".
std::string bar_of_cubes(int first, int count)
{
    std::string text =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"tip\"\n3 1 \"solid\"\n$EndPhysicalNames\n";
    text += fmt::format("$Nodes\n{}\n", 4 * (count + 1));
    for (int i = 0; i <= count; ++i) {
        for (int k = 0; k < 4; ++k) {
            text += fmt::format("{} {} {} {}\n", 4 * i + k + 1, first + i, k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0);
        }
    }
    text += fmt::format("$EndNodes\n$Elements\n{}\n", count + 1);
    const int end = 4 * count;
    text += fmt::format("1 3 2 7 1 {} {} {} {}\n", end + 1, end + 2, end + 3, end + 4);
    for (int i = 0; i < count; ++i) {
        text += fmt::format("{} 5 2 1 1", i + 2);
        for (int k = 1; k <= 8; ++k) {
            text += fmt::format(" {}", 4 * i + k);
        }
        text += "\n";
    }
    return text + "$EndElements\n";
}

MachineDescription imported(std::variant<std::vector<Shape>, StepSource, MeshSource> source)
{
    MachineDescription description;
    PartDescription import;
    import.name = "import";
    import.body = "b";
    import.source = std::move(source);
    import.density = 1000;
    description.parts = {import};
    description.size = 0.01;
    return description;
}

SurfaceSelector in_group(const std::string& name)
{
    SurfaceSelector selector;
    selector.kind = SurfaceSelector::Kind::group;
    selector.group = name;
    return selector;
}

}  // namespace

TEST_CASE("a STEP file keeps its unit and its surfaces")
{
    const std::string path = data + "/plate_with_hole.step";  // 100 x 60 x 20 mm, hole of 30 mm
    const double exact = (0.1 * 0.06 - pi * 0.015 * 0.015) * 0.02;
    MachineDescription description = imported(StepSource{path});
    const Machine machine = build(description);
    CHECK(machine.parts[0].kind == CellKind::tetrahedron);
    CHECK(machine.parts[0].volume > exact);
    CHECK(machine.parts[0].volume < exact * 1.005);  // chords of 24 segments
    REQUIRE(machine.geometries.size() == 7);
    int bores = 0;
    for (const FaceGeometry& geometry : machine.geometries) {
        if (const auto* c = std::get_if<CylinderGeometry>(&geometry)) {
            ++bores;
            CHECK(c->bore);
            CHECK(c->radius == near(0.015, 1e-7));
            CHECK(c->point[0] == near(0.01, 1e-6));
        }
    }
    CHECK(bores == 1);

    // a hexahedral pin in its hole, and the whole thing moved
    description.parts[0].translation = {0.2, 0, 0.1};
    description.parts.push_back(part("pin", "b", {add(cylinder(Axis::z, {0.21, 0}, 0.03, 0.05, 0.2))}, 0.005));
    const Machine moved = build(description);
    REQUIRE(moved.bonds.size() == 1);
    CHECK(moved.bonds[0].area == near(pi * 0.03 * 0.02, 1e-6));  // fitted radius

    MachineDescription half = imported(StepSource{path});
    half.half_model = true;
    const Machine cut_machine = build(half);
    CHECK(cut_machine.parts[0].cut);
    // the hole reaches from x = -5 to 25 mm: what of it lies at x < 0 is a circular segment
    const double segment = 0.015 * 0.015 * std::acos(10.0 / 15) - 0.01 * std::sqrt(0.015 * 0.015 - 0.01 * 0.01);
    CHECK(cut_machine.parts[0].volume == near((0.05 * 0.06 - segment) * 0.02, 0.002));  // chords again
}

TEST_CASE("a STEP file in metres is a thousand times larger")
{
    std::ifstream file(data + "/plate_with_hole.step");
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string milli = "SI_UNIT(.MILLI.,.METRE.)";
    const std::size_t at = text.find(milli);
    REQUIRE(at != std::string::npos);
    text.replace(at, milli.size(), "SI_UNIT($,.METRE.)");
    const TemporaryFile copy("metres.step", text);
    MachineDescription description = imported(StepSource{copy.path()});
    description.size = 10;
    CHECK(build(description).parts[0].volume == near((100 * 60 - pi * 225) * 20, 0.005));
}

TEST_CASE("a Gmsh file of hexahedra is taken as it is")
{
    const TemporaryFile file("bar.msh", bar_of_cubes(-2, 3));
    MachineDescription description = imported(MeshSource{file.path(), 0.01});
    description.surfaces = {{"end", in_group("tip")}};
    const Machine machine = build(description);
    CHECK(machine.parts[0].kind == CellKind::hexahedron);
    CHECK(machine.cells.size() == 3);
    CHECK(machine.nodes.size() == 16);
    CHECK(machine.parts[0].volume == near(3e-6, 1e-12));
    CHECK(machine.geometries.size() == 6);  // planes, each recognised once
    CHECK(machine.surfaces[0].area == near(1e-4, 1e-12));
    CHECK(machine.surfaces[0].faces.size() == 1);

    // bonded to a box made here, over the exact area
    description.parts.push_back(part("box", "b", {add(BoxShape{{0.01, 0.002, 0.002}, {0.03, 0.02, 0.02}})}, 0.003));
    const Machine both = build(description);
    REQUIRE(both.bonds.size() == 1);
    CHECK(both.bonds[0].area == near(0.008 * 0.008, 1e-9));

    description.surfaces = {{"end", in_group("top")}};
    CHECK(contains(complaint(description), "named groups there are: tip"));
}

TEST_CASE("a mesh of second order is taken by its corners")
{
    // one tetrahedron of ten nodes with edges of one unit along x, y and z; its middle nodes lie off the edges
    std::string text =
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .5 0 .01\n";
    text += "6 .5 .5 0\n7 0 .5 0\n8 0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n$EndNodes\n$Elements\n1\n";
    text += "1 11 2 1 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n";
    const TemporaryFile file("curved.msh", text);
    const Machine machine = build(imported(MeshSource{file.path(), 0.1}));
    CHECK(machine.cells.size() == 1);
    CHECK(machine.nodes.size() == 4);
    CHECK(machine.parts[0].volume == near(1e-3 / 6, 1e-12));
}

TEST_CASE("a drawing in metres that should be in millimetres is refused before meshing")
{
    std::ifstream file(data + "/plate_with_hole.step");
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string milli = "SI_UNIT(.MILLI.,.METRE.)";
    text.replace(text.find(milli), milli.size(), "SI_UNIT(.KILO.,.METRE.)");
    const TemporaryFile copy("kilometres.step", text);
    CHECK(contains(complaint(imported(StepSource{copy.path()})),
                   "part 'import' is 100000 m long\n  help: its file says kilometre; if that is wrong, state `unit`"));
    Log log;
    StepSource corrected{copy.path()};
    corrected.unit = 1e-3;
    CHECK(machine::build_machine(imported(corrected), log).parts[0].volume ==
          near((0.1 * 0.06 - pi * 0.015 * 0.015) * 0.02, 0.005));
    REQUIRE(log.warnings.size() == 1);
    CHECK(contains(log.warnings[0], "makes it 1e-06 times as large as its file says"));
}

TEST_CASE("a half model takes the half of a mesh that has faces on its plane")
{
    const TemporaryFile file("bar.msh", bar_of_cubes(-2, 3));
    MachineDescription description = imported(MeshSource{file.path(), 0.01});
    description.half_model = true;
    const Machine machine = build(description);
    CHECK(machine.cells.size() == 2);
    CHECK(machine.nodes.size() == 12);
    CHECK(machine.parts[0].cut);
    description.parts[0].translation = {0.005, 0, 0};
    CHECK(contains(complaint(description), "straddle the symmetry plane"));
}

TEST_CASE("planes and oblique cylinders of a mesh are recognised")
{
    // a plate of 100 x 60 x 20 mm with a hole of 30 mm, turned by 0.4 rad about (1, 1, 0)
    MachineDescription description = imported(MeshSource{data + "/tilted_plate.msh", 1e-3});
    description.surfaces = {{"bore", in_group("bore")}, {"outside", in_group("outside")}};
    const Machine machine = build(description);
    CHECK(machine.geometries.size() == 7);
    const double s = std::sqrt(0.5);
    const Vec3 axis{s * std::sin(0.4), -s * std::sin(0.4), std::cos(0.4)};  // z turned about (1, 1, 0)
    int cylinders = 0;
    for (const FaceGeometry& geometry : machine.geometries) {
        CHECK(!std::holds_alternative<FreeformGeometry>(geometry));
        if (const auto* c = std::get_if<CylinderGeometry>(&geometry)) {
            ++cylinders;
            CHECK(c->bore);
            CHECK(c->radius == near(0.015, 1e-6));  // digits of the file
            CHECK(norm(cross(c->axis, axis)) < 1e-6);
        }
    }
    CHECK(cylinders == 1);
    CHECK(machine.surfaces[0].area == near(pi * 0.03 * 0.02, 0.01));  // chords of 16 segments: 0.64 %
    CHECK(machine.surfaces[0].area + machine.surfaces[1].area == near(machine.parts[0].exterior_area, 1e-12));
}

TEST_CASE("overlaps with imported parts are found through their cells")
{
    const TemporaryFile file("bar.msh", bar_of_cubes(-2, 3));
    MachineDescription description = imported(MeshSource{file.path(), 0.01});
    description.parts.push_back(part("box", "c", {add(BoxShape{{0.008, 0.001, 0.001}, {0.03, 0.009, 0.009}})}, 0.004));
    const Machine machine = build(description);
    REQUIRE(machine.overlaps.size() == 1);
    CHECK(machine.overlaps[0].depth == near(0.002, 1e-6));
    std::get<std::vector<Shape>>(description.parts[1].source)[0].form =
        BoxShape{{0.01, 0.001, 0.001}, {0.03, 0.009, 0.009}};
    CHECK(build(description).overlaps.empty());
}

TEST_CASE("unusable files are refused by part")
{
    CHECK_THROWS_AS(build(imported(MeshSource{data + "/no_such.msh", 1})), IoError);
    CHECK_THROWS_AS(build(imported(StepSource{data + "/no_such.step"})), IoError);
    // A folder, and a pipe into which nobody writes.
    CHECK_THROWS_AS(build(imported(MeshSource{data, 1})), IoError);
    const ScratchFolder folder;
    const auto pipe = (folder.path / "pipe").string();
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    CHECK_THROWS_AS(build(imported(MeshSource{pipe, 1})), IoError);
    CHECK_THROWS_AS(build(imported(StepSource{pipe})), IoError);
    // one prism
    const TemporaryFile prism(
        "prism.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                     "4 0 0 1\n5 1 0 1\n6 0 1 1\n$EndNodes\n$Elements\n1\n1 6 2 1 1 1 2 3 4 5 6\n$EndElements\n");
    const std::string text = complaint(imported(MeshSource{prism.path(), 1}));
    CHECK(contains(text, "part 'import'"));
    CHECK(contains(text, "Prism 6"));
    // only a triangle
    const TemporaryFile shell("shell.msh",
                              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                              "$EndNodes\n$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
    CHECK(contains(complaint(imported(MeshSource{shell.path(), 1})), "no solid cells"));
    const TemporaryFile noise("noise.step", "this is no STEP file\n");
    CHECK(contains(complaint(imported(StepSource{noise.path()})), "is not a STEP file"));
}

TEST_CASE("the worst cell is named by its place and the face it lies at")
{
    auto text = bar_of_cubes(0, 2);
    for (int k = 0; k < 4; ++k) {  // the second cube is flat
        const std::string node = fmt::format("\n{} ", 9 + k);
        text.replace(text.find(node + "2 "), node.size() + 2, node + "1 ");
    }
    const TemporaryFile flat("flat.msh", text);
    CHECK(contains(complaint(imported(MeshSource{flat.path(), 1})),
                   "the worst, at (1000.0, 500.0, 500.0) mm by its face 'tip', has quality"));
}

TEST_CASE("a cell size that cannot be meant is refused or warned of before the work")
{
    MachineDescription description = imported(StepSource{data + "/plate_with_hole.step"});
    description.size = 1e-5;
    // 106 cm3 of regular tetrahedra of 0.01 mm: 6 sqrt(2) times as many as cubes
    CHECK(contains(complaint(description), "part 'import': a cell size of 0.01 mm gives 9.0e+11 cells, but"));

    struct Impatient : Observer {
        void warn(std::string_view text) override { throw InputError(std::string(text)); }
    } impatient;
    description.parts = {part("cube", "b", {add(BoxShape{{0, 0, 0}, {0.002, 0.002, 0.002}})})};
    CHECK_THROWS_WITH_AS(
        machine::build_machine(description, impatient),
        "parts.cube: part 'cube': a cell size of 0.01 mm gives about 8.0e+06 cells, which take minutes to mesh and "
        "hours to compute; check its size",
        InputError);
    // A cylinder across a box has no axis in common with it: tetrahedra.
    description.parts = {part("cross", "b",
                              {add(BoxShape{{0, 0, 0}, {0.001, 0.001, 0.001}}),
                               add(cylinder(Axis::x, {0.0005, 0.0005}, 0.0005, -0.001, 0.002)),
                               add(cylinder(Axis::y, {0.0005, 0.0005}, 0.0005, -0.001, 0.002))})};
    try {
        machine::build_machine(description, impatient);
        FAIL("nothing was said");
    } catch (const InputError& error) {
        CHECK(contains(error.what(),
                       "part 'cross': a cell size of 0.01 mm gives about 1."));  // 1.8e6 cubes are no reason
        CHECK(contains(error.what(), "e+07 cells, which"));
    }
}
