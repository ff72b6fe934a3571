#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/assembly/sketch.hpp"

#include <memory>
#include <string>
#include <vector>

namespace deadpoint {
class MeshedParts;
class Observer;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// What can be drawn of a case that may still be wrong.
namespace deadpoint::study {

/// A face that the case asks for, as its keys state it, whether it exists or not.
struct SoughtFace {
    std::string path;  ///< "surfaces.table", "joints.crank_pin.interfaces.bush.a"
    SurfaceSelector selector;
};

struct CaseSketch {
    std::shared_ptr<const Machine> machine;           ///< null where the case has no parts
    std::vector<machine::InterfaceFaces> interfaces;  ///< of joints; also those that were refused
    std::vector<SoughtFace> sought;                   ///< of surfaces and interfaces that are not in the machine
    std::vector<Diagnostic> missing;                  ///< why things are not there
};

/// All that can be built of a case, part by part. Mistakes are kept, not thrown.
/// @param size_scale  of the cells, > 0
/// @param kept        meshes of parts that an earlier attempt at this case has made
CaseSketch sketch_case(const casefile::Case& input, double size_scale, Observer& observer, MeshedParts& kept);

/// The sketch of a case that is meshed; it refers to the machine.
CaseSketch sketch_of(const Machine& machine);

}  // namespace deadpoint::study
