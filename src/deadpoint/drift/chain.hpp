#pragma once

#include "deadpoint/drift/joint_surfaces.hpp"
#include "deadpoint/exchange/deformation.hpp"

#include <array>
#include <string>
#include <vector>

namespace deadpoint {
struct BottomDeadPointSensitivity;
struct Linkage;
struct Machine;
}  // namespace deadpoint

/// The dimension chain at bottom dead point, as linear functionals of the displacement.
namespace deadpoint::drift {

struct ChainDescription {
    std::vector<JointSurfaces> joints;  ///< as Linkage::joints
    int slide_surface = -1;             ///< index into Machine::surfaces
    int table_surface = -1;
    int crank_joint = -1;                    ///< index into Linkage::joints: the crank in its bearings
    std::vector<ContactSide> seats;          ///< bearing seats, the side of the ground
    std::vector<std::vector<int>> bearings;  ///< contacts of each crank bearing from seat to shaft: its clearance
    Vec2 pressed{};                          ///< unit direction in which the crank lies against its seats
};

/// The order in which chain_functionals() returns the dimensions; the bearings' growths follow them.
enum Dimension : int { bearing_to_ground, table_to_ground, slide_height, gap, dimension_count };

/// Shift of a joint's centre as its body deforms: components x and y of the fitted centre.
using CentreFunctionals = std::array<Functional, 2>;

struct JointCentres {
    CentreFunctionals in_a;
    CentreFunctionals in_b;
};

/// Fit of a circle to the displaced surface about its axis: the radial displacement is taken as a_x
/// cos(phi) + a_y sin(phi) + g r / R and (a_x, a_y, g) by least squares over the surface; g is the
/// growth of the radius R; without it the growth of a half bore would appear as a shift.
///
/// On the symmetry plane of a half model a_x is 0 and only (a_y, g) are fitted.
struct CircleFit {
    Functional x, y, growth;
};
CircleFit fit_circle(const Machine& machine, const ContactSide& side, const Vec2& centre);

/// Centres of a joint in both bodies. Revolute: the mean of the fits of its surfaces. Slide: the
/// mean displacement across the direction of travel of the faces with normals in that direction; 0
/// if the slide lies on the symmetry plane of a half model, or has only faces with normals along
/// the axis.
JointCentres joint_centres(const Machine& machine, const Linkage& linkage,
                           const BottomDeadPointSensitivity& sensitivity, int joint, const JointSurfaces& surfaces);

/// The dimensions with the play of the crank's bearings as at the start, each a functional of the displacement of all
/// bodies (each body seen from itself), and after them the growth of each crank bearing's radial clearance: of the
/// bores less that of the shafts in them, summed from seat to shaft.
///
///   E_BG  mean of the fitted seat centres
///   E_WG  mean of the table's face
///   s     slide face: sum over joints of weight . (d_b - d_a), plus the face's own displacement
///   gap   s - E_WG
///
/// all along Linkage::stroke_direction, away from the table.
///
/// The growths add to s and to the gap: travel_by_play() times the mean of BearingPlay::taken().
std::vector<Functional> chain_functionals(const Machine& machine, const Linkage& linkage,
                                          const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain);

/// Motion of the slide along the stroke per growth of the crank's play in the direction in which it
/// is pressed [-].
double travel_by_play(const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity,
                      const ChainDescription& chain);

/// a += factor b
void add(Functional& a, double factor, const Functional& b);

}  // namespace deadpoint::drift
