#pragma once

#include "deadpoint/core/vec.hpp"

#include <optional>
#include <string>

/// Which solid of a drawing a part means.
namespace deadpoint {

/// What tells a solid of a drawing from the others whatever their names: figures that every export of the solid keeps.
/// In the coordinates of the file and the unit that it says.
struct SolidPrint {
    double volume = 0;  ///< [m3]; 0 where faces cross each other so that it cancels
    Vec3 size{};        ///< edges of the box around it along x, y and z [m]
    Vec3 centre{};      ///< centre of its volume [m]
};

/// "0.25 L, 100 x 50 x 50 mm at (50, 25, -25) mm": the volume to five digits, lengths to 0.1 um.
std::string text_of(const SolidPrint& print);
/// The figures in such a text; none where it is another text, or a figure is none that a solid can have.
std::optional<SolidPrint> solid_print(const std::string& text);

/// A solid by its name in the file and, where several have one name or names change, by its figures.
struct SolidReference {
    std::string name;         ///< or a pattern with *; empty: the only solid
    std::string fingerprint;  ///< text of a SolidPrint; empty: none
};

/// Both in one text, on two lines where there is a fingerprint: PartDescription and case hold references as texts.
std::string text_of(const SolidReference& reference);
SolidReference solid_reference(const std::string& text);

}  // namespace deadpoint
