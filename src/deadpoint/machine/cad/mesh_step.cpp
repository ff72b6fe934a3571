#include "deadpoint/error.hpp"
#include "deadpoint/machine/cad/defeature.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/machine/cad/step_solids.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/solids.hpp"
#include "deadpoint/machine/parts/tetrahedra.hpp"
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <fmt/format.h>
#include <gmsh.h>

namespace deadpoint::machine {
namespace {

namespace occ = gmsh::model::occ;

/// Follows named faces through a change of the shape.
template <class Builder>
void follow(StepSolid& solid, Builder& work)
{
    std::vector<NamedFace> named;
    for (const NamedFace& one : solid.named_faces) {
        if (work.IsDeleted(one.face)) {
            continue;
        }
        const auto& images = work.Modified(one.face);
        if (images.IsEmpty()) {
            named.push_back(one);
        }
        for (const TopoDS_Shape& image : images) {
            named.push_back({TopoDS::Face(image), one.name});
        }
    }
    solid.named_faces = std::move(named);
    solid.shape = work.Shape();
}

/// The chosen solids as one.
StepSolid chosen(const ForeignFile& file, const StepSource& source, const StepContents& contents)
{
    if (contents.solids.empty()) {
        throw InputError(fmt::format("part '{}': '{}' holds no solid; export a closed solid", file.part, file.path));
    }
    std::vector<std::string> names;
    for (const StepSolid& solid : contents.solids) {
        names.push_back(solid.name);
    }
    StepSolid result;
    for (const auto& name : chosen_solids(file.part, file.path, source.solid, names)) {
        const StepSolid& next = *std::ranges::find(contents.solids, name, &StepSolid::name);
        result.named_faces.insert(result.named_faces.end(), next.named_faces.begin(), next.named_faces.end());
        if (result.shape.IsNull()) {
            result.shape = next.shape;
        } else {
            BRepAlgoAPI_Fuse sum(result.shape, next.shape);
            follow(result, sum);
        }
    }
    return result;
}

/// Turns a shape so that the directions of the file that the user names become those of the machine.
void turn(StepSolid& solid, const std::array<Vec3, 3>& axes)
{
    gp_Trsf rotation;
    rotation.SetValues(axes[0][0], axes[0][1], axes[0][2], 0, axes[1][0], axes[1][1], axes[1][2], 0, axes[2][0],
                       axes[2][1], axes[2][2], 0);
    BRepBuilderAPI_Transform work(solid.shape, rotation, true);
    for (NamedFace& named : solid.named_faces) {
        named.face = TopoDS::Face(work.ModifiedShape(named.face));
    }
    solid.shape = work.Shape();
}

/// Keeps what lies below a place along x [mm].
void cut_beyond(StepSolid& solid, double x)
{
    constexpr double far_away = 1e6;
    BRepPrimAPI_MakeBox beyond(gp_Pnt(x, -far_away, -far_away), gp_Pnt(x + far_away, far_away, far_away));
    BRepAlgoAPI_Cut work(solid.shape, beyond.Shape());
    follow(solid, work);
}

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

StepSolid prepared(const ForeignFile& file, const PartDescription& part, const StepSource& source, bool half,
                   double omit, std::vector<std::string>& notes)
{
    StepSolid solid = chosen(file, source, read_step_solids(file, source.unit));
    turn(solid, source.axes);
    if (omit > 0) {
        notes = defeature(solid, omit / gmsh_unit);
    }
    if (half) {
        cut_beyond(solid, -part.translation[0] / gmsh_unit);
    }
    return solid;
}

}  // namespace

PartMesh mesh_step(const PartDescription& part, const StepSource& source, double size, bool half,
                   const Waiting& waiting)
{
    check_step_file(part.name, source.path);
    const ForeignFile file{part.name, source.path, "part.step"};
    const double smallest = source.rules.smallest > 0 ? std::min(source.rules.smallest, size) : size / 3;
    const TetrahedronSize sizes{size, smallest, source.rules.circle_cells, true};
    const auto make = [&] {
        PartMesh mesh;
        guard_gmsh(part.name, "reading and meshing its STEP file", [&] {
            try {
                reset_gmsh();
                std::vector<std::string> notes;
                const StepSolid solid = prepared(file, part, source, half, source.rules.omit.value_or(smallest), notes);
                gmsh::vectorpair tags;
                occ::importShapesNativePointer(&solid.shape, tags, true);
                occ::synchronize();
                name_surfaces(solid.named_faces);
                mesh = mesh_model(part.name, sizes);
                mesh.notes.insert(mesh.notes.begin(), notes.begin(), notes.end());
            } catch (const Standard_Failure& failure) {
                throw std::runtime_error(failure.GetMessageString());
            }
        });
        // The part is moved after meshing, since its position must not change its mesh.
        return to_machine(Frame{{0, 1, 2}, {1, 1, 1}, part.translation}, std::move(mesh));
    };
    return mesh_foreign_file(file, make, waiting);
}

}  // namespace deadpoint::machine
