#pragma once

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
struct Finding;
}  // namespace deadpoint::casefile

namespace deadpoint::press {

/// Checks a case against its mesh.
/// @throws CaseError with all probes that lie more than half a cell diameter off their parts
void require_probes_on_parts(const casefile::Case& input, const Machine& machine);

/// Evaluates temperature formulas of surfaces at their nodes and at the times of the operation.
/// @return a warning for each that is colder than a press can be, probably since degC were meant
/// @throws CaseError where formulas are not above absolute zero; CaseDomainError where they are not finite
std::vector<std::string> cold_formulas(const casefile::Case& input, const Machine& machine);

/// Bodies of several pieces without a bond between them: each piece would expand separately. A part
/// may be several pieces; those that meet the same interface of a joint are held by it. Says how far off the nearest
/// other part is, by the boxes around the parts.
std::vector<casefile::Finding> loose_bodies(const Machine& machine);

}  // namespace deadpoint::press
