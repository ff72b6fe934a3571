#pragma once

#include "deadpoint/press/check/case_sketch.hpp"

namespace deadpoint {
class MeshedParts;
class Observer;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// What can be drawn of a case that may still be wrong.
namespace deadpoint::full {

/// All that can be built of a case, part by part. Mistakes are kept, not thrown.
/// @param size_scale  of the cells, > 0
/// @param kept        meshes of parts that an earlier attempt at this case has made
press::CaseSketch sketch_case(const casefile::Case& input, double size_scale, Observer& observer, MeshedParts& kept);

/// The sketch of a case that is meshed; it refers to the machine.
press::CaseSketch sketch_of(const Machine& machine);

}  // namespace deadpoint::full
