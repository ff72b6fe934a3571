#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/heat/system.hpp"

#include <string>
#include <vector>

namespace deadpoint::heat {

/// A number with six digits, for messages.
std::string short_text(double value);

/// The largest term of a heat balance in words: what each quantity of the case comes to for a kelvin, or at the present
/// temperatures. One that is not finite counts as the largest. It names the key behind a solve that failed.
/// @param of_system  what the matrices consist of
/// @param balance    at temperatures that are finite
std::string largest_term(const HeatProblem& problem, const HeatSegment& segment, const HeatGeometry& geometry,
                         const JointBalance& joints, const HeatBalance& balance, double time,
                         std::vector<Term> of_system);

}  // namespace deadpoint::heat
