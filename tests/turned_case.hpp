#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/assembly/measure.hpp"

#include <cmath>
#include <numbers>
#include <variant>

/// A case and its meshed machine, turned about z with all that has a direction in the plane.
namespace deadpoint {

inline Vec2 rotated(const Vec2& v, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

inline Vec3 rotated(const Vec3& v, double angle)
{
    const Vec2 across = rotated(Vec2{v[0], v[1]}, angle);
    return {across[0], across[1], v[2]};
}

/// Joints, centres of mass, gravity, stated directions and crank angles; parts and surfaces stay.
inline casefile::Case turned(casefile::Case input, double angle)
{
    for (auto& [name, joint] : input.joints) {
        joint.centre = rotated(joint.centre, angle);
        joint.direction = rotated(joint.direction, angle);
    }
    for (auto& [name, body] : input.bodies)
        if (body.centre_of_mass)
            body.centre_of_mass = rotated(*body.centre_of_mass, angle);
    input.machine.gravity_direction = rotated(input.machine.gravity_direction, angle);
    if (input.mechanism.stroke_direction)
        input.mechanism.stroke_direction = rotated(*input.mechanism.stroke_direction, angle);
    if (input.chain && input.chain->reaction_angle)
        *input.chain->reaction_angle += angle;
    if (input.crankshaft && input.crankshaft->belt)
        input.crankshaft->belt->angle += angle;
    if (input.process_force && input.process_force->from)
        *input.process_force->from += angle;
    if (input.process_force && input.process_force->to)
        *input.process_force->to += angle;
    return input;
}

inline void turn(FaceGeometry& geometry, double angle)
{
    if (auto* plane = std::get_if<PlaneGeometry>(&geometry))
        plane->normal = rotated(plane->normal, angle);
    if (auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        cylinder->point = rotated(cylinder->point, angle);
        cylinder->axis = rotated(cylinder->axis, angle);
    }
}

inline void turn(Contact& contact, double angle)
{
    turn(contact.geometry, angle);
    for (auto* points : {&contact.points, &contact.drawn_points})
        for (auto& point : *points) {
            point.position_a = rotated(point.position_a, angle);
            point.position_b = rotated(point.position_b, angle);
            point.normal = rotated(point.normal, angle);
        }
}

inline Machine turned(Machine machine, double angle)
{
    for (auto& node : machine.nodes)
        node = rotated(node, angle);
    for (auto& geometry : machine.geometries)
        turn(geometry, angle);
    for (auto* contacts : {&machine.interfaces, &machine.bonds})
        for (auto& contact : *contacts)
            turn(contact, angle);
    machine::measure(machine);
    return machine;
}

}  // namespace deadpoint
