#include "deadpoint/machine/cad/solid_fault.hpp"

#include "deadpoint/machine/parts/gmsh_session.hpp"
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListIteratorOfListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <array>

namespace deadpoint::machine {
namespace {

std::string in_words(BRepCheck_Status status)
{
    switch (status) {
    case BRepCheck_SelfIntersectingWire:
        return "the outline of a face crosses itself";
    case BRepCheck_IntersectingWires:
        return "two outlines of a face cross each other";
    case BRepCheck_NotClosed:
    case BRepCheck_NotConnected:
    case BRepCheck_FreeEdge:
        return "its faces do not close";
    case BRepCheck_BadOrientation:
    case BRepCheck_BadOrientationOfSubshape:
    case BRepCheck_UnorientableShape:
        return "a face is turned inside out";
    case BRepCheck_InvalidMultiConnexity:
        return "more than two faces meet at an edge";
    case BRepCheck_InvalidDegeneratedFlag:
    case BRepCheck_InvalidRange:
        return "an edge has no length";
    default:
        return "an edge or a corner does not lie on its face";
    }
}

Vec3 centre_of_box(const TopoDS_Shape& shape)
{
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    if (box.IsVoid()) {
        return {};
    }
    const gp_Pnt low = box.CornerMin();
    const gp_Pnt high = box.CornerMax();
    return 0.5 * gmsh_unit * Vec3{low.X() + high.X(), low.Y() + high.Y(), low.Z() + high.Z()};
}

/// The first status of a shape that is none, in its own right or within what holds it.
BRepCheck_Status status_of(const BRepCheck_Analyzer& check, const TopoDS_Shape& shape)
{
    const auto worst = [](const BRepCheck_ListOfStatus& all) {
        for (BRepCheck_ListIteratorOfListOfStatus status(all); status.More(); status.Next()) {
            if (status.Value() != BRepCheck_NoError) {
                return status.Value();
            }
        }
        return BRepCheck_NoError;
    };
    const Handle(BRepCheck_Result)& result = check.Result(shape);
    if (result.IsNull()) {
        return BRepCheck_NoError;
    }
    BRepCheck_Status found = worst(result->Status());
    for (result->InitContextIterator(); found == BRepCheck_NoError && result->MoreShapeInContext();
         result->NextShapeInContext()) {
        found = worst(result->StatusOnShape());
    }
    return found;
}

}  // namespace

std::optional<SolidFault> fault_of(const TopoDS_Shape& solid)
{
    const BRepCheck_Analyzer check(solid);
    if (check.IsValid()) {
        return std::nullopt;
    }
    for (const auto kind : {TopAbs_WIRE, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX, TopAbs_SHELL, TopAbs_SOLID}) {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(solid, kind, shapes);
        for (int i = 1; i <= shapes.Extent(); ++i) {
            if (const auto status = status_of(check, shapes.FindKey(i)); status != BRepCheck_NoError) {
                return SolidFault{in_words(status), centre_of_box(shapes.FindKey(i))};
            }
        }
    }
    return SolidFault{"Open CASCADE finds it unsound", centre_of_box(solid)};
}

}  // namespace deadpoint::machine
