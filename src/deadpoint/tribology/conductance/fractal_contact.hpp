#pragma once

/// Contact of fractal rough surfaces (Majumdar and Bhushan 1991, Wang and Komvopoulos 1994) and its conductance.
namespace deadpoint::tribology {

struct ContactConductance;
struct GapFluid;

/// The equivalent rough surface of both sides, and the two solids.
struct FractalContact {
    double dimension = 0;      ///< D of a profile, between 1 and 2 [-]
    double roughness = 0;      ///< G, scaling length of the profile [m]
    double sample = 0;         ///< L_u, side of the fractal domain [m]
    double separation = 0;     ///< z, distance of the mean plane from the rigid flat before loading [m]
    double hardness = 0;       ///< H of the softer solid [Pa]
    double modulus = 0;        ///< E, contact_modulus() of both solids [Pa]
    double conductivity1 = 0;  ///< of the solids [W/m/K]
    double conductivity2 = 0;
};

/// Domain extension factor psi > 1 of the truncated spot size distribution (Wang and Komvopoulos 1994), the root of
///
///   psi^((2-D)/2) - (1 + psi^(-D/2))^(-(2-D)/D) = (2-D)/D
///
/// 2.618 as D goes to 1, 2.0007 at 1.5, e - 1 as D goes to 2.
/// @throws DomainError if D is not between 1 and 2
double domain_extension(double dimension);

/// Real contact area.
struct ContactArea {
    double share = 0;         ///< A_r* = real over nominal area [-]
    double largest_spot = 0;  ///< a_L [m2]
    double log_critical = 0;  ///< ln of a_c [m2], below which a spot is plastic; the area itself may overflow as D -> 1
    bool plastic = true;      ///< all spots plastic, a_L <= a_c; then A_r* = P/H
    bool in_range = true;     ///< false where a_L exceeds the sample's area or A_r* exceeds 0.1
};

/// Share of the area in real contact under a pressure P.
///
/// With p = psi^((2-D)/2), h = (2-D)/2, q = (3-2D)/2, a_c = G^2 (2E/H)^(2/(D-1)) and A = L_u^2, for a_L > a_c
///
///   A_r* A = p a_L^(D/2) D/(2-D) [ (a_L^h - a_c^h)/2 + a_c^h ]
///   P A    = p a_L^(D/2) { (D/2) 4/(3 sqrt(2 pi)) E G^(D-1) (a_L^q - a_c^q)/q + H D/(2-D) a_c^h }
///
/// is solved for a_L (bracketed, in ln a_L); for a_L <= a_c all spots are plastic and A_r* = P/H.
/// At D = 1.5 the quotient by q becomes ln(a_L/a_c); there the approximations usually printed (Eq.
/// 21 of Zheng et al. 2018) diverge or vanish, and they are wrong by a factor of two within |D -
/// 1.5| < 0.1. The share increases with P and is continuous where a_L passes a_c. As in the source,
/// spots above a_c are elastic and touch on half their truncated area; smaller spots are plastic.
///
/// @param pressure  nominal, P >= 0 [Pa]
/// @throws DomainError if a number is outside its range, or the share would reach 1
ContactArea fractal_area(const FractalContact& contact, double pressure);

/// Conductance of two fractal rough surfaces with a fluid in the gaps:
///
///   R'' = L_g / (A_r* k + (1 - A_r*) k_f L_g/(L_g + M)),   k = 2 k1 k2 / (k1 + k2),   h = 1 / R''
///   L_g = 2 [ z - d ],   d = psi^(-(2-D)^2/4) G^(D-1) ((4-2D)/D)^((2-D)/2) A_r*^((2-D)/2) L_u^(2-D)
///
/// Eq. 18 and 19 of Zheng et al. 2018, without the nominal area in Eq. 18 (it would give K/W), with
/// the sign of psi's exponent corrected, and with the temperature jump M of a gas added (0 for oil:
/// then exactly the printed law). d is the depth by which the largest spot is pressed in. The layer
/// is modelled as parallel columns of solid and fluid. Left out: the constriction of heat into the
/// spots, and the approach of the mean planes with load beyond d. The conductance grows with
/// pressure, also through D = 1.5 and through a_L = a_c. The separation z is rarely measured; see
/// fractal_separation().
///
/// @param pressure  P >= 0 [Pa]; at zero the gap of 2 z alone conducts
/// @throws DomainError as fractal_area, or if z does not exceed d, or nothing conducts
ContactConductance fractal_conductance(const FractalContact& contact, const GapFluid& fluid, double pressure);

/// The separation z with which the law gives a known conductance at a known pressure (`contact.separation` is ignored):
/// a calibration, not a prediction.
/// @throws DomainError as fractal_conductance, or if even touching planes conduct less
double fractal_separation(const FractalContact& contact, const GapFluid& fluid, double pressure, double conductance);

}  // namespace deadpoint::tribology
