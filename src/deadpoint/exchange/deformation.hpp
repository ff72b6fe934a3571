#pragma once

#include "deadpoint/core/vec.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// What passes between the deformation solver and the drift stage. SI units.
namespace deadpoint {

/// A weight on the displacement of one point of an exterior face.
struct PointWeight {
    std::uint32_t face = 0;  ///< index into Machine::faces
    Vec3 position{};         ///< on that face [m]
    Vec3 weight{};
};

/// A linear functional of the displacement field: the sum of weight . u(position). What an adjoint is solved for.
struct Functional {
    std::string name;
    std::vector<PointWeight> points;
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

}  // namespace deadpoint
