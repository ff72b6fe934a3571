#pragma once

#include "deadpoint/heat/system.hpp"

#include <string>
#include <vector>

namespace deadpoint::heat {
struct HeatBalance;
}

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

namespace deadpoint::heat {

class JointBalance;

/// A number with six digits, for messages.
std::string short_text(double value);

/// The largest term of a heat balance in words: the heat of each quantity of the case for one
/// kelvin, or at the present temperatures. A term that is not finite counts as the largest. The
/// text names the key behind a failed solve.
/// @param of_system terms of the matrices
/// @param balance    at temperatures that are finite
std::string largest_term(const HeatProblem& problem, const HeatSegment& segment, const HeatGeometry& geometry,
                         const JointBalance& joints, const HeatBalance& balance, double time,
                         std::vector<Term> of_system);

}  // namespace deadpoint::heat
