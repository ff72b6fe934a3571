#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <map>
#include <string>
#include <vector>

namespace deadpoint {
struct CycleHistory;
struct Linkage;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// How far and for how long the slides of a case travel along their guides.
namespace deadpoint::press {

/// Places that stand for a course over time.
inline constexpr int travel_stops = 8;
/// Shorter strokes count as none [m].
inline constexpr double least_stroke = 1e-6;

struct Stop {
    double position = 0;  ///< [m]
    double share = 0;     ///< of the time
};

/// A few places that stand for a course: its time is sorted by position and cut into `count` equal shares, each of
/// which stands at its mean position.
///
/// The mean is kept to rounding. The variance lacks that within the shares, which is at most the square of the widest
/// and falls as 1/count^2: of a motion at constant speed 1/count^2 of it, of a harmonic one 1.3 % with eight.
///
/// @param position  [m]
/// @param share     of the time, > 0, one per position; sums to 1
/// @param count     > 0
std::vector<Stop> condensed(const std::vector<double>& position, const std::vector<double>& share, int count);

/// Place of body_a along the direction of a slide joint, as seen from body_b, at every sample of the turn [m]; 0 where
/// the bodies are drawn. Where the guide leaves its body free to turn, that of the joint's centre.
std::vector<double> displacement(const Linkage& linkage, int joint, const CycleHistory& history);

/// Travel of the slides of a case, by the name of their joint: of its first body against its second.
///
/// Follows from the linkage alone, driven with the speed of [mechanism] over the angle; the level of the speed does not
/// matter. The two ends of the stroke are added with a share of 0, so that the least coverage is that of the whole
/// stroke. Left out are joints without interfaces, with `swept = false`, with `turns_fully`, and those that do not
/// move. Empty where the case has no driver or slide body, or does not run in any segment.
///
/// @throws InputError if the linkage is at fault
std::map<std::string, Travel> describe_travel(const casefile::Case& input, int count = travel_stops);

}  // namespace deadpoint::press
