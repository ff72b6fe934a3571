#pragma once

#include "deadpoint/mechanism/planar_layout.hpp"
#include "deadpoint/mechanism/planar_motion.hpp"

#include <Eigen/Dense>
#include <optional>
#include <span>
#include <string>

/// Internal: the constraint equations of PlanarSystem as matrices.
namespace deadpoint::mechanism {

struct PlanarLayout;

struct PlanarPosition::Factors {
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;
    int determinant_sign = 1;
};

/// A quarter turn counter-clockwise: the derivative of a rotated vector by its angle.
inline Vec2 turned(const Vec2& v) { return {-v[1], v[0]}; }
Vec2 rotated(const Vec2& v, double angle);
int equations_of(const LinkageJoint& joint);

/// The equations in a given position: their residual, their Jacobian, and its faults.
struct PlanarAlgebra {
    const PlanarLayout& layout;
    const std::vector<PlanarPose>& poses;
    std::span<const CentreShift> shifts = {};

    /// A joint in this position: the arms from the bodies' origins to its centre, and their gap.
    struct Joint {
        const LinkageJoint& joint;
        const PlanarPose& a;
        const PlanarPose& b;
        Vec2 arm_a;
        Vec2 arm_b;
        Vec2 open;    ///< p_a - p_b
        Vec2 normal;  ///< across the direction of travel
    };

    [[nodiscard]] Joint at(int index) const;
    [[nodiscard]] int joints() const { return static_cast<int>(layout.linkage.joints.size()); }
    [[nodiscard]] Eigen::VectorXd residual(double driver_angle) const;
    [[nodiscard]] Eigen::MatrixXd jacobian() const;
    /// Right-hand side of J q'' = gamma: all terms of the second derivative of the constraints without q''.
    [[nodiscard]] Eigen::VectorXd gamma(const std::vector<PlanarPose>& v, double driver_acceleration) const;
    [[nodiscard]] std::vector<PlanarPose> spread(const Eigen::VectorXd& q) const;
    /// Gap of a joint that is not closed [m].
    [[nodiscard]] double opening(int joint) const;

    /// @throws InputError if the matrix is singular
    [[nodiscard]] Eigen::PartialPivLU<Eigen::MatrixXd> factorised(const Eigen::MatrixXd& matrix,
                                                                  double driver_angle) const;

    /// Fault of constraints that do not determine the position.
    struct Fault {
        std::string text;  ///< empty: nothing
        std::string help;
    };
    /// @param missing  rank that is taken to be missing even if rounding hides it
    [[nodiscard]] Fault fault(const Eigen::MatrixXd& matrix, long missing = 0) const;

private:
    void fill(Eigen::MatrixXd& matrix, int row, const Joint& joint, bool first) const;
    [[nodiscard]] std::string joints_in(const Eigen::MatrixXd& null_space, double share) const;
    [[nodiscard]] std::string bodies_in(const Eigen::MatrixXd& null_space, double share) const;
    [[nodiscard]] std::string what_to_free(const Eigen::MatrixXd& null_space, double share) const;
};

/// Positions one after the other, each from the one before.
struct PlanarWalk {
    const PlanarLayout& layout;
    std::span<const CentreShift> shifts = {};

    /// Factors the Jacobian at closed poses and finds their derivatives. @throws InputError if it is singular
    [[nodiscard]] PlanarPosition located(std::vector<PlanarPose> poses) const;
    /// Newton's method with a factor that is renewed when convergence is slow; false if it does not
    /// converge.
    bool close(std::vector<PlanarPose>& guess, double angle, Eigen::PartialPivLU<Eigen::MatrixXd> lu) const;
    /// The furthest position towards `to` at which the linkage closes. @throws InputError if it
    /// passes a singular position
    [[nodiscard]] PlanarPosition furthest(PlanarPosition from, double to) const;
    /// The obstacle at the last closed position, for a driver that turns to `to`.
    [[nodiscard]] std::string obstacle(const PlanarPosition& last, double to) const;

private:
    /// The closed position at another angle, if it can be found.
    /// @param far the Jacobian at `from` cannot be used there
    [[nodiscard]] std::optional<PlanarPosition> stepped(const PlanarPosition& from, double to, bool far) const;
    [[nodiscard]] int jammed_joint(const PlanarPosition& last) const;
    struct Miss {
        double angle = 0;    ///< of the driver [rad]
        double opening = 0;  ///< [m]
    };
    [[nodiscard]] Miss miss(const PlanarPosition& last, double to, int joint) const;
};

}  // namespace deadpoint::mechanism
