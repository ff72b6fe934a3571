#pragma once

#include "deadpoint/core/vec.hpp"

#include <vector>

/// Loads of a turn on a uniform grid of times, for the rigid and the flexible model.
namespace deadpoint::crankshaft {

struct Shaft;
struct ShaftLoads;
struct Unbalance;

/// Time-dependent loads, at ShaftLoads::samples uniformly spaced times.
struct TurnLoads {
    double speed = 0;             ///< mean, positive from x to y [rad/s]
    std::vector<double> time;     ///< [s]
    std::vector<Vec2> pin_force;  ///< [N]
    /// Force of an unbalance of 1 kg m at the throw: theta'^2 e_r - theta'' e_t [N/(kg m)].
    std::vector<Vec2> unbalance;
};

/// Nodes the loads need [m].
std::vector<double> load_positions(const ShaftLoads& loads);

/// Checks and resamples the loads.
/// @throws InputError if they are incomplete, not finite, not in order or do not turn by one turn per period
TurnLoads resample(const ShaftLoads& loads);

/// Throw and disks.
std::vector<Unbalance> unbalances_of(const Shaft& shaft);

/// An unbalance's force, turned from the throw's to its own direction and multiplied with its magnitude.
Vec2 force_of(const Unbalance& unbalance, const Vec2& at_throw);

}  // namespace deadpoint::crankshaft
