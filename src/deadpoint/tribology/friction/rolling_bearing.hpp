#pragma once

#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/tribology/friction/lubricant.hpp"

/// Friction of rolling bearings after Palmgren (Harris, Rolling Bearing Analysis): load torque M1 and viscous torque
/// M0. The spin of balls is in ball_bearing.hpp, the model of SKF in skf.hpp.
namespace deadpoint::tribology {

struct Duty;

using deadpoint::BearingType;
using deadpoint::OilSupply;

/// Table of static load factors for an angular contact bearing: ISO 76, or Zheng et al. 2018, Table
/// 4, which has 0.47 in place of 0.46 at 15 degrees and ends at 15 and 40 degrees.
enum class StaticTable { iso_76, zheng_2018 };

/// P0 = radial Fr + axial Fa, and not less than Fr.
struct StaticFactors {
    double radial = 0;  ///< X0
    double axial = 0;   ///< Y0
};

/// Static factors by type (ISO 76), linear in the contact angle between the tabulated ones for angular contact balls; a
/// pair has X0 = 1 and Y0 doubled.
///
/// @param contact_angle  [rad]; angular contact balls: 5 .. 45 degrees (15 .. 40 in the table of Zheng et al.); tapered
///                       and spherical rollers: above 0; else unused
/// @throws InputError outside of the table
StaticFactors static_factors(BearingType type, double contact_angle, StaticTable table = StaticTable::iso_76);

/// Lubrication factor f0 [-] in the middle of the range that makers' tables give (oil bath: deep groove 2, angular
/// contact 3.3, pair 6.5, cylindrical 3, needle 12, tapered 6, spherical 6, the last between 3.5 and 7).
double lubrication_factor(BearingType type, OilSupply supply);

/// Data of a bearing for Palmgren's formulas.
struct PalmgrenBearing {
    double mean_diameter = 0;       ///< of bore and outside [m]
    double static_rating = 0;       ///< C0 [N]
    double lubrication_factor = 0;  ///< f0, 0.5 .. 26
    double load_factor = 0;         ///< f1 = load_factor (P0/C0)^load_exponent
    double load_exponent = 0;
    double torque_axial = 0;  ///< P1 = torque_axial Fa + torque_radial Fr, and not less than Fr
    double torque_radial = 0;
    StaticFactors statics;
};

/// A bearing with the factors of its type: f1 = 0.001 (P0/C0)^0.33 and P1 = Fa - 0.1 Fr for angular contact balls
/// (pair: 1.4 Fa - 0.1 Fr); 0.0006 (P0/C0)^0.55 and 3 Fa - 0.1 Fr for deep groove balls; constant f1 for rollers
/// (cylindrical 0.0003, needle 0.002, tapered 0.0004, spherical 0.0005), with P1 = Fr or, tapered and spherical, 0.8 Fa
/// / tan(angle). Flange friction of axially loaded cylindrical rollers is left out.
///
/// @param contact_angle  [rad]
/// @param mean_diameter  [m]
/// @param static_rating  C0 [N]
/// @throws InputError if a size is not positive, or the angle is outside static_factors()
PalmgrenBearing palmgren_bearing(BearingType type, OilSupply supply, double contact_angle, double mean_diameter,
                                 double static_rating, StaticTable table = StaticTable::iso_76);

struct EquivalentLoads {
    double static_load = 0;  ///< P0 [N]
    double torque_load = 0;  ///< P1 [N]
};

/// P0 and P1 with both minimum rules (P0 >= Fr, P1 >= Fr): without the second, P1 is negative for a pure radial load.
/// @param radial, axial  magnitudes, a preload counted in the axial force [N]
/// @throws InputError if negative
EquivalentLoads equivalent_loads(const PalmgrenBearing& bearing, double radial, double axial);

/// M1 = f1 P1 dm [N m], f1 = load_factor (P0/C0)^load_exponent.
/// @throws InputError on a bearing without mean diameter or, where the exponent needs it, static rating
double palmgren_load_torque(const PalmgrenBearing& bearing, const EquivalentLoads& loads);

struct ViscousTorque {
    double torque = 0;        ///< [N m]
    double slope = 0;         ///< derivative by the viscosity [N s/m]
    bool low_branch = false;  ///< nu n < 2000: drag no longer depends on viscosity
};

constexpr double palmgren_branch = 2000;  ///< of nu n [mm2/s rpm]

/// M0 = 1e-7 f0 (nu n)^(2/3) dm^3 [N mm] where nu n >= 2000, else 160e-7 f0 dm^3, with n in rpm, nu
/// in mm2/s, dm in mm; evaluated in SI. At the transition the first gives 158.74e-7: on slowing or
/// warming, the torque steps up by 0.8 %, as in the source.
///
/// @param lubrication_factor  f0
/// @param mean_diameter       [m]
/// @param viscosity           kinematic [m2/s]
/// @param speed               of the rings to each other, any sign [rad/s]; the torque holds down to rest
/// @throws InputError on factor or diameter; DomainError if the viscosity is not positive and finite
ViscousTorque palmgren_viscous_torque(double lubrication_factor, double mean_diameter, double viscosity, double speed);

/// Heat of one bearing over its temperature: mean(M1(F) |w|) + mean(M0(nu(T), |w|) |w|), both
/// averaged over the turn, each sample on its own branch. A bearing that swings back and forth
/// passes the branch twice a swing; its heat then has steps, which are smaller with more samples
/// per turn. The derivative is that between steps. In range where the viscosity is.
///
/// Left out: spin (add spin_heat), seals, churning in a deep sump, starvation.
/// @param axial  constant axial force, preload included [N]
/// @throws InputError as the parts; if the bearing carries no viscosity law
HeatLaw palmgren_heat(const PalmgrenBearing& bearing, const Duty& duty, double axial, const ViscosityLaw& viscosity);

}  // namespace deadpoint::tribology
