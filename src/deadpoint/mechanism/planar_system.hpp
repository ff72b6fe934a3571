#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <span>
#include <vector>

/// The planar linkage as a system of constraint equations: positions, velocities and accelerations of all bodies for a
/// prescribed angle of the driver.
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

/// Where a point of a body lies that has coordinates `point` in the assembled position [m].
Vec2 place(const PlanarPose& pose, const Vec2& point);
/// Velocity of that point [m/s].
Vec2 velocity_of(const PlanarPose& pose, const PlanarPose& velocity, const Vec2& point);
/// Acceleration of that point [m/s2].
Vec2 acceleration_of(const PlanarPose& pose, const PlanarPose& velocity, const PlanarPose& acceleration,
                     const Vec2& point);

/// Bodies with three coordinates each (translation x, y and angle), held together by constraint equations:
///
///   revolute   p_a - p_b = 0                      2 equations; p: the joint's centre carried by a body
///   slide      n . (p_a - p_b) = 0                1 equation; n: across the direction of travel, carried by body_b
///              angle_a - angle_b = 0              1 more if it guides the rotation
///   driver     angle of the driven body = theta   1 equation
///
/// Positions follow by Newton's method, velocities and accelerations from the same Jacobian (Haug, Computer Aided
/// Kinematics and Dynamics of Mechanical Systems, chapter 3). Left out: play, friction, compliance.
class PlanarSystem {
public:
    /// @throws InputError if an index is wrong, the driver is not a revolute joint on the ground, a body is held by no
    ///         joint, or the linkage is over- or under-constrained in the assembled position; the message names the
    ///         joints and bodies concerned
    explicit PlanarSystem(const Linkage& linkage);

    [[nodiscard]] const Linkage& linkage() const { return linkage_; }
    /// All bodies where the case file has them.
    [[nodiscard]] std::vector<PlanarPose> assembled() const;

    /// Moves the driver from one angle to another in steps of at most two degrees, each closed by Newton's method.
    ///
    /// @param poses   closed at angle `from` [rad], counted from the assembled position
    /// @param shifts  one per joint, or none
    /// @throws InputError if the linkage cannot reach an angle: says which joint stays open and by how much, or where
    ///         it becomes singular
    [[nodiscard]] std::vector<PlanarPose> follow(std::vector<PlanarPose> poses, double from, double to,
                                                 std::span<const CentreShift> shifts = {}) const;

    /// Small motion of every body that closes the joints again when their centres shift, driver held, linear in the
    /// shifts: J dq = d_b - d_a.
    /// @param poses  closed; shifts in the coordinates of the assembled position, one per joint
    /// @throws InputError if the position is singular
    [[nodiscard]] std::vector<PlanarPose> closing_motion(const std::vector<PlanarPose>& poses,
                                                         std::span<const CentreShift> shifts) const;

    /// Velocities and accelerations for a driver that turns with `speed` [rad/s] and `acceleration` [rad/s2].
    /// @throws InputError if the position is singular
    [[nodiscard]] PlanarMotion motion(const std::vector<PlanarPose>& poses, double speed,
                                      double acceleration = 0) const;

    /// Where the joint's centre lies, as carried by its first body [m].
    [[nodiscard]] Vec2 joint_centre(int joint, const std::vector<PlanarPose>& poses) const;

    /// Point of the slide whose travel counts: the centre of the joint that guides it, else the mean of its joints'
    /// centres; in the assembled position [m].
    [[nodiscard]] Vec2 slide_point() const;

    /// Motion of the slide along the stroke direction per unit shift of every joint's centre, driver held: solves
    /// J^T lambda = d(stroke)/dq once; see BottomDeadPointSensitivity for the sign.
    /// @throws InputError if the position is singular
    [[nodiscard]] std::vector<Vec2> slide_weights(const std::vector<PlanarPose>& poses) const;

private:
    Linkage linkage_;
    std::vector<int> first_unknown_;   ///< per body, -1 for the ground
    std::vector<int> first_equation_;  ///< per joint
    int unknowns_ = 0;
    int equations_ = 0;
    int driven_body_ = 0;
    double length_ = 1;  ///< size of the linkage [m]

    struct Algebra;  // the Jacobian and what is done with it
};

}  // namespace deadpoint::mechanism
