#pragma once

/// Dry air at atmospheric pressure.
namespace deadpoint::surroundings {

/// Gravity in the convection formulas [m/s2].
inline constexpr double gravity = 9.81;
/// Pressure at which the properties of air hold [Pa].
inline constexpr double air_pressure = 101325;

/// Properties of dry air at 1 atm and one temperature.
struct AirProperties {
    double temperature = 0;          ///< [K]
    double conductivity = 0;         ///< k [W/m/K]
    double viscosity = 0;            ///< dynamic viscosity mu [Pa s]
    double density = 0;              ///< [kg/m3]
    double heat_capacity = 0;        ///< c_p [J/kg/K]
    double kinematic_viscosity = 0;  ///< nu = mu / rho [m2/s]
    double diffusivity = 0;          ///< thermal, k / (rho c_p) [m2/s]
    double prandtl = 0;              ///< nu / diffusivity [-]
    double expansion = 0;            ///< 1 / T [1/K]
    bool in_range = true;            ///< false outside 250..400 K
};

/// Properties of dry air: Sutherland's law for viscosity and conductivity, the ideal gas for density.
///
///   mu = 1.716e-5 (T/T0)^1.5 (T0 + 110.4) / (T + 110.4)   [Pa s]
///   k  = 0.02414  (T/T0)^1.5 (T0 + 194.4) / (T + 194.4)   [W/m/K],  T0 = 273.15 K
///   rho = p / (287.05 T), c_p = 1006 J/kg/K
///
/// Form and constants near those of White, Viscous Fluid Flow (1.716e-5, 111; 0.0241, 194; 110.4 K is that of the US
/// Standard Atmosphere 1976). Between 20 and 70 C within 1 % of the standard dry-air table (k 1.2 %), within 2 %
/// between 250 and 400 K (c_p is 1014 J/kg/K at 400 K). Left out: humidity (below 1 % on these properties in a
/// workshop), height above sea level, c_p over temperature.
///
/// @param temperature  [K]; tested 250..400, flagged outside
/// @throws DomainError outside 150..1000 K or if not finite
AirProperties air_properties(double temperature);

/// Grashof number g beta |dT| L^3 / nu^2 with all properties at the film temperature.
/// @param difference  surface minus ambient temperature, any sign [K]
/// @param length      L > 0 [m]
/// @throws DomainError if the length is not positive, or a number is not finite
double grashof(double difference, double length, const AirProperties& film);

/// Rayleigh number Gr Pr. @throws DomainError as grashof
double rayleigh(double difference, double length, const AirProperties& film);

}  // namespace deadpoint::surroundings
