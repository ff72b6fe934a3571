#pragma once

#include "deadpoint/core/vec.hpp"

#include <optional>
#include <string>

class TopoDS_Shape;

namespace deadpoint::machine {

struct SolidFault {
    std::string what;  ///< "the outline of a face crosses itself"
    Vec3 where{};      ///< [m], in the coordinates of the shape
};

/// The first fault that Open CASCADE finds in a solid: outlines that cross, faces that do not close, edges off their
/// faces. To be called in a confined process only.
std::optional<SolidFault> fault_of(const TopoDS_Shape& solid);

}  // namespace deadpoint::machine
