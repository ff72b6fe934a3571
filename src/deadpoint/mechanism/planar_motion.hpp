#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <memory>
#include <vector>

/// Positions, motions, loads and reactions of a planar linkage.
namespace deadpoint::mechanism {

/// Shift of a joint's centre as it lies in each of its two bodies, in the coordinates of the assembled position [m].
struct CentreShift {
    Vec2 in_a{};
    Vec2 in_b{};
};

/// Poses of all bodies and their first and second derivatives by time.
struct PlanarMotion {
    std::vector<PlanarPose> poses;
    std::vector<PlanarPose> velocities;     ///< [m/s], [rad/s]
    std::vector<PlanarPose> accelerations;  ///< [m/s2], [rad/s2]
};

/// A closed position: poses of the bodies and their derivatives by the driver's angle.
struct PlanarPosition {
    struct Factors;                          ///< of the Jacobian here; internal
    double angle = 0;                        ///< of the driver [rad]
    std::vector<PlanarPose> poses;           ///< per body
    std::vector<PlanarPose> slopes;          ///< first derivative of the poses by that angle [m], [-]
    std::vector<PlanarPose> curvatures;      ///< second derivative [m], [-]
    std::shared_ptr<const Factors> factors;  ///< shared by copies, since it never changes
};

/// Load on a body besides its joints; an inertia force (-m a) counts as a load.
struct PlanarLoad {
    Vec2 force{};       ///< [N]
    double moment = 0;  ///< about the body's own origin, which lies at the translation of its pose [N m]

    PlanarLoad& operator+=(const PlanarLoad& other)
    {
        force = force + other.force;
        moment += other.moment;
        return *this;
    }
};

/// Reactions of the joints and the drive.
struct PlanarReactions {
    std::vector<Vec2> force;     ///< on body_a by body_b at the joint's centre, in machine coordinates, per joint [N]
    std::vector<double> moment;  ///< on body_a by body_b; not zero only where a slide guides rotation [N m]
    double drive_torque = 0;     ///< on the driven body, counter-clockwise [N m]
};

/// Position of the point of a body whose coordinates in the assembled position are `point` [m].
Vec2 place(const PlanarPose& pose, const Vec2& point);
/// Velocity of that point [m/s].
Vec2 velocity_of(const PlanarPose& pose, const PlanarPose& velocity, const Vec2& point);
/// Acceleration of that point [m/s2].
Vec2 acceleration_of(const PlanarPose& pose, const PlanarPose& velocity, const PlanarPose& acceleration,
                     const Vec2& point);
/// The load on a body of a force through a point of the machine [N], [m].
PlanarLoad load_of(const PlanarPose& pose, const Vec2& force, const Vec2& point);

/// Velocities and accelerations for a driver that turns with `speed` [rad/s] and `acceleration` [rad/s2]:
/// v = q' w and a = q'' w^2 + q' alpha, with q' and q'' the slopes and curvatures.
PlanarMotion motion_at(const PlanarPosition& position, double speed, double acceleration = 0);

}  // namespace deadpoint::mechanism
