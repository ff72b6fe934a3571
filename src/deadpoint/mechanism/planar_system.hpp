#pragma once

#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/mechanism/planar_layout.hpp"
#include "deadpoint/mechanism/planar_motion.hpp"

#include <span>
#include <vector>

/// The planar linkage as a system of constraint equations: positions, velocities and accelerations of all bodies for a
/// prescribed angle of the driver, and the forces in its joints.
namespace deadpoint::mechanism {

/// Bodies with three coordinates each (translation x, y and angle), held together by constraint equations:
///
///   revolute   p_a - p_b = 0                      2 equations; p: the joint's centre carried by a body
///   slide      n . (p_a - p_b) = 0                1 equation; n: across the direction of travel, carried by body_b
///              angle_a - angle_b = 0              1 more if it guides the rotation
///   driver     angle of the driven body = theta   1 equation
///
/// Positions follow by Newton's method, their derivatives and the reactions from the same Jacobian, which is factored
/// once per position (Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, chapters 3 and 6).
/// Left out: play, friction, compliance.
class PlanarSystem {
public:
    /// @throws InputError if a number is not finite, an index is wrong, the driver is not a revolute joint on the
    ///         ground, a body is held by no joint, or the linkage is over- or under-constrained in the assembled
    ///         position; the message names the joints and bodies concerned, the rank, and what to free
    explicit PlanarSystem(const Linkage& linkage);

    [[nodiscard]] const Linkage& linkage() const { return layout_.linkage; }
    /// Poses of all bodies at the assembled position of the case file.
    [[nodiscard]] std::vector<PlanarPose> assembled() const;

    /// The closed position with these poses; the driver's angle is that of its body.
    /// @throws InputError if it is singular
    [[nodiscard]] PlanarPosition position(std::vector<PlanarPose> poses) const;

    /// Turns the driver to another angle [rad] in steps of at most two degrees, each predicted to
    /// second order and closed by Newton's method. The sign of the Jacobian's determinant must not
    /// change on the way, so that the linkage stays in its assembly mode.
    /// @throws InputError if the linkage cannot close on the way: says from which angle to which, and which joint stays
    ///         open by how much when all others are closed; or if it passes a singular position
    [[nodiscard]] PlanarPosition moved(const PlanarPosition& from, double to) const;

    /// As `moved`, for joints whose centres have shifted, from poses that need not be closed.
    ///
    /// @param poses   closed (without the shifts) at angle `from` [rad], counted from the assembled position
    /// @param shifts  one per joint, or none
    [[nodiscard]] std::vector<PlanarPose> follow(std::vector<PlanarPose> poses, double from, double to,
                                                 std::span<const CentreShift> shifts = {}) const;

    /// Small motion of every body that closes the joints again when their centres shift, driver held, linear in the
    /// shifts: J dq = d_b - d_a.
    /// @param poses  closed; shifts in the coordinates of the assembled position, one per joint
    /// @throws InputError if the position is singular
    [[nodiscard]] std::vector<PlanarPose> closing_motion(const std::vector<PlanarPose>& poses,
                                                         std::span<const CentreShift> shifts) const;

    /// `motion_at` of the closed position with these poses.
    /// @throws InputError if the position is singular
    [[nodiscard]] PlanarMotion motion(const std::vector<PlanarPose>& poses, double speed,
                                      double acceleration = 0) const;

    /// Reactions that balance the loads: J^T lambda = Q, where Q holds force and moment of every body's load and
    /// -lambda is what the joints put on their first bodies. The force of a slide acts across its travel, at the
    /// centre that body_a carries.
    /// @param loads  one per body; that on the ground is ignored
    [[nodiscard]] PlanarReactions reactions(const PlanarPosition& position, std::span<const PlanarLoad> loads) const;

    /// Centre of the joint, as carried by its first body [m].
    [[nodiscard]] Vec2 joint_centre(int joint, const std::vector<PlanarPose>& poses) const;

    /// Reference point of the slide's travel: the centre of the joint that guides it, else the mean
    /// of its joints' centres; in the assembled position [m].
    [[nodiscard]] Vec2 slide_point() const;

    /// Motion of the slide along the stroke direction per unit shift of every joint's centre, driver held: solves
    /// J^T lambda = d(stroke)/dq once; see BottomDeadPointSensitivity for the sign.
    /// @throws InputError if the position is singular
    [[nodiscard]] std::vector<Vec2> slide_weights(const std::vector<PlanarPose>& poses) const;

private:
    PlanarLayout layout_;
};

}  // namespace deadpoint::mechanism
