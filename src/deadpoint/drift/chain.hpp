#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <array>
#include <string>
#include <vector>

/// The dimension chain at bottom dead point: which displacements make which dimension, as linear functionals.
namespace deadpoint::drift {

/// A side of a contact: the surface of one part there.
struct ContactSide {
    int contact = 0;  ///< index into Machine::interfaces
    bool side_b = false;
};

/// The surfaces that carry a joint in each of its two bodies.
struct JointSurfaces {
    std::vector<ContactSide> in_a;
    std::vector<ContactSide> in_b;
};

struct ChainDescription {
    std::vector<JointSurfaces> joints;  ///< as Linkage::joints
    int slide_surface = -1;             ///< index into Machine::surfaces
    int table_surface = -1;
    int crank_joint = -1;            ///< index into Linkage::joints: the crank in its bearings
    std::vector<ContactSide> seats;  ///< bearing seats, the side of the ground
    std::vector<int> clearance;      ///< contacts of the crank bearings: their bores' growth less their shafts'
    Vec2 pressed{};                  ///< unit direction in which the crank lies against its seats
};

/// The order in which chain_functionals() returns the dimensions.
enum Dimension : int { bearing_to_ground, table_to_ground, clearance, slide_height, gap, dimension_count };

/// Where a joint's centre goes as its body deforms: component x and y of the fitted centre.
using CentreFunctionals = std::array<Functional, 2>;

struct JointCentres {
    CentreFunctionals in_a;
    CentreFunctionals in_b;
};

/// Fit of a circle to the displaced surface about its axis: the radial displacement is taken as
/// a_x cos(phi) + a_y sin(phi) + g r / R and (a_x, a_y, g) by least squares over the surface; g, the growth of the
/// radius R, keeps a half bore from passing its growth off as a shift.
///
/// On the symmetry plane of a half model a_x is 0 and only (a_y, g) are fitted.
struct CircleFit {
    Functional x, y, growth;
};
CircleFit fit_circle(const Machine& machine, const ContactSide& side, const Vec2& centre);

/// Centres of a joint in both bodies. Revolute: the mean of the fits of its surfaces. Slide: the mean displacement
/// across the direction of travel of the faces that look that way; none (0) where the slide lies on the symmetry
/// plane of a half model, or has only faces that look along the axis.
JointCentres joint_centres(const Machine& machine, const Linkage& linkage,
                           const BottomDeadPointSensitivity& sensitivity, int joint, const JointSurfaces& surfaces);

/// The dimensions, each a functional of the displacement of all bodies (each body seen from itself):
///
///   E_BG  mean of the fitted seat centres, upwards
///   E_WG  mean of the table's face, upwards
///   E_BC  seat centre less crank centre: the crank lies against its seats, so  -(growth of the clearance) sin(angle)
///   s     slide face, upwards: sum over joints of weight . (d_b - d_a), plus the face's own displacement
///   E_SW  s - E_WG, the gap;  E_CS = E_BG - E_BC - s follows from  E_SW = E_BG - E_WG - E_CS - E_BC
std::vector<Functional> chain_functionals(const Machine& machine, const Linkage& linkage,
                                          const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain);

/// Growth of the crank bearings' radial clearance: of the bores less that of the shafts in them, summed along a bearing
/// from seat to shaft, mean over the bearings.
Functional clearance_growth(const Machine& machine, const BottomDeadPointSensitivity& sensitivity,
                            const ChainDescription& chain);

/// a += factor b
void add(Functional& a, double factor, const Functional& b);

}  // namespace deadpoint::drift
