#pragma once

#include "deadpoint/press/result/press_compliance.hpp"

namespace deadpoint::fem {
class Model;
}
namespace deadpoint::press {
struct ChainModel;
struct GapModel;
}  // namespace deadpoint::press

namespace deadpoint::full {

/// Opening of the gap by a force of 1 N that pushes slide and table apart at bottom dead point, by one elastic solve.
///
/// The gap is a functional l of the deformation, u = K^-1 f. By virtual work, the force F on the slide loads each joint
/// with F times the weight w that this joint's shift has in the gap, so that the load on all bodies is F l, and the gap
/// opens by
///
///   F l . K^-1 l     (Castigliano's theorem),    at a corner with the functional l_c by    F l_c . K^-1 l
///
/// The force acts evenly on the face of the slide and on that of the table. A joint receives it as its centre is read,
/// around the circumference by the cosine, pulling on the side that a pin would leave. In: frame, table, slide, links
/// and crankshaft as solids. Left out: clearances, oil films, rolling elements and rings between the bodies of a joint,
/// bolted faces that open, tool and foundation. The result is the largest stiffness that the press may have.
press::PressCompliance press_compliance(fem::Model& model, const press::ChainModel& chain, const press::GapModel& gaps,
                                        bool half_model);

}  // namespace deadpoint::full
