#pragma once

#include "deadpoint/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace deadpoint {
struct Functional;
struct Linkage;
struct Machine;
struct MeshPart;
}  // namespace deadpoint

/// Internal to drift/: the points of one side of a contact.
namespace deadpoint::drift {

struct ContactSide;

struct SurfacePoint {
    std::uint32_t face;
    Vec3 position;
    double weight;
    Vec3 normal;
};

/// Points of the contact as drawn, at bottom dead point.
std::vector<SurfacePoint> points_of(const Machine& machine, const ContactSide& side);
const MeshPart& part_of(const Machine& machine, const ContactSide& side);
/// The side lies around the symmetry plane of a half model, which keeps its centre and axis.
bool on_symmetry_plane(const Machine& machine, const ContactSide& side, const Vec2& centre);

/// Direction of the stroke, away from the table, and across it to its right within the plane of the linkage; unit.
Vec3 stroke_of(const Linkage& linkage);
Vec3 right_of(const Linkage& linkage);

/// Mean displacement of a surface in a direction.
Functional mean_along(const Machine& machine, int surface, const Vec3& direction);

/// Growth of a cylindrical contact's bore less that of the shaft in it, on the radius.
/// @throws InputError if the contact is not cylindrical or too little of a circle
Functional contact_growth(const Machine& machine, int contact, const Vec2& centre);

}  // namespace deadpoint::drift
