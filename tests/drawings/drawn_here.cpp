#include "drawn_here.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>

#include <stdexcept>

namespace drawings {
namespace {

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz)
{
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape cylinder(double x, double y, double z, double radius, double height)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius, height).Shape();
}

TopoDS_Shape joined(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }
TopoDS_Shape without(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }

}  // namespace

void write_step(const TopoDS_Shape& shape, const std::string& path)
{
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone ||
        writer.Write(path.c_str()) != IFSelect_RetDone) {
        throw std::runtime_error("cannot write " + path);
    }
}

void translate(const std::string& brep, const std::string& path)
{
    TopoDS_Shape shape;
    if (!BRepTools::Read(shape, brep.c_str(), BRep_Builder())) {
        throw std::runtime_error("cannot read " + brep);
    }
    write_step(shape, path);
}

void ribbed_plate(const std::string& path)
{
    TopoDS_Shape plate = box(0, 0, 0, 500, 500, 15);
    for (int i = 0; i < 5; ++i) {
        plate = joined(plate, box(20 + 114 * i, 10, 15, 3, 480, 60));
    }
    for (int i = 0; i < 3; ++i) {
        plate = joined(plate, box(10, 60 + 180 * i, 15, 480, 3, 60));
    }
    write_step(plate, path);
}

void cooled_cylinder(const std::string& path)
{
    TopoDS_Shape body = cylinder(0, 0, 0, 20, 200);
    for (int i = 0; i < 20; ++i) {
        body = joined(body, cylinder(0, 0, 5 + 9.7 * i, 60, 2));
    }
    write_step(body, path);
}

void cubes_with_steps(const std::string& path)
{
    write_step(joined(box(0, 0, 0, 200, 200, 200), box(200, 0.05, 0.02, 200, 200, 200)), path);
}

void plate_with_holes(const std::string& path)
{
    TopoDS_Shape plate = box(0, 0, 0, 360, 240, 20);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double x = 40 + 55 * i;
            const double y = 30 + 60 * j;
            plate = without(plate, cylinder(x, y, 0, 4.5, 20));
            plate = without(plate, BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(x, y, 15.5), gp::DZ()), 4.5, 9, 4.5).Shape());
        }
    }
    write_step(plate, path);
}

}  // namespace drawings
