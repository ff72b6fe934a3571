#pragma once

#include "deadpoint/core/vec.hpp"

#include <string>
#include <vector>

/// The planar linkage of the mechanism stage, and its results for the drift stage.
namespace deadpoint {

/// Position of a body in the plane: its frame coincides with the machine's at the assembled position of the case file.
struct PlanarPose {
    Vec2 translation{};  ///< [m]
    double angle = 0;    ///< [rad], counter-clockwise about the machine's origin, applied before the translation
};

struct LinkageJoint {
    enum class Kind { revolute, slide };
    std::string name;
    Kind kind = Kind::revolute;
    int body_a = 0;  ///< index into Linkage::bodies
    int body_b = 0;
    Vec2 centre{};                ///< in machine coordinates, as assembled in the case file [m]
    Vec2 direction{0, 1};         ///< slide only: direction of travel, unit
    bool guides_rotation = true;  ///< slide only: false leaves the body free to turn
};

struct Linkage {
    std::vector<std::string> bodies;
    int ground = 0;
    std::vector<LinkageJoint> joints;
    int driver = 0;               ///< joint (revolute to ground) whose angle is prescribed
    int slide_body = 0;           ///< body that carries the tool
    Vec2 stroke_direction{0, 1};  ///< bottom dead point is where the slide is lowest along this direction
};

/// Motion of the slide when joint centres shift, at bottom dead point with the crank held.
///
/// A centre of joint j that shifts by d_a in body_a and d_b in body_b (machine coordinates, seen from each body)
/// moves the slide along the stroke direction by  dot(weight[j], d_b - d_a); for a slide joint the shift counts
/// across the direction of travel, with `weight` pointing that way.
struct BottomDeadPointSensitivity {
    double crank_angle = 0;           ///< of the driver at bottom dead point, relative to the assembled position [rad]
    std::vector<PlanarPose> poses;    ///< of every body at bottom dead point
    std::vector<Vec2> joint_centres;  ///< [m], at bottom dead point
    std::vector<Vec2> weight;         ///< per joint [-]
};

/// Motion of the slide at bottom dead point, with the crank held, when a body grows between two of
/// its joint centres.
struct LengthSensitivity {
    std::string body;
    std::string from;             ///< joint whose centre stays in the body
    std::string to;               ///< joint whose centre moves away from it
    double length = 0;            ///< distance of the two centres [m]
    double height_by_length = 0;  ///< of the slide along the stroke [-]
};

}  // namespace deadpoint
