#include "deadpoint/machine/cad/describe_cad.hpp"

#include "deadpoint/machine/cad/face_middle.hpp"
#include "deadpoint/machine/cad/identity.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>

#include <algorithm>
#include <numbers>

namespace deadpoint::machine {
namespace {

constexpr double chord_angle = std::numbers::pi / 30;

Vec3 vector_of(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }
Vec3 metres(const gp_Pnt& p) { return {p.X() * gmsh_unit, p.Y() * gmsh_unit, p.Z() * gmsh_unit}; }

std::vector<Vec3> points_along(const TopoDS_Edge& edge)
{
    std::vector<Vec3> points;
    if (BRep_Tool::Degenerated(edge)) {
        return points;
    }
    const BRepAdaptor_Curve curve(edge);
    constexpr double no_limit = 1e6;
    const GCPnts_TangentialDeflection samples(curve, chord_angle, no_limit);
    for (int i = 1; i <= samples.NbPoints(); ++i) {
        points.push_back(metres(samples.Value(i)));
    }
    if (edge.Orientation() == TopAbs_REVERSED) {
        std::ranges::reverse(points);
    }
    return points;
}

std::vector<Vec3> loop_of(const TopoDS_Wire& wire, const TopoDS_Face& face)
{
    std::vector<Vec3> loop;
    for (BRepTools_WireExplorer edge(wire, face); edge.More(); edge.Next()) {
        std::vector<Vec3> points = points_along(edge.Current());
        if (!points.empty()) {
            points.pop_back();  // the next edge begins with it
        }
        loop.insert(loop.end(), points.begin(), points.end());
    }
    return loop;
}

CadPlane plane_of(const BRepAdaptor_Surface& surface, const TopoDS_Face& face)
{
    CadPlane plane;
    const gp_Pln geometry = surface.Plane();
    const gp_Ax3& frame = geometry.Position();
    const bool flipped = (face.Orientation() == TopAbs_REVERSED) != !frame.Direct();
    plane.normal = (flipped ? -1.0 : 1.0) * vector_of(frame.Direction());
    plane.offset = dot(plane.normal, metres(geometry.Location()));
    const TopoDS_Wire outline = BRepTools::OuterWire(face);
    plane.loops.push_back(loop_of(outline, face));
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
        if (!wire.Current().IsSame(outline)) {
            plane.loops.push_back(loop_of(TopoDS::Wire(wire.Current()), face));
        }
    }
    return plane;
}

/// Whether the solid lies on the far side of a face, seen from a direction in its middle.
bool faces_back(const FaceMiddle& middle, const Vec3& from_centre)
{
    return dot({middle.out.X(), middle.out.Y(), middle.out.Z()}, from_centre) < 0;
}

CadCylinder cylinder_of(const BRepAdaptor_Surface& surface, const TopoDS_Face& face)
{
    CadCylinder result;
    const gp_Cylinder geometry = surface.Cylinder();
    const gp_Ax3& frame = geometry.Position();
    result.point = metres(geometry.Location());
    result.axis = vector_of(frame.Direction());
    result.across = vector_of(frame.XDirection());
    result.radius = geometry.Radius() * gmsh_unit;
    double u[2]{};
    double v[2]{};
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    // A left-handed frame turns the other way.
    result.angles = frame.Direct() ? std::array{u[0], u[1]} : std::array{-u[1], -u[0]};
    result.range = {v[0] * gmsh_unit, v[1] * gmsh_unit};
    const FaceMiddle middle = middle_of(face);
    const Vec3 from_axis = metres(middle.point) - result.point;
    result.bore = faces_back(middle, from_axis - dot(from_axis, result.axis) * result.axis);
    return result;
}

CadSphere sphere_of(const BRepAdaptor_Surface& surface, const TopoDS_Face& face)
{
    const gp_Sphere geometry = surface.Sphere();
    CadSphere sphere{metres(geometry.Location()), geometry.Radius() * gmsh_unit};
    const FaceMiddle middle = middle_of(face);
    sphere.hollow = faces_back(middle, metres(middle.point) - sphere.centre);
    return sphere;
}

CadFace face_of_cad(const TopoDS_Face& face)
{
    CadFace result;
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    result.area = area.Mass() * gmsh_unit * gmsh_unit;
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() == GeomAbs_Plane) {
        result.form = plane_of(surface, face);
    } else if (surface.GetType() == GeomAbs_Cylinder) {
        result.form = cylinder_of(surface, face);
    } else if (surface.GetType() == GeomAbs_Sphere) {
        result.form = sphere_of(surface, face);
    }
    return result;
}

BoxShape bounds_of_shape(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    return {metres(box.CornerMin()), metres(box.CornerMax())};
}

CadSolid solid_of(const StepSolid& solid, double scale)
{
    CadSolid result{solid.name, solid.path, solid.colour, 0, bounds_of_shape(solid.shape), {}};
    result.called = solid.called;
    result.fingerprint = fingerprint_of(solid.shape, scale);
    GProp_GProps volume;
    BRepGProp::VolumeProperties(solid.shape, volume);
    result.volume = volume.Mass() * gmsh_unit * gmsh_unit * gmsh_unit;
    for (TopExp_Explorer face(solid.shape, TopAbs_FACE); face.More(); face.Next()) {
        CadFace one = face_of_cad(TopoDS::Face(face.Current()));
        for (const NamedFace& named : solid.named_faces) {
            if (named.face.IsSame(face.Current())) {
                one.name = named.name;
            }
        }
        result.faces.push_back(std::move(one));
    }
    return result;
}

}  // namespace

CadModel describe_cad(const StepContents& contents)
{
    CadModel model{contents.unit, contents.scale, {}, contents.without_solid};
    for (const StepSolid& solid : contents.solids) {
        model.solids.push_back(solid_of(solid, contents.scale));
    }
    return model;
}

}  // namespace deadpoint::machine
