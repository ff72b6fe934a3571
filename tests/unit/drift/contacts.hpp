#pragma once

#include "deadpoint/drift/chain.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <numbers>

/// Contacts made of points alone, and functionals applied to displacements that are known everywhere.
namespace deadpoint {

constexpr double micrometre = 1e-6;
constexpr double rounding = 1e-12;  // relative: the displacements below are among those that the fits take

using Displacement = std::function<Vec3(std::uint32_t face, const Vec3& position)>;

inline double value(const Functional& functional, const Displacement& displacement)
{
    double sum = 0;
    for (const auto& point : functional.points)
        sum += dot(point.weight, displacement(point.face, point.position));
    return sum;
}

inline auto micrometres(double expected) { return near(expected * micrometre, rounding); }

// Two bodies of one part each. Side a of contact c lies on face 2 c beyond those of the machine, side b on face 2 c
// + 1.
inline Machine two_bodies()
{
    Machine machine;
    machine.parts.resize(2);
    machine.parts[0].body = "frame";
    machine.parts[1].body = "slide";
    return machine;
}

inline void add_contact(Machine& machine, const FaceGeometry& geometry, const std::vector<ContactPoint>& points)
{
    Contact contact;
    contact.geometry = geometry;
    contact.part_b = 1;
    contact.points = points;
    for (auto& point : contact.points) {
        point.face_a = static_cast<std::uint32_t>(machine.faces.size() + 2 * machine.interfaces.size());
        point.face_b = point.face_a + 1;
        contact.drawn_area += point.weight;
    }
    machine.interfaces.push_back(contact);
}

constexpr double radius = 0.05;

constexpr double ring_distance = 0.01;

// An arc of a bearing about `centre`, some rings of points unevenly heavy; `bore`: side a is the bore.
inline void add_bearing(Machine& machine, const Vec2& centre, double from, double to, bool bore, int rings = 1)
{
    std::vector<ContactPoint> points;
    constexpr int count = 60;
    for (int k = 0; k < rings * count; ++k) {
        const int i = k % count;
        const double phi = (from + (to - from) * (i + 0.5) / count) * std::numbers::pi / 180;
        const Vec3 outwards{std::cos(phi), std::sin(phi), 0};
        ContactPoint point;
        point.position_a = Vec3{centre[0], centre[1], ring_distance * (k / count)} + radius * outwards;
        point.position_b = point.position_a;
        point.normal = (bore ? -1.0 : 1.0) * outwards;
        point.weight = 1e-4 * (1 + 0.4 * std::sin(3 * phi));
        points.push_back(point);
    }
    add_contact(machine, CylinderGeometry{{centre[0], centre[1], 0}, {0, 0, 1}, radius, bore}, points);
}

// A shift and a growth of the radius.
inline Vec3 moved_circle(const Vec2& centre, const Vec2& shift, double growth, const Vec3& position)
{
    const Vec3 arm{position[0] - centre[0], position[1] - centre[1], 0};
    return Vec3{shift[0], shift[1], 7} + (growth / radius) * arm;
}

}  // namespace deadpoint
