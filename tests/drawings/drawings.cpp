/// Requirement: drawings that nobody made for this program are meshed at any reasonable size, with about as many cells
/// as someone needs who knows the mesher and the part.
#include "../scratch_folder.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/solid_print.hpp"
#include "deadpoint/machine/assembly/build.hpp"
#include "deadpoint/machine/assembly/limits.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/observer.hpp"
#include "drawn_here.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <functional>
#include <gmsh.h>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

const std::string foreign = DEADPOINT_FOREIGN_DRAWINGS;

struct Drawing {
    std::string name;
    std::function<void(const std::string& path)> write;
};

Drawing copied(const std::string& name)
{
    return {name, [=](const std::string& path) { fs::copy_file(foreign + "/step/" + name + ".step", path); }};
}

Drawing translated(const std::string& name)
{
    return {name, [=](const std::string& path) { drawings::translate(foreign + "/occ/" + name + ".brep", path); }};
}

const machine::CadSolid& largest(const machine::CadModel& model)
{
    return *std::ranges::max_element(model.solids, {}, &machine::CadSolid::volume);
}

double longest_side(const BoxShape& box)
{
    const Vec3 sides = box.max - box.min;
    return std::max({sides[0], sides[1], sides[2]});
}

MeshPart meshed(const std::string& path, const std::string& solid, double size)
{
    MachineDescription description;
    PartDescription part;
    part.name = "part";
    part.body = "frame";
    part.size = size;
    part.source = StepSource{path, solid};
    description.parts = {part};
    Observer nobody;
    return machine::build_machine(description, nobody).parts.front();
}

/// The fewest cells that Gmsh needs at this size in the drawing as it is, with circles as fine as here and the better
/// of its two ways to grade sizes; none where both have poor cells.
std::optional<std::size_t> by_hand(const std::string& path, double size)
{
    const machine::GmshSession session;
    std::optional<std::size_t> fewest;
    for (const int extended : {0, 1}) {
        gmsh::clear();
        gmsh::vectorpair solids;
        gmsh::model::occ::importShapes(path, solids);
        gmsh::model::occ::synchronize();
        gmsh::option::setNumber("Mesh.MeshSizeMax", 1e3 * size);
        gmsh::option::setNumber("Mesh.MeshSizeMin", 1e3 * size / 3);
        gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", StepRules{}.circle_cells);
        gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", extended);
        gmsh::model::mesh::generate(3);
        const auto mesh =
            machine::collect_mesh(CellKind::tetrahedron, machine::gmsh_unit, machine::SurfaceNames::from_model, {});
        if (machine::worst_cell(mesh).quality >= machine::poor_quality) {
            fewest = std::min(fewest.value_or(mesh.cells.size()), mesh.cells.size());
        }
    }
    return fewest;
}

/// Meshes the largest solid with cells of an eighth, a sixteenth and a thirty-second of its length.
void mesh_at_three_sizes(const Drawing& drawing)
{
    CAPTURE(drawing.name);
    const ScratchFolder folder;
    const std::string path = folder.path / "part.step";
    drawing.write(path);
    const auto model = machine::read_cad("part", path, std::nullopt, {});
    const auto& solid = largest(model);
    for (const double cells : {8.0, 16.0, 32.0}) {
        CAPTURE(cells);
        const double size = longest_side(solid.bounds) / cells;
        const MeshPart part =
            meshed(path, text_of(SolidReference{name_in_case(solid), text_of(solid.fingerprint)}), size);
        MESSAGE(drawing.name, " ", cells, ": ", part.cell_count, " cells, quality ", part.min_quality);
        CHECK(part.min_quality >= machine::least_quality);
        // Holes and roundings of a third of the size are left out, and circles have corners.
        CHECK(part.volume == near(solid.volume, 0.02 + 0.6 / cells));
        if (cells == 16 && model.solids.size() == 1) {
            if (const auto others = by_hand(path, size)) {
                MESSAGE(drawing.name, ": ", part.cell_count, " cells, by hand ", *others);
                CHECK(part.cell_count <= 1.5 * static_cast<double>(*others));
            }
        }
    }
}

}  // namespace

TEST_CASE("parts of machines that others drew are meshed at three sizes")
{
    for (const char* name : {"linkrods", "screw"}) {
        mesh_at_three_sizes(copied(name));
    }
    for (const char* name : {"CrankArm", "Pump_Nut", "Pump_TopCover", "Motor-c", "Ball", "mal_vis", "solid"}) {
        mesh_at_three_sizes(translated(name));
    }
}

TEST_CASE("thin ribs, thin discs, tiny steps and many holes are meshed at three sizes")
{
    mesh_at_three_sizes({"ribbed plate", drawings::ribbed_plate});
    mesh_at_three_sizes({"cooled cylinder", drawings::cooled_cylinder});
    mesh_at_three_sizes({"cubes with steps", drawings::cubes_with_steps});
    mesh_at_three_sizes({"plate with holes", drawings::plate_with_holes});
}
