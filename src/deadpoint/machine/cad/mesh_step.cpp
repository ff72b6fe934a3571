#include "deadpoint/machine/cad/ready_solid.hpp"
#include "deadpoint/machine/cad/step_solids.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
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

}  // namespace

PartMesh mesh_step(const PartDescription& part, const StepSource& source, double size, bool half,
                   const Waiting& waiting)
{
    check_step_file(part.name, source.path);
    const ForeignFile file{part.name, source.path, "part.step"};
    const double smallest = source.rules.smallest > 0 ? std::min(source.rules.smallest, size) : size / 3;
    const TetrahedronSize sizes{size, smallest, source.rules.circle_cells, true};
    const ReadySolid solid =
        ready_solid(file, source, {source.rules.omit.value_or(smallest), half, part.translation[0]}, waiting);
    const auto make = [&] {
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
            }
        });
        // The part is moved after meshing, since its position must not change its mesh.
        return to_machine(Frame{{0, 1, 2}, {1, 1, 1}, part.translation}, std::move(mesh));
    };
    return mesh_foreign_file(file, make, waiting);
}

}  // namespace deadpoint::machine
