#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <memory>
#include <string>
#include <vector>

/// What can be drawn of a case that may still be wrong.
namespace deadpoint::press {

/// A face that the case asks for, as its keys state it, whether it exists or not.
struct SoughtFace {
    std::string path;  ///< "surfaces.table", "joints.crank_pin.interfaces.bush.a"
    SurfaceSelector selector;
};

struct CaseSketch {
    std::shared_ptr<const Machine> machine;  ///< null where the case has no parts
    DecimatedSurface surface;                ///< of the machine, to draw
    std::vector<InterfaceFaces> interfaces;  ///< of joints; also those that were refused
    std::vector<SoughtFace> sought;          ///< of surfaces and interfaces that are not in the machine
    std::vector<Diagnostic> missing;         ///< why things are not there
};

}  // namespace deadpoint::press
