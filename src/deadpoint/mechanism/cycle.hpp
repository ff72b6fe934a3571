#pragma once

#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/mechanism/process_force.hpp"

#include <functional>
#include <vector>

namespace deadpoint {
struct Linkage;
}

namespace deadpoint::mechanism {

/// Drive and loads of the linkage over one turn.
struct CycleRequest {
    /// One per body of the linkage. A body may be without mass if its inertia is zero too (a massless link); a body
    /// with mass needs an inertia > 0 if its rotation speeds up or slows down anywhere in the turn. The ground's is
    /// ignored.
    std::vector<BodyMass> masses;
    std::function<double(double past_bottom)> speed;        ///< of the driver, counter-clockwise, > 0 [rad/s]
    std::function<double(double past_bottom)> speed_slope;  ///< its derivative by the angle [1/s]; empty: steady speed
    std::vector<double> speed_breaks;  ///< angles past bottom dead point where a higher derivative jumps [rad]
    ProcessForceLaw process_force;     ///< empty: none
    double process_force_offset = 0;   ///< of its line of action from the slide point, to the right of the stroke [m]
    Vec2 gravity{0, -9.81};            ///< [m/s2]
    int positions = 720;               ///< at least 4
};

/// Motion, joint reactions and drive torque over one turn of the driver (inverse dynamics).
///
/// Positions are evenly spaced in the driver's angle theta from bottom dead point on, each closed from the one before.
/// With the speed w(theta) the driver's acceleration is w dw/dtheta. The reactions follow from
///
///   J^T lambda = Q - M q''
///
/// with the constraint Jacobian J, the weight and the process force in Q, the masses M, and lambda the forces in the
/// joints and the drive torque, which is the last of them. The process force acts along the stroke on the line that
/// passes the slide point (PlanarSystem::slide_point) at the stated offset, positive to the right of the stroke's
/// direction (for a stroke that points up: towards +x); an eccentric load thus appears in the guides.
///
/// The time is the integral of d theta / w, by Gauss's rule with eight points on pieces of at most two degrees that end
/// at `speed_breaks`: exact to rounding for a speed that is smooth between them. Sums of the history over its positions
/// times 2 pi / positions are integrals over the turn (the trapezoid rule of a periodic function).
///
/// Left out: friction in the joints, play, elasticity. A driver that turns clockwise: mirror the linkage.
///
/// @throws InputError if the linkage is at fault (see PlanarSystem and bottom_dead_point), a mass or inertia is
///         negative, not finite, or missing where it is needed, there are fewer than four positions, or the speed is
///         not positive somewhere or varies without its derivative
/// @throws DomainError if the process force or the derivative of the speed is not finite
CycleHistory analyse_cycle(const Linkage& linkage, const CycleRequest& request);

/// Slide motion near its ends and the largest values in between.
struct StrokeFigures {
    double stroke = 0;             ///< [m]
    double bottom_dead_point = 0;  ///< angle of the driver from the assembled position [rad]
    double top_dead_point = 0;     ///< between bottom dead point and one turn later [rad]
    double dwell_10um = 0;     ///< share of the turn (of the driver's angle) with the slide within 10 um of bottom dead
                               ///< point
    double dwell_100um = 0;    ///< same for 100 um
    double largest_speed = 0;  ///< magnitude along the stroke [m/s]
    double largest_acceleration = 0;  ///< magnitude along the stroke [m/s2]
};

/// Finds the figures from the linkage itself, not from the samples: the dead points as zeros of the
/// slide's velocity to 1e-12 rad, the ends of the dwell to 1e-12 rad, the largest values to
/// rounding. The history gives the starting points, so it must have a sample near each of them.
/// @param history  of the same linkage and request
StrokeFigures stroke_figures(const Linkage& linkage, const CycleRequest& request, const CycleHistory& history);

/// Torque and power of the drive.
struct DriveFigures {
    double mean_power = 0;   ///< work of the drive over the turn by the period [W]
    double mean_torque = 0;  ///< over time [N m]
    double rms_torque = 0;   ///< over time [N m]
    double peak_torque = 0;  ///< largest magnitude at a sample [N m]
};
DriveFigures drive_figures(const CycleHistory& history);

/// Ratio of slide force and crank load, without friction and inertia, at one position.
struct ForceRatio {
    double past_bottom = 0;      ///< angle of the driver past bottom dead point, -pi..pi [rad]
    double height = 0;           ///< of the slide above bottom dead point [m]
    double force_by_torque = 0;  ///< slide force by drive torque, w / |v| = |d theta / d height| [1/m]
    double advantage = 0;        ///< slide force by tangential force at the crank pin, r w / |v| [-]
};

/// Mechanical advantage over the turn: the force that the slide exerts along the stroke per force at the crank pin
/// across the throw, F_slide / F_pin = r w / |v|, from equal power (the usual definition for presses: Tschaetsch, Metal
/// Forming Practise, tangential force diagram). r is the distance of the crank pin from the driver's axis; of several
/// joints on the driven body the furthest counts. Positions where the slide stands (the dead points), at which the
/// ratio has no bound, are left out.
std::vector<ForceRatio> force_ratios(const Linkage& linkage, const CycleHistory& history);

}  // namespace deadpoint::mechanism
