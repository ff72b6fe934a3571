#pragma once

#include "deadpoint/tribology/friction/lubricant.hpp"

/// Friction of rolling bearings after SKF (catalogue model since 2003): rolling and sliding
/// friction with mixed lubrication, an alternative to Palmgren's law. If the oil film is thin, the
/// heat rises with temperature.
namespace deadpoint::tribology {

struct Duty;

/// The bearing's geometry and the constants of its type and series. Forces in N, sizes in mm, n in rpm, nu in mm2/s:
///     rolling  G_rr = r1 dm^1.97 (Fr + r3 dm^4 n^2 + r2 Fa)^0.54                        (angular contact balls)
///              G_rr = r1  dm^2.41 Fr^0.31                                                  (cylindrical rollers)
///     sliding  G_sl = s1 dm^0.26 ((Fr + s3 dm^4 n^2)^(4/3) + s2 Fa^(4/3))                  (angular contact balls)
///              G_sl = s1 dm^0.9 Fa + s2 dm Fr                                              (cylindrical rollers)
struct SkfBearing {
    enum class Kind { angular_contact_ball, cylindrical_roller };
    Kind kind = Kind::angular_contact_ball;
    double bore = 0;              ///< d [m]
    double outside_diameter = 0;  ///< D [m]
    double r1 = 0;
    double r2 = 0;
    double r3 = 0;
    double s1 = 0;
    double s2 = 0;
    double s3 = 0;
    double geometry = 0;       ///< K_Z
    double replenishment = 0;  ///< K_rs: 3e-8 low level oil bath and jet, 6e-8 grease and oil-air
    double film_friction = 0;  ///< coefficient at full film: 0.05 mineral oil, 0.02 cylindrical rollers
};

/// Single row of angular contact balls in an oil bath: r 5.03e-7, 1.97, 1.9e-12; s 1.3e-2, 0.68, 1.91e-12; K_Z 4.4.
/// @throws InputError unless 0 < bore < outside diameter
SkfBearing skf_angular_contact(double bore, double outside_diameter);

/// Cylindrical rollers with cage of dimension series 10 in an oil bath: r1 1.12e-6; s 0.16, 0.0015; K_Z 5.1. Other
/// series have other r1 and s1.
/// @throws InputError unless 0 < bore < outside diameter
SkfBearing skf_cylindrical_roller(double bore, double outside_diameter);

struct SkfTorque {
    double rolling = 0;         ///< M_rr, with both factors below [N m]
    double sliding = 0;         ///< M_sl [N m]
    double inlet_heating = 1;   ///< phi_ish = 1 / (1 + 1.84e-9 (n dm)^1.28 nu^0.64)
    double replenishment = 1;   ///< phi_rs = exp(-K_rs nu n (d + D) sqrt(K_Z / (2 (D - d))))
    double boundary_share = 1;  ///< phi_bl = exp(-2.6e-8 (n nu)^1.4 dm)
    double total = 0;           ///< M_rr + M_sl [N m]
    double slope = 0;           ///< of the total by the viscosity [N s/m]
};

/// M_rr = phi_ish phi_rs G_rr (nu n)^0.6 and M_sl = G_sl (0.15 phi_bl + mu (1 - phi_bl)), mu at full film.
///
/// Left out: seals, drag in an oil bath deeper than the lowest ball, running-in.
/// @param speed          of the rings to each other, any sign [rad/s]
/// @param viscosity      kinematic [m2/s]
/// @param radial, axial  magnitudes, preload counted in the axial force [N]
/// @throws InputError on sizes or forces; DomainError if the viscosity is not positive and finite
SkfTorque skf_torque(const SkfBearing& bearing, double speed, double viscosity, double radial, double axial);

/// Heat of one bearing over its temperature: mean(M(F, |w|, nu(T)) |w|) over the turn. The model is
/// meant for steady rotation; in a swing it is evaluated at each instant. In range where the
/// viscosity is.
///
/// @param axial  constant axial force, preload included [N]
/// @throws InputError as the torque, or without viscosity
HeatLaw skf_heat(const SkfBearing& bearing, const Duty& duty, double axial, const ViscosityLaw& viscosity);

}  // namespace deadpoint::tribology
