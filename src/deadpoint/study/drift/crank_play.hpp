#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/study/drift/chain_model.hpp"

#include <optional>
#include <string>

/// Internal to study/: the play of the crank's bearings, as a case states it or as it is taken.
namespace deadpoint::study {

/// How far the crank follows the growth of its bearings' clearance: chain.bearing_play; without it `limited` by the
/// joint's clearance, or where that is not stated, `none` for rolling bearings and `whole` for plain ones.
drift::BearingPlay crank_play(const casefile::Case& input);

/// Where the case states neither the play nor how it counts: what was taken, and the largest that it makes of E_SW.
std::optional<std::string> play_warning(const casefile::Case& input, const ChainModel& chain,
                                        const ThermalHistory& history);

}  // namespace deadpoint::study
