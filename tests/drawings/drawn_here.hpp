#pragma once

#include <string>

class TopoDS_Shape;

/// Drawings in Open CASCADE's form, as STEP files.
namespace drawings {

/// Writes a STEP file in millimetres.
void write_step(const TopoDS_Shape& shape, const std::string& path);
/// Translates a file of Open CASCADE's own format.
void translate(const std::string& brep, const std::string& path);

/// A plate of 500 mm with ribs of 3 mm.
void ribbed_plate(const std::string& path);
/// A cylinder with twenty discs of 2 mm, 8 mm apart.
void cooled_cylinder(const std::string& path);
/// Two cubes of 200 mm whose common faces miss each other by 50 and 20 um.
void cubes_with_steps(const std::string& path);
/// A plate with 24 countersunk holes.
void plate_with_holes(const std::string& path);

}  // namespace drawings
