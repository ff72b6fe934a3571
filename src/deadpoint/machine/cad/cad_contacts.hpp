#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/machine/cad/cad_model.hpp"

#include <array>
#include <cstddef>

/// Where the solids of a drawing touch or nearly touch. Geometry only: what a contact means is decided elsewhere.
namespace deadpoint::machine {

struct CadContact {
    enum class Kind { cylinder, plane, sphere };
    Kind kind = Kind::plane;
    std::size_t a = 0;  ///< index of a solid; of a cylinder or sphere, the one around it
    std::size_t b = 0;
    double area = 0;       ///< that both faces share; of spheres, that of the smaller face [m2]
    double clearance = 0;  ///< distance of planes, difference of diameters [m]; negative: drawn into each other
    double diameter = 0;   ///< of the inner cylinder or sphere [m]
    Vec3 point{};          ///< on the axis of a cylinder; centre of a sphere; middle of the contact on the plane of `a`
    Vec3 direction{};      ///< axis of a cylinder; normal of a plane out of `a`; zero of a sphere
    std::array<double, 2> range{};  ///< of a cylinder along its axis, from `point` [m]
};
/// The middle of the part of a cylinder that is in contact.
inline Vec3 middle_of(const CadContact& contact)
{
    return contact.point + 0.5 * (contact.range[0] + contact.range[1]) * contact.direction;
}

/// How near faces must be.
struct CadReach {
    double plane = 0.5e-3;      ///< of planes [m]
    double into = 0.05e-3;      ///< how far they may be drawn into each other [m]
    double cylinder = 0.01;     ///< difference of diameters over the diameter, of spheres too
    double axes = 1e-3;         ///< of the axes of two cylinders, centres of two spheres; at most half of that [m]
    double least_area = 25e-6;  ///< smaller contacts are none [m2]
};

/// All contacts of different solids: planes that face each other, cylinders in bores about one axis (directions to
/// 1 mrad), and balls in sockets about one centre. Faces of one pair of solids in one plane, or about one axis with one
/// diameter, count together. Areas of planes are those of their polygons, whose arcs are chords of 6 degrees (0.2 % of
/// a disk); areas of cylinders are radius times shared angle times shared length, less the share of each face that is
/// cut out of it.
std::vector<CadContact> find_contacts(const CadModel& model, const CadReach& reach = {});

}  // namespace deadpoint::machine
