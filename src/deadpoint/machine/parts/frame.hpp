#pragma once

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <vector>

/// The frame in which a part is meshed. Decisions of mesh generators depend on the last digits of
/// coordinates, differently along each axis. In the part's own frame they see the same numbers for
/// any position, any rotation by right angles, and any units.
namespace deadpoint::machine {

struct Prism;

/// Local coordinate i is sign[i] times machine coordinate axis[i], less origin[i]. Always a rotation.
struct Frame {
    std::array<std::size_t, 3> axis{0, 1, 2};
    std::array<double, 3> sign{1, 1, 1};
    Vec3 origin{};
};

/// A length in a frame: rounded to a picometre.
double in_frame(double length);

Vec3 to_local(const Frame& frame, const Vec3& point);
Vec3 to_machine(const Frame& frame, const Vec3& local);

/// A prism in the coordinates of the frame, rounded to a picometre.
Prism to_local(const Frame& frame, const Prism& prism);
/// A mesh of the frame, transformed to the machine; cylinders along a coordinate axis point along
/// it.
PartMesh to_machine(const Frame& frame, PartMesh mesh);

/// The rotation by right angles and the shift that give the smallest numbers to a part's shapes in
/// their order, so that a rotated or shifted part gets the same frame coordinates. If a symmetric
/// part leaves several choices, `towards` decides.
/// @param towards  a direction that turns with the machine: from the middle of the part to that of the machine [m]
/// @param half     the plane x = 0 is one of symmetry: x stays as it is
Frame frame_of(const std::vector<Prism>& prisms, const Vec3& towards, bool half);

/// The box around shapes.
BoxShape bounds_of(const std::vector<Prism>& prisms);
Vec3 middle(const BoxShape& box);

/// The same polygon counter-clockwise and beginning with its smallest corner.
std::vector<Vec2> in_standard_order(std::vector<Vec2> ring);

}  // namespace deadpoint::machine
