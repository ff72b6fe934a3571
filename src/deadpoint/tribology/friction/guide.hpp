#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

/// Friction of a slide in its guides: Coulomb friction of its faces, plus shear of the oil film.
namespace deadpoint::tribology {

struct Duty;
struct Lubricant;

struct Guide {
    double friction = 0;   ///< coefficient of Coulomb friction, 0.01 .. 0.15
    double area = 0;       ///< of all oil films together; needed with a film [m2]
    double thickness = 0;  ///< of the film [m]
};

/// friction mean(N |v|) [W], N the sum of the faces' normal forces over the turn (guide_duty). A
/// slide without side force, moment and preload makes no heat. In a mirrored press the side forces
/// cancel by symmetry, so only preload or an eccentric load remains.
/// @throws InputError if the friction is negative
double guide_load_heat(const Guide& guide, const Duty& duty);

/// eta area mean(v^2) / thickness [W]: a full film of uniform thickness, Newtonian.
/// @param viscosity  dynamic [Pa s]
/// @throws InputError if area or thickness is not positive; DomainError if the viscosity is not
double guide_film_heat(const Guide& guide, const Duty& duty, double viscosity);

/// Heat of a guide over its temperature, both parts; the film's follows the dynamic viscosity rho(T) nu(T).
/// @throws InputError as its parts, or if a law of the lubricant is missing
HeatLaw guide_heat(const Guide& guide, const Duty& duty, const Lubricant& lubricant);

/// A guide without oil film.
HeatLaw guide_heat(const Guide& guide, const Duty& duty);

}  // namespace deadpoint::tribology
