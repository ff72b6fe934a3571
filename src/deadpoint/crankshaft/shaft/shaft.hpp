#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Description of the crankshaft on its bearings, in SI units.
///
/// Axes: s along the shaft, x and y across it as in the machine (y up). The spin is positive from x to y.
namespace deadpoint::crankshaft {

struct Section {
    double length = 0;          ///< [m]
    double diameter = 0;        ///< [m]
    double bore = 0;            ///< [m]
    double density = 0;         ///< [kg/m3]; 0 keeps the stiffness without the mass
    double shear_factor = 0.9;  ///< Timoshenko's, 0..1; 0: no shear deformation
};

/// A mass off the axis that rotates with the shaft, in addition to the disks: the crank throw and
/// its counterweights.
struct Unbalance {
    double position = 0;   ///< along s [m]
    double magnitude = 0;  ///< mass times distance from the axis [kg m]
    double angle = 0;      ///< from the crank throw, in the sense from x to y [rad]
};

struct Disk {
    double position = 0;  ///< along s [m]
    double mass = 0;
    double polar_inertia = 0;      ///< [kg m2]
    double diametral_inertia = 0;  ///< [kg m2]
    double unbalance = 0;          ///< mass times eccentricity [kg m]
    double unbalance_angle = 0;    ///< from the crank throw [rad]
};

/// Stiffness or damping between shaft and housing (or ground): {{xx, xy}, {yx, yy}}.
using Matrix2 = std::array<std::array<double, 2>, 2>;

struct Bearing {
    std::string name;
    double position = 0;                       ///< along s [m]
    Matrix2 stiffness{};                       ///< [N/m]
    Matrix2 damping{};                         ///< [N s/m]
    double housing_mass = 0;                   ///< [kg]; used only with a support
    std::optional<Matrix2> support_stiffness;  ///< housing to ground; absent: housing is rigid [N/m]
    Matrix2 support_damping{};
    double hertz_exponent = 1;  ///< n of F = K d^n, linearised at the mean load; 1: stiffness as given
    double reference_load = 0;  ///< at which the given stiffness holds, used with an exponent other than 1 [N]
};

struct Shaft {
    double youngs_modulus = 0;
    double poissons_ratio = 0;
    double start = 0;          ///< s of the first section's free end [m]
    double axial_load = 0;     ///< tension positive [N]
    double modal_damping = 0;  ///< ratio, of every mode
    std::vector<Section> sections;
    std::vector<Disk> disks;
    std::vector<Bearing> bearings;
    std::vector<Unbalance> unbalances;
};

}  // namespace deadpoint::crankshaft
