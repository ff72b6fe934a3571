#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

/// Friction of plain pins and bushes: Coulomb friction under load plus shear of the oil film (Petroff).
namespace deadpoint::tribology {

struct Duty;
struct Lubricant;

struct Pin {
    double radius = 0;     ///< [m]
    double length = 0;     ///< of the bush [m]
    double clearance = 0;  ///< radial, pin to bush [m]
    double friction = 0;   ///< coefficient of Coulomb friction under the load, 0.001 (full film) .. 0.15 (boundary)
};

/// radius friction mean(F |w|) [W], w the true speed of the pin in its bush. Constant friction coefficient.
/// @throws InputError if the radius is not positive or the friction negative
double pin_load_heat(const Pin& pin, const Duty& duty);

/// 2 pi eta radius^3 length mean(w^2) / clearance [W] (Petroff): a full concentric film, Newtonian, at one temperature.
/// Left out: eccentricity, which raises the drag by 1/sqrt(1 - e^2) at relative eccentricity e, and gaps in the film.
/// @param viscosity  dynamic [Pa s]
/// @throws InputError if a size is not positive; DomainError if the viscosity is not
double pin_film_heat(const Pin& pin, const Duty& duty, double viscosity);

/// Heat of a pin over its temperature, both parts; the film's follows the dynamic viscosity rho(T) nu(T).
/// @throws InputError as its parts, or if a law of the lubricant is missing
HeatLaw pin_heat(const Pin& pin, const Duty& duty, const Lubricant& lubricant);

/// A pin without oil film.
HeatLaw pin_heat(const Pin& pin, const Duty& duty);

}  // namespace deadpoint::tribology
