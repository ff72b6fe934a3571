#pragma once

#include "deadpoint/reduce/sensitivity/heat_scalars.hpp"

namespace deadpoint::reduce {

struct Direction;
class LinearisedHeat;
struct LinearisedState;

/// (more - less) / by of the scalars that change over a segment's time or with its temperatures, at one time: what
/// films face, prescribed fluxes, other heat, laws of friction heat and of films, ambient, power in enclosures.
ScalarChanges passing_changes(const Direction& direction, const LinearisedHeat& heat, const LinearisedState& at);

}  // namespace deadpoint::reduce
