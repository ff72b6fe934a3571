#pragma once

#include "deadpoint/core/table.hpp"
#include "deadpoint/exchange/cycle.hpp"

#include <functional>

namespace deadpoint::mechanism {

/// Process force on the slide [N], positive along the stroke direction (up, away from the table), from the angle of the
/// driver past bottom dead point [rad, -pi..pi], the slide's height above bottom dead point [m] and its speed along the
/// stroke [m/s] (negative on the way down).
using ProcessForceLaw = std::function<double(double past_bottom, double height, double slide_speed)>;

struct CycleRequest {
    std::vector<BodyMass> masses;  ///< one per body of the linkage
    std::function<double(double past_bottom)> speed;  ///< of the driver over its angle past bottom dead point [rad/s], > 0
    std::function<double(double past_bottom)> speed_slope;  ///< its derivative by the angle [1/s]; empty: steady speed
    ProcessForceLaw process_force;      ///< empty: none
    double process_force_offset = 0;    ///< of its line of action from the slide point, across the stroke [m]
    Vec2 gravity{0, -9.81};             ///< [m/s2]
    int positions = 720;
};

/// Slide motion near its ends, found from the cycle's geometry.
struct StrokeFigures {
    double stroke = 0;             ///< [m]
    double bottom_dead_point = 0;  ///< angle of the driver from the assembled position [rad]
    double top_dead_point = 0;     ///< [rad]
    double dwell_10um = 0;         ///< share of the turn with the slide within 10 um of bottom dead point
    double dwell_100um = 0;
    double largest_speed = 0;         ///< [m/s]
    double largest_acceleration = 0;  ///< magnitude [m/s2]
};

/// Motion, joint reactions and drive torque over one turn (inverse dynamics):
///   J^T lambda = Q - M q''   with the constraint Jacobian J, lambda the reactions and the drive torque.
CycleHistory analyse_cycle(const Linkage& linkage, const CycleRequest& request);

}  // namespace deadpoint::mechanism
