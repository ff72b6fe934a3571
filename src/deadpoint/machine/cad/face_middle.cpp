#include "deadpoint/machine/cad/face_middle.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>

namespace deadpoint::machine {

FaceMiddle middle_of(const TopoDS_Face& face)
{
    const BRepAdaptor_Surface surface(face);
    double u[2]{};
    double v[2]{};
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    FaceMiddle middle;
    gp_Vec along_u;
    gp_Vec along_v;
    surface.D1(0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1]), middle.point, along_u, along_v);
    middle.out = (face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0) * along_u.Crossed(along_v);
    return middle;
}

}  // namespace deadpoint::machine
