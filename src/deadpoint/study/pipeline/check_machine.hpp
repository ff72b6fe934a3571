#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <string>
#include <vector>

namespace deadpoint::study {

/// Checks a case against its meshed machine where only the mesh can tell.
/// @throws InputError if probes lie more than half a cell diameter off their parts; all of them are named
void require_probes_on_parts(const casefile::Case& input, const Machine& machine);

/// Surfaces whose temperature is a formula of the place, held against its nodes and the times of the operation.
/// @return a warning for each that is colder than a press can be, as where degC were meant
/// @throws InputError where a formula is not above absolute zero; DomainError where it is not finite
std::vector<std::string> cold_formulas(const casefile::Case& input, const Machine& machine);

/// Bodies that fall into pieces which no bond holds together: each piece would expand by itself. A part may be several
/// pieces; those that meet the same interface of a joint are held by it.
std::vector<std::string> loose_bodies(const Machine& machine);

}  // namespace deadpoint::study
