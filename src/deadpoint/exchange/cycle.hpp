#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/linkage.hpp"

#include <string>
#include <vector>

/// Motion, joint forces and bearing loads over one turn of the crank, not averaged.
namespace deadpoint {

/// Mass of a body of the linkage; of the ground and of massless bodies all zero.
struct BodyMass {
    double mass = 0;     ///< [kg]
    Vec2 centre{};       ///< of mass, in machine coordinates as assembled in the case file [m]
    double inertia = 0;  ///< about the centre of mass [kg m2]
};

/// Motion of a body over the turn, one entry per crank position.
struct BodyCycle {
    std::vector<PlanarPose> pose;
    std::vector<PlanarPose> velocity;      ///< of the pose [m/s], [rad/s]
    std::vector<PlanarPose> acceleration;  ///< [m/s2], [rad/s2]
};

/// Load and sliding speed of a joint over the turn, one entry per crank position.
struct JointCycle {
    std::vector<Vec2> centre;  ///< as carried by body_a [m]
    std::vector<Vec2> force;   ///< net, on body_a by body_b, at the centre, in machine coordinates [N]
    std::vector<double>
        moment;  ///< on body_a by body_b, about the centre [N m]; not zero only where it guides rotation
    std::vector<double> sliding;  ///< revolute: speed of a relative to b [rad/s]; slide: along its direction [m/s]
};

/// One turn of the crank at steady state, at crank positions evenly spaced from bottom dead point on.
struct CycleHistory {
    std::vector<double> angle;        ///< of the driver, from the assembled position, ascending over one turn [rad]
    std::vector<double> time;         ///< from the first position [s]
    std::vector<double> speed;        ///< of the driver [rad/s]
    double period = 0;                ///< [s]
    std::vector<BodyCycle> bodies;    ///< as in Linkage::bodies
    std::vector<JointCycle> joints;   ///< as in Linkage::joints
    std::vector<double> height;       ///< of the slide above bottom dead point, along the stroke [m]
    std::vector<double> slide_speed;  ///< along the stroke [m/s]
    std::vector<double> slide_acceleration;  ///< [m/s2]
    std::vector<double> process_force;       ///< on the slide, along the stroke (up) [N]
    std::vector<double> drive_torque;        ///< on the driven body, counter-clockwise [N m]
};

/// Loads of the crankshaft's bearings over the turn, one series per bearing, at the times of a uniform grid.
///
/// x and y are machine coordinates (y up). The force is that on the bearing by the shaft.
struct BearingCycle {
    std::string name;
    std::vector<Vec2> force;    ///< [N]
    double peak = 0;            ///< of the magnitude [N]
    Vec2 peak_x_y{};            ///< largest magnitude of each component [N]
    Vec2 mean{};                ///< of the force [N]
    double mean_magnitude = 0;  ///< [N]
    double rms = 0;             ///< of the magnitude [N]
    /// Mean of F^1.33 [N^1.33], to which the load part of rolling friction is proportional
    /// (rolling_load_exponent).
    double mean_rolling_load = 0;
};

}  // namespace deadpoint
