#include "deadpoint/error.hpp"
#include "deadpoint/exchange/solid_print.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/machine/cad/ready_solid.hpp"
#include "deadpoint/machine/cad/solid_fault.hpp"
#include "deadpoint/machine/cad/step_solids.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/geometry/packed.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/solids.hpp"
#include "deadpoint/machine/parts/tetrahedra.hpp"
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <fmt/format.h>
#include <gmsh.h>

namespace deadpoint::machine {
namespace {

namespace occ = gmsh::model::occ;

struct Place {
    gp_Pnt centre;
    double area = 0;
};

Place place_of(const TopoDS_Face& face)
{
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties);
    return {properties.CentreOfMass(), properties.Mass()};
}

/// Gmsh's surfaces get the names of the faces that they are, by centre and area.
void name_surfaces(const std::vector<NamedFace>& faces)
{
    constexpr double near = 1e-4;  // [mm], and of an area
    gmsh::vectorpair surfaces;
    occ::getEntities(surfaces, 2);
    for (const NamedFace& named : faces) {
        const Place place = place_of(named.face);
        for (const auto& [dimension, tag] : surfaces) {
            double area = 0;
            double x = 0;
            double y = 0;
            double z = 0;
            occ::getMass(dimension, tag, area);
            occ::getCenterOfMass(dimension, tag, x, y, z);
            if (place.centre.Distance(gp_Pnt(x, y, z)) < near && std::abs(area - place.area) < near * (1 + area)) {
                gmsh::model::setEntityName(dimension, tag, named.name);
            }
        }
    }
}

/// "the solid 'slide' of 'press.step'"
std::string solid_in_words(const StepSource& source)
{
    const std::string name = solid_reference(source.solid).name;
    return name.empty() ? fmt::format("the solid of '{}'", source.path)
                        : fmt::format("the solid '{}' of '{}'", name, source.path);
}

/// A place of the turned solid in the coordinates of its file, where it is to be repaired.
std::string place_in_file(const StepSource& source, const Vec3& place)
{
    const auto& axes = source.axes;
    const Vec3 at = place[0] * axes[0] + place[1] * axes[1] + place[2] * axes[2];
    return fmt::format("at ({:.1f}, {:.1f}, {:.1f}) mm of the drawing", 1e3 * at[0], 1e3 * at[1], 1e3 * at[2]);
}

InputError cannot_be_meshed(const PartDescription& part, const StepSource& source, const std::string& reason,
                            const std::optional<Vec3>& where)
{
    return InputError(fmt::format(
        "part '{}': {} cannot be meshed: {}{}\n  help: repair the solid there in the program that drew it, and export "
        "it again; where it is sound, choose a smaller `smallest_cell`, or leave small roundings out by `omit`",
        part.name, solid_in_words(source), reason, where ? " " + place_in_file(source, *where) : ""));
}

/// What Open CASCADE finds wrong with a solid at which the mesher gave up; nothing where it finds nothing in time.
std::optional<SolidFault> fault_in_child(const ForeignFile& file, const ReadySolid& solid)
{
    constexpr double patience = 60;  // [s]
    const auto work = [&] {
        const auto found = fault_of(unpacked(solid).shape);
        Packer to;
        to.put(found ? found->what : std::string());
        to.put(found ? found->where : Vec3{});
        return to.take();
    };
    try {
        const std::string bytes = run_in_child(file.part, {half_of_memory(), patience}, work);
        Unpacker from(bytes);
        SolidFault fault;
        from.get(fault.what);
        from.get(fault.where);
        return fault.what.empty() ? std::nullopt : std::optional(fault);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

PartMesh mesh_of(const PartDescription& part, const StepSource& source, const ReadySolid& solid,
                 const TetrahedronSize& sizes)
{
    PartMesh mesh;
    guard_gmsh(part.name, "meshing its STEP file", [&] {
        try {
            reset_gmsh();
            const StepSolid shape = unpacked(solid);
            gmsh::vectorpair tags;
            occ::importShapesNativePointer(&shape.shape, tags, true);
            occ::synchronize();
            name_surfaces(shape.named_faces);
            mesh = mesh_model(part.name, sizes);
            mesh.notes.insert(mesh.notes.begin(), solid.notes.begin(), solid.notes.end());
        } catch (const Standard_Failure& failure) {
            throw std::runtime_error(failure.GetMessageString());
        } catch (const MeshFailure& failure) {
            const auto fault = failure.where ? std::nullopt : fault_of(unpacked(solid).shape);
            throw fault ? cannot_be_meshed(part, source, fault->what, fault->where)
                        : cannot_be_meshed(part, source, failure.what(), failure.where);
        }
    });
    // The part is moved after meshing, since its position must not change its mesh.
    return to_machine(Frame{{0, 1, 2}, {1, 1, 1}, part.translation}, std::move(mesh));
}

}  // namespace

PartMesh mesh_step(const PartDescription& part, const StepSource& source, double size, bool half,
                   const Waiting& waiting)
{
    const StepText text = check_step_file(part.name, source.path);
    const ForeignFile file{part.name, source.path, "part.step"};
    const double smallest = source.rules.smallest > 0 ? std::min(source.rules.smallest, size) : size / 3;
    const TetrahedronSize sizes{size, smallest, source.rules.circle_cells, true};
    const SolidRules rules{source.rules.omit.value_or(smallest), half, part.translation[0], text.letters};
    const ReadySolid solid = ready_solid(file, source, rules, waiting);
    try {
        return mesh_foreign_file(
            file, "meshing", [&] { return mesh_of(part, source, solid, sizes); }, waiting);
    } catch (const StoppedChild&) {
        const auto fault = fault_in_child(file, solid);
        throw fault ? cannot_be_meshed(part, source, fault->what, fault->where)
                    : cannot_be_meshed(part, source, "the mesher gives up at it", std::nullopt);
    }
}

}  // namespace deadpoint::machine
