#pragma once

#include <optional>
#include <string>

namespace deadpoint {
struct ThermalHistory;
}
namespace deadpoint::drift {
struct BearingPlay;
}

namespace deadpoint::casefile {
struct Case;
}

/// The play of the crank's bearings, stated by the case or assumed.
namespace deadpoint::press {

struct ChainFigures;

/// Motion of the crank due to the growth of its bearings' clearance: chain.bearing_play. Without
/// it, `limited` by the joint's clearance; if that is not stated, `none` for rolling bearings and
/// `whole` for plain bearings.
drift::BearingPlay crank_play(const casefile::Case& input);

/// A warning if the case states neither the play nor bearing_play: the assumption, and its largest
/// effect on E_SW.
std::optional<std::string> play_warning(const casefile::Case& input, const ChainFigures& chain,
                                        const ThermalHistory& history);

}  // namespace deadpoint::press
