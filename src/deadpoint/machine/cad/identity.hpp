#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/solid_print.hpp"

#include <string>
#include <vector>

class TopoDS_Shape;

/// Which solid of a drawing a part means: by name, and by figures that every export of the solid keeps.
namespace deadpoint::machine {

/// A solid of a file, as a case can name it.
struct SolidIdentity {
    std::string called;  ///< in the file
    std::string name;    ///< CadSolid::name, by which older cases name it
    SolidPrint fingerprint;
};

/// @param scale  lengths of the shape [mm] over those of the file in the unit that it says
SolidPrint fingerprint_of(const TopoDS_Shape& shape, double scale);

/// Whether two fingerprints can be those of one solid in two exports: volumes within 0.5 %, lengths within 0.2 % of the
/// longest edge. Other versions of a CAD program, units and orders of solids keep to it; tolerances of spline surfaces
/// need it.
bool same_solid(const SolidPrint& one, const SolidPrint& other);

struct ChosenSolids {
    std::vector<std::size_t> solids;  ///< indices, ascending
    std::string doubt;                ///< a sentence where the solid is not as its fingerprint says; mostly empty
};

/// The solids that a part asks for.
///
/// A name is that of the file, then a key that this program made of it, then a pattern with *. Of several solids of one
/// name the fingerprint chooses. A name that is another solid's now is refused, as is one of several solids without a
/// fingerprint: which of them comes first is an accident of the export.
/// @throws InputError naming part, file and the solids in question
ChosenSolids chosen_solids(const std::string& part, const StepSource& source, const std::vector<SolidIdentity>& solids);

}  // namespace deadpoint::machine
