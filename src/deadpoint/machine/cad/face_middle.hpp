#pragma once

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace deadpoint::machine {

/// A point of a face in the middle of its parameters, and the direction out of the solid there, of any length.
struct FaceMiddle {
    gp_Pnt point;
    gp_Vec out;
};

FaceMiddle middle_of(const TopoDS_Face& face);

}  // namespace deadpoint::machine
