#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/stress.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// Data between the deformation solver and the drift stage. SI units.
namespace deadpoint {

/// A weight on the displacement of one point of an exterior face.
struct PointWeight {
    std::uint32_t face = 0;  ///< index into Machine::faces
    Vec3 position{};         ///< on that face [m]
    Vec3 weight{};
};

/// A linear functional of the displacement field: the sum of weight . u(position). An adjoint is
/// solved for each.
struct Functional {
    std::string name;
    std::vector<PointWeight> points;
};

/// Supports of the feet.
struct Foundation {
    /// free: held normal to the feet's plane, in which they slide; clamped: u = 0; elastic: pads of
    /// the stiffnesses below.
    enum class Kind { free, clamped, elastic };
    int surface = -1;  ///< index into Machine::surfaces; -1: no feet
    Kind kind = Kind::free;
    double vertical = 0;    ///< across the feet's plane, stiffness per area [N/m3]
    double horizontal = 0;  ///< along it [N/m3]
};

/// Loads besides heat that strain the machine; constant in time.
struct RestLoads {
    Vec3 gravity{};                       ///< on the bodies that stand on the feet [m/s2]
    std::vector<Tensor6> initial_strain;  ///< per part; a free part has no stress from it; empty: none
};

/// A force within the machine or on its feet, linear in deformation and temperature [N].
struct ForceGauge {
    enum class Kind {
        rod,   ///< in the free length of a part between its two bonded ends, along an axis; tension positive
        bond,  ///< across a bond, along its normal; tension positive
        feet   ///< from the ground upwards on the feet
    };
    std::string name;
    Kind kind = Kind::rod;
    int index = 0;  ///< part, or index into Machine::bonds
    Axis axis = Axis::y;
};

/// Rigid motion in the plane of the linkage that closes the joints: rotation by a small angle about `centre`, then a
/// translation.
struct RigidMotion {
    Vec2 translation{};
    double angle = 0;
    Vec2 centre{};
};

/// By how much a rigid motion moves a point [m].
constexpr Vec3 rigid_displacement(const RigidMotion& motion, const Vec3& x)
{
    return {motion.translation[0] - motion.angle * (x[1] - motion.centre[1]),
            motion.translation[1] + motion.angle * (x[0] - motion.centre[0]), 0};
}

/// Largest number of unknowns of a deformation that is solved by a sparse factor, which then needs about
/// 8 GB.
inline constexpr long long largest_factor = 1'500'000;

}  // namespace deadpoint
