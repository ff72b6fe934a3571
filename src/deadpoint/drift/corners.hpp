#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/deformation.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct BottomDeadPointSensitivity;
struct Linkage;
struct Machine;
}  // namespace deadpoint

namespace deadpoint::drift {

struct ChainDescription;

/// Rotation of the slide by the closing of the linkage, with the crank held.
struct SlideTurn {
    std::vector<Vec2> weight;  ///< per joint and shift d_b - d_a of its centre [rad/m]
    double about = 0;          ///< place to the right of the slide's point that moves by the chain's travel [m]
};

struct Corner {
    std::string name;  ///< "front left"
    double x = 0;      ///< place along the direction to the right of the stroke: x where that points up [m]
    double z = 0;
    Functional gap;  ///< shift along the stroke of the slide's corner less that of the table's point below it
};

/// The gap at the corners of the slide's face, in the order front left, front right, back left, back right: the points
/// of it that reach farthest there. Front is `front`, left is front x stroke, as who stands in front sees it. Below
/// each, against the stroke, the table's point with the same x and z, or the nearest one.
///
///   gap = u_s(corner) - u_s(table below) + travel + theta_z (x - x_0) + tilt about the direction of x
///
/// travel is that of the chain (chain_functionals). theta_z: if the ground guides the slide's
/// rotation, from the faces of that guide (fit_tilt of both sides), about the pins that carry the
/// slide; else from `turn`, which is 0 in a guide. Tilt about x: from TiltClosure, with the heights
/// that the tilts of all bodies give the joints; 0 if no joint holds it. Half model: the corners at
/// x < 0; the others are their mirror images.
///
/// @param front  unit vector, z or across the stroke
/// @param dimensions  chain_functionals()
std::vector<Corner> corner_gaps(const Machine& machine, const Linkage& linkage,
                                const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain,
                                const std::vector<Functional>& dimensions, const SlideTurn& turn, const Vec3& front);

}  // namespace deadpoint::drift
