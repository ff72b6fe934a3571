#pragma once

#include "deadpoint/exchange/laws/friction.hpp"

#include <vector>

/// Mechanics of an angular contact or deep groove ball bearing: contact of ball and groove,
/// stiffness, spin friction, and the effect of warm rings on the preload (Harris, Rolling Bearing
/// Analysis).
namespace deadpoint::tribology {

struct ContactCurvature;
struct ContactEllipse;
struct Duty;
struct RollingRow;
struct RowApproach;

/// Balls between two grooves, one row or a matched pair.
struct BallBearing {
    int balls = 0;                   ///< of one row
    int rows = 1;                    ///< 1 or 2
    double ball_diameter = 0;        ///< [m]
    double pitch_diameter = 0;       ///< [m]
    double contact_angle = 0;        ///< [rad]
    double inner_osculation = 0.52;  ///< groove radius over ball diameter, above 0.5
    double outer_osculation = 0.52;
    double youngs_modulus = 2.08e11;  ///< of balls and rings [Pa]
    double poissons_ratio = 0.3;
};

/// @throws InputError if a size is not positive, the row cannot hold its balls, an osculation is not between 0.5 and 1,
///         or the rows are not 1 or 2
void check(const BallBearing& bearing);

/// With gamma = D cos(angle)/pitch diameter and osculation f: sum (4 - 1/f + 2 gamma/(1 - gamma)) / D and difference
/// (1/f + 2 gamma/(1 - gamma)) / (D sum) at the inner groove; -2 gamma/(1 + gamma) in its place at the outer one.
ContactCurvature inner_curvature(const BallBearing& bearing);
ContactCurvature outer_curvature(const BallBearing& bearing);

/// Ellipse between a ball under a load [N] and the inner or the outer groove.
ContactEllipse inner_contact(const BallBearing& bearing, double load);
ContactEllipse outer_contact(const BallBearing& bearing, double load);

/// A row of the bearing, its stiffness from both contacts in series: Q = (c_i + c_o)^(-3/2) approach^(3/2) with
/// approach c Q^(2/3) at each. Rigid rings, no oil film, constant contact angle.
RollingRow rolling_row(const BallBearing& bearing);

/// Load on the bearing besides the radial force over the turn.
struct BallLoading {
    double axial = 0;  ///< constant, from outside, not negative for one row [N]
    double base = 0;   ///< approach along the contact before load [m]: preload_approach(), clearance_approach(), and
                       ///< thermal_approach() added up
};

/// Approach of a row preloaded by an axial force [N].
/// @throws InputError if the force is negative, or positive without contact angle
double preload_approach(const BallBearing& bearing, double axial_preload);

/// Approach (negative) of a row with diametral clearance [m]; a negative clearance is an interference of the rings.
double clearance_approach(const BallBearing& bearing, double diametral_clearance);

/// Distribution of a radial force over the rows: the pair shares radial and axial force at common
/// radial displacement; a single row has its preload counted as axial force (spread_single), or its
/// clearance where the contact angle is zero.
/// @throws InputError on negative force; ConvergenceError where a pair finds no equilibrium
std::vector<RowApproach> spread_load(const BallBearing& bearing, double radial, const BallLoading& loading);

/// Moment of a ball spinning on its contact (Harris): 3 friction load major E(k) / 8 with k^2 = 1 - (minor/major)^2;
/// for a round contact, 3 pi friction load radius / 16.
///
/// @param friction  coefficient of sliding in the contact, 0.02 .. 0.1
/// @param load      [N]
/// @param major, minor  semi-axes of the ellipse [m]; both zero without load
/// @return [N m]
/// @throws InputError on negative arguments, or a minor axis longer than the major
double spin_moment(double friction, double load, double major, double minor);

/// Spin heat of equally loaded balls: balls * moment * speed * sin(angle) [W]. Outer-race control: the ball rolls
/// without spin on the outer ring and spins on the inner one at speed sin(angle), speed being that of the rings'
/// relative rotation.
double spin_power(double moment, int balls, double speed, double contact_angle);

/// Torque of spin of the whole bearing at one instant [N m]: sum over balls of the spin moment times sin(angle). With
/// the axis growing as Q^(1/3), proportional to the sum of Q^(4/3).
double spin_torque(const BallBearing& bearing, double friction, const std::vector<RowApproach>& rows);

/// Mean spin heat over the turn [W]: mean(torque(F) |w|). Independent of temperature (constant friction coefficient).
double spin_heat(const BallBearing& bearing, double friction, const BallLoading& loading, const Duty& duty);

/// Temperature of the parts of a bearing above that at which preload and clearance were set [K].
struct BearingWarmth {
    double inner = 0;
    double outer = 0;
    double balls = 0;
};

using deadpoint::PairArrangement;

/// Change of the approach along the contact when the parts warm [m]:
///     expansion { (t_i - t_o)/2 (pitch diameter cos(angle) -/+ distance sin(angle)) + D (t_b - (t_i + t_o)/2) }
/// the minus for back to back, the plus for face to face, distance 0 for a single row (Harris's thermal preload, with
/// the grooves' own growth sideways kept, so that even warming changes nothing). A pair back to back whose cones meet
/// in one point is not changed by a difference between the rings.
///
/// Left out: stiffness of shaft and housing, and their growth where it differs from the rings'; change of the angle.
/// @param expansion  of rings and balls [1/K]
/// @param distance   between the ball centres of the two rows along the axis [m]; not used by a single row
/// @throws InputError if the expansion is not positive or the distance negative
double thermal_approach(const BallBearing& bearing, const BearingWarmth& warmth, double expansion,
                        PairArrangement arrangement = PairArrangement::single, double distance = 0);

/// Forces of a row without outer load at a given approach; all zero if it is not positive.
struct PreloadForces {
    double ball = 0;    ///< on each ball [N]
    double axial = 0;   ///< of a row, balls * ball * sin(angle) [N]
    double radial = 0;  ///< sum over a row of the balls' radial components, balls * ball * cos(angle) [N]
};

PreloadForces preload_forces(const BallBearing& bearing, double approach);

}  // namespace deadpoint::tribology
