#pragma once

#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"

#include <vector>

namespace deadpoint {
class Observer;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Operation at other speeds and forces, for which a reduced model is built.
namespace deadpoint::twin {

/// The case at factors on speed and process force of its whole operation: the corners of their ranges, then drawn ones.
/// Nothing if both are from 1 to 1.
/// @throws CaseError, CaseDomainError of a case that cannot be at one of them
std::vector<SplitProblem> other_operation(const casefile::Case& input, const Machine& machine, const FreeRanges& ranges,
                                          const Observer& observer);

/// The problem, and then the same with the friction heat of each of the others.
std::vector<HeatProblem> with_heat_of(const HeatProblem& problem, const std::vector<SplitProblem>& others);

}  // namespace deadpoint::twin
