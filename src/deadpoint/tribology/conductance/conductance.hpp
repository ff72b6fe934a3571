#pragma once

#include <string>
#include <vector>

/// Thermal conductance of the interfaces between touching parts.
namespace deadpoint::tribology {

/// Conductance of an interface per area, with its validity.
struct ContactConductance {
    double conductance = 0;          ///< h = 1 / R'' [W/m2/K]
    bool in_range = true;            ///< false outside the law's tested range
    std::vector<std::string> notes;  ///< one sentence per reason

    [[nodiscard]] double resistance() const { return 1 / conductance; }  ///< R'' [m2 K/W]
};

/// Fluid in the gaps between two surfaces.
struct GapFluid {
    double conductivity = 0;  ///< k_f [W/m/K]; oil about 0.14, air 0.026
    /// Temperature jump of a rarefied gas at both walls, as an additional gap M [m]; 0 for oil.
    double jump = 0;
};

/// M = alpha beta Lambda of a gas (Kennard; Yovanovich 1986), alpha = (2 - a1)/a1 + (2 - a2)/a2,
/// beta = 2 gamma / (Pr (1 + gamma)).
/// @param mean_free_path  Lambda [m]; air at 1 atm and 20 C: 6.8e-8
/// @param accommodation1  thermal accommodation coefficients a1, a2 of both walls, 0..1; engineering surfaces in air
/// 0.87..0.97
/// @param heat_ratio      gamma = c_p / c_v, air 1.4
/// @throws DomainError outside these ranges
double gas_jump(double mean_free_path, double accommodation1, double accommodation2, double heat_ratio, double prandtl);

/// Harmonic mean 2 k1 k2 / (k1 + k2) [W/m/K] of the two solids. @throws DomainError if one is not positive
double harmonic_conductivity(double k1, double k2);

/// Modulus of two solids in contact, 1 / ((1 - nu1^2)/E1 + (1 - nu2^2)/E2) [Pa].
/// @throws DomainError if a modulus is not positive or a Poisson ratio leaves -1..0.5
double contact_modulus(double modulus1, double poisson1, double modulus2, double poisson2);

/// A conductance that the user knows.
/// @throws DomainError if it is not positive and finite
ContactConductance direct_conductance(double conductance);

/// Fluid film between parallel faces: h = k / (t + M), without flow along the film (an oil circuit
/// describes that).
/// @param thickness  t > 0 [m]; tested 1e-7..1e-3, above that the fluid itself moves
/// @throws DomainError if the thickness or conductivity is not positive
ContactConductance film_conductance(const GapFluid& fluid, double thickness);

/// Oil film of a journal that lies eccentrically in its bush: the mean of k / (c (1 + e cos phi)) around the bush,
///
///   h = k / (c sqrt(1 - e^2))
///
/// exact for a film thin against the radius, with both faces at one temperature each around the circumference.
/// @param clearance     radial, c > 0 [m]
/// @param eccentricity  e = 0..1 of the clearance [-]; flagged above 0.98, where the film ends in touching asperities
/// @throws DomainError outside these ranges (e = 1 would conduct without limit)
ContactConductance journal_film_conductance(double oil_conductivity, double clearance, double eccentricity);

/// Two rough surfaces for the law of Cooper, Mikic and Yovanovich.
struct RoughContact {
    double roughness = 0;      ///< sigma, root mean square height of both surfaces combined [m]
    double slope = 0;          ///< m, mean absolute slope of both combined [-]
    double hardness = 0;       ///< H of the softer solid at its surface [Pa]
    double conductivity1 = 0;  ///< of the solids [W/m/K]
    double conductivity2 = 0;
};

/// Estimate of the mean slope m = 0.076 (sigma / 1 um)^0.52 if it was not measured (Lambert and
/// Fletcher 1997; the data scatter by a factor of about two). @throws DomainError if the roughness
/// is not positive
double slope_of_roughness(double roughness);

/// Plastic contact of conforming rough surfaces with a fluid in the gaps (Cooper, Mikic, Yovanovich 1969; Yovanovich
/// 1986 for the gap):
///
///   h = 1.25 k_s (m / sigma) (P/H)^0.95 + k_f / (Y + M),   Y = 1.53 sigma (P/H)^-0.097,   k_s = 2 k1 k2 / (k1 + k2)
///
/// Tested for P/H = 1e-5..2e-2, flagged outside; below 1e-5 the gap keeps its value there, so that a joint without
/// pressure still conducts through its fluid. Left out: unloading hysteresis, waviness, oxide layers, radiation.
/// @param pressure  P >= 0 [Pa]
/// @throws DomainError if P reaches H, or roughness, slope, hardness or a conductivity is not positive
ContactConductance rough_conductance(const RoughContact& contact, const GapFluid& fluid, double pressure);

}  // namespace deadpoint::tribology
