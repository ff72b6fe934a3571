#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/deformation.hpp"

#include <optional>
#include <vector>

namespace deadpoint {
struct BottomDeadPointSensitivity;
struct Linkage;
struct Machine;
}  // namespace deadpoint

/// Internal to drift/: the tilt of bodies, held by joints.
namespace deadpoint::drift {

struct ContactSide;

struct ChainDescription;

/// Rotation about an axis of a body's surfaces of one joint as the body deforms.
struct TiltFit {
    Functional angle;        ///< [rad]
    double information = 0;  ///< stiffness of the fit: mean square mismatch per rad^2, times the area [m4]
};

/// Least squares over the surfaces: the displacement along the normal is taken as that of a rigid body (three shifts,
/// three rotations about the centroid) plus, per surface, an even growth and, on a cylinder, a taper along its axis,
/// which are no motion of the axis. On the symmetry plane of a half model only the motions that keep it remain.
///
/// @return nothing if the surfaces do not hold that rotation (a plane about its normal, a cylinder about its axis)
/// @param axis  unit
std::optional<TiltFit> fit_tilt(const Machine& machine, const std::vector<ContactSide>& sides, const Vec3& axis,
                                bool symmetric);

/// Tilts of the linkage's bodies about the direction to the right of the stroke (x where it points up), out of the
/// linkage's plane. Joints hold more of them than there are; the tilts are
/// those that leave the least mean square mismatch over all joints' surfaces,
///     sum over joints of I_j (theta_b + t_b - theta_a - t_a)^2 -> min,   ground: theta = 0
/// with t the fitted angles of the surfaces in their bodies and I_j the smaller information of the two.
class TiltClosure {
public:
    TiltClosure(const Machine& machine, const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity,
                const ChainDescription& chain);

    /// True if the joints hold a body's tilt.
    [[nodiscard]] bool holds(int body) const;
    /// sum over bodies of factor . tilt; factors of bodies that nothing holds are left out.
    [[nodiscard]] Functional combine(const std::vector<double>& factors) const;

private:
    struct Link {
        int body_a = 0;
        int body_b = 0;
        double information = 0;
        Functional mismatch;  ///< t_b - t_a
    };
    [[nodiscard]] std::vector<double> solve(std::vector<double> load) const;

    int ground_ = 0;
    std::vector<Link> links_;
    std::vector<bool> held_;  ///< per body
};

}  // namespace deadpoint::drift
