#pragma once

#include "deadpoint/core/vec.hpp"

#include <vector>

/// Loads of the crankshaft over one turn.
namespace deadpoint::crankshaft {

/// Tension of a belt, or any other force constant in space.
struct SteadyForce {
    double position = 0;  ///< along s [m]
    Vec2 force{};         ///< on the shaft [N]
};

/// Loads of the shaft over one turn of the crank, without its unbalance. All loads are periodic and
/// linear between the given times; the driver's speed is the slope of the angle.
struct ShaftLoads {
    std::vector<double> time;  ///< ascending within one period, of any spacing [s]
    double period = 0;         ///< [s]
    /// Direction of the crank throw from machine x at those times, continuous (no jumps by a turn), running over one
    /// turn in the period; its sense is that of the spin [rad].
    std::vector<double> throw_angle;
    std::vector<Vec2> pin_force;  ///< on the crank by the rod at those times [N]
    double pin_position = 0;      ///< along s [m]
    double pin_width = 0;         ///< over which the pin's force is spread evenly; 0: at one point [m]
    Vec2 gravity{0, -9.81};       ///< [m/s2]
    std::vector<SteadyForce> steady;
    /// Times of the results, evenly spaced over the turn. The response is not linear between them:
    /// they should resolve the excited modes (2880: an eighth of a degree).
    int samples = 2880;
};

}  // namespace deadpoint::crankshaft
