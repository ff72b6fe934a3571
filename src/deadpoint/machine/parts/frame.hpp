#pragma once

#include "deadpoint/machine/geometry/shapes.hpp"
#include "deadpoint/machine/parts/part_mesh.hpp"

#include <vector>

/// The frame in which a part is meshed. Mesh generators decide by the last digits of coordinates, and differently along
/// each axis; in a frame that belongs to the part itself they see the same numbers wherever it stands, whichever way it
/// is turned and in whatever units it was written.
namespace deadpoint::machine {

/// Local coordinate i is sign[i] times machine coordinate axis[i], less origin[i]. Always a rotation.
struct Frame {
    std::array<std::size_t, 3> axis{0, 1, 2};
    std::array<double, 3> sign{1, 1, 1};
    Vec3 origin{};
};

/// A length as frames hold it: rounded to a picometre.
double in_frame(double length);

Vec3 to_local(const Frame& frame, const Vec3& point);
Vec3 to_machine(const Frame& frame, const Vec3& local);

/// A prism as the frame sees it, its numbers rounded to a picometre.
Prism to_local(const Frame& frame, const Prism& prism);
/// A mesh made in the frame, at its place in the machine; cylinders along a coordinate axis point along it.
PartMesh to_machine(const Frame& frame, PartMesh mesh);

/// The rotation by right angles and the shift that give a part's shapes the smallest numbers in their order, so that a
/// part that is turned or shifted is seen the same. Where a symmetric part leaves several, `towards` decides.
/// @param towards  a direction that turns with the machine: from the middle of the part to that of the machine [m]
/// @param half     the plane x = 0 is one of symmetry: x stays as it is
Frame frame_of(const std::vector<Prism>& prisms, const Vec3& towards, bool half);

/// The box around shapes.
BoxShape bounds_of(const std::vector<Prism>& prisms);
Vec3 middle(const BoxShape& box);

/// The same polygon counter-clockwise and beginning with its smallest corner.
std::vector<Vec2> in_standard_order(std::vector<Vec2> ring);

}  // namespace deadpoint::machine
