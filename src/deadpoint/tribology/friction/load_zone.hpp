#pragma once

#include <vector>

/// Distribution of the load of a rolling bearing over its balls or rollers (Stribeck 1907, Sjoevall
/// 1933; Harris ch. 7).
namespace deadpoint::tribology {

/// One row of rolling elements between rigid rings.
struct RollingRow {
    int elements = 0;
    double contact_angle = 0;  ///< [rad], 0 up to (not) pi/2
    double stiffness = 0;      ///< of one element between both rings, Q = stiffness approach^exponent [N/m^exponent]
    double exponent = 1.5;     ///< 1.5 point contact, 10/9 line contact
};

/// Approach of the rings at the angle psi from the load, along the contact: base + radial cos(psi)
/// [m]; an element carries load where it is positive. The elements are smeared uniformly around the
/// row, which is the mean over all their positions.
struct RowApproach {
    double base = 0;
    double radial = 0;  ///< >= 0
};

/// Mean around the row of max(approach, 0)^exponent cos(psi)^harmonic [m^exponent].
/// @param harmonic  0 or 1
double mean_approach(const RowApproach& approach, double exponent, int harmonic);

/// Sjoevall's integrals over the load zone epsilon = (1 + base/radial) / 2:
///     J = 1/(2 pi) int (1 - (1 - cos psi) / (2 epsilon))^n cos(psi)^h dpsi
/// with h = 1 (radial) and 0 (axial). J_r(0.5) = 0.2288 for balls, so that Stribeck's largest load at no clearance is
/// Fr / (Z J_r) = 4.37 Fr / Z; he advised 5 to allow for clearance.
/// @param zone  > 0: 0.5 half the ring, 1 and more the whole ring
/// @throws InputError if zone or exponent is not positive
double radial_integral(double zone, double exponent);
double axial_integral(double zone, double exponent);

/// Load of the elements at the angle psi from the load line [N].
double element_load(const RollingRow& row, const RowApproach& approach, double psi);

/// Largest load of an element [N].
double largest_load(const RollingRow& row, const RowApproach& approach);

/// Sum over the elements of Q^power [N^power].
double summed_load(const RollingRow& row, const RowApproach& approach, double power);

double radial_force(const RollingRow& row, const RowApproach& approach);  ///< Z mean(Q cos psi) cos(angle) [N]
double axial_force(const RollingRow& row, const RowApproach& approach);   ///< Z mean(Q) sin(angle) [N]

/// The approach at which a row with given base carries a radial force.
///
/// @param force  [N], not negative
/// @param base   approach without load, along the contact [m]: positive for preload or an interference of the rings,
///               negative for clearance (half the diametral clearance times the cosine of the contact angle)
/// @throws InputError on a row without elements or stiffness, or a negative force
RowApproach spread_radial(const RollingRow& row, double force, double base);

/// The approach of a single row under radial and axial force. A row with a contact angle cannot
/// carry a radial force alone: where the axial force is below that of the half-ring zone (1.22 Fr
/// tan(angle)), the opposite bearing is assumed to add the rest, as in catalogues. With no contact
/// angle the axial force must be zero.
///
/// @throws InputError as above, or on an axial force without contact angle
RowApproach spread_single(const RollingRow& row, double radial, double axial);

/// The approaches of a matched pair (rows opposed, sharing the radial displacement) under radial and axial force.
///
/// @param axial  of any sign [N]; presses the first row together when positive
/// @param base   common preload approach, or clearance, of both rows [m]
/// @return first and second row
/// @throws InputError as above; ConvergenceError if no equilibrium is found
std::vector<RowApproach> spread_pair(const RollingRow& row, double radial, double axial, double base);

}  // namespace deadpoint::tribology
