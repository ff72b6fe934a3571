#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/geometry/foreign_mesh.hpp"
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Solids of a STEP file as Open CASCADE has them, in millimetres. To be called in a confined process only.
namespace deadpoint::machine {

struct NamedFace {
    TopoDS_Face face;
    std::string name;
};

struct StepSolid {
    std::string called;  ///< in the file, where several may have one name; empty: it has none
    std::string name;    ///< made of it, unique in the file, to be a key of a case
    std::string path;
    std::string colour;
    TopoDS_Shape shape;
    std::vector<NamedFace> named_faces;
};

struct StepContents {
    std::string unit;
    double scale = 1;  ///< applied to the lengths, beyond the file's own unit
    std::vector<StepSolid> solids;
    std::vector<std::string> without_solid;
};

/// The error of a file at whose contents Open CASCADE gives up.
InputError unreadable(const ForeignFile& file);

/// @param letters  how the file writes names
/// @param unit     length of one unit of the file [m]; none: what the file says
/// @throws InputError if the file cannot be understood, or its unit is unknown and none is stated
StepContents read_step_solids(const ForeignFile& file, StepLetters letters, std::optional<double> unit);

}  // namespace deadpoint::machine
