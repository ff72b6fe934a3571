#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/solid_print.hpp"

#include <string>
#include <vector>

/// What a CAD file holds, as plain values: solids with their plane, cylindrical and spherical faces. SI units,
/// coordinates of the file.
namespace deadpoint::machine {

/// A face in a plane.
struct CadPlane {
    Vec3 normal{};                         ///< unit, out of the solid
    double offset = 0;                     ///< normal . x on the plane [m]
    std::vector<std::vector<Vec3>> loops;  ///< outline, then holes; arcs as chords of 6 degrees at most
};

/// A face on a cylinder, between two angles and two places along its axis.
struct CadCylinder {
    Vec3 point{};   ///< on the axis
    Vec3 axis{};    ///< unit
    Vec3 across{};  ///< unit, where the angle is 0; the angle turns about `axis`
    double radius = 0;
    bool bore = false;               ///< the solid lies outside of the radius
    std::array<double, 2> angles{};  ///< [rad]
    std::array<double, 2> range{};   ///< along the axis, from `point` [m]
};

/// A face on a sphere.
struct CadSphere {
    Vec3 centre{};
    double radius = 0;
    bool hollow = false;  ///< the solid lies outside of the radius: a socket
};

struct CadFace {
    std::string name;  ///< in the file; mostly empty
    double area = 0;   ///< [m2]
    std::variant<std::monostate, CadPlane, CadCylinder, CadSphere> form;
};

struct CadSolid {
    std::string name;    ///< unique in the file, to be a key of a case
    std::string path;    ///< names of the assemblies that it is in, with '/'
    std::string colour;  ///< "#rrggbb", or empty
    double volume = 0;   ///< [m3]
    BoxShape bounds;
    std::vector<CadFace> faces;
    std::string called = {};      ///< in the file, where several may have one name; empty: it has none
    SolidPrint fingerprint = {};  ///< what tells it from the others, in the file's own coordinates and unit
};

struct CadModel {
    std::string unit;  ///< that the file says: "millimetre"; empty if it says none
    double scale = 1;  ///< lengths here over those that the file says: not 1 where the user states another unit
    std::vector<CadSolid> solids;
    std::vector<std::string> without_solid;  ///< products that hold surfaces or curves only
};

/// The name by which a case takes a solid: that of the file; "solid" where it has none.
std::string name_in_case(const CadSolid& solid);

/// Length of the longest edge of the box around all solids [m].
double extent(const CadModel& model);

}  // namespace deadpoint::machine
