#pragma once

#include "deadpoint/exchange/laws.hpp"

#include <string>
#include <vector>

/// Friction heat by a calibrated law of the temperature, and the viscosity that drives it.
namespace deadpoint::tribology {

/// Kinematic viscosity over temperature: ln nu is linear between the points and goes on with the end slopes beyond
/// them, where it is flagged as out of range.
class ViscosityCurve {
public:
    /// @param temperature  increasing, at least two points [K]
    /// @param viscosity    as many, positive [m2/s]
    /// @throws InputError  if the points are fewer than two, do not increase, or a viscosity is not positive
    ViscosityCurve(std::vector<double> temperature, std::vector<double> viscosity);

    /// Viscosity [m2/s] and its derivative [m2/s/K]; at a point, the derivative of the side above it.
    [[nodiscard]] LawValue operator()(double temperature) const;

private:
    std::vector<double> temperature_;
    std::vector<double> log_viscosity_;
};

/// How the two parts of the heat scale with speed.
enum class FrictionKind {
    rolling,  ///< load part ~ n, viscous part ~ n^(5/3) (Palmgren)
    pin,      ///< load part ~ n, viscous part ~ n^2 (Coulomb and Petroff)
    guide     ///< load part ~ n; viscous part ~ n^2, usually zero
};

/// @throws InputError if the name is not "rolling", "pin" or "guide"
FrictionKind friction_kind(const std::string& name);

/// A friction law H(T) = c0 s + c1 s^q (nu(T) / 1 mm2/s)^p with s = speed / reference speed, and q = 5/3 or 2 by kind.
struct CalibratedFriction {
    FrictionKind kind = FrictionKind::pin;
    double load_part = 0;        ///< c0 [W]
    double viscous_part = 0;     ///< c1 [W]
    double exponent = 1;         ///< p [-]
    double reference_speed = 0;  ///< at which c0 and c1 hold [rad/s]
    double scale = 1;            ///< factor on the whole heat [-]
};

/// The friction heat of a joint at one speed, as a curve over the joint's temperature.
///
/// The two-part form is the decomposition of Table 5 of Zheng et al. 2018, exact to the digits printed there. Left out:
/// the load (the load part holds at the reference load), and the branch of Palmgren's law below nu n = 2000 mm2/s rpm,
/// where the viscous part would go with n and no viscosity. Out of range where the viscosity is.
///
/// @param friction   the law
/// @param viscosity  of the joint's lubricant; may be null where the viscous part is zero
/// @param speed      of the crank, any sign [rad/s]; at zero speed there is no heat
/// @throws InputError if a part or the scale is negative or not finite, the reference speed is not positive, or a
/// viscous
///         part has no lubricant
HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityCurve* viscosity, double speed);

}  // namespace deadpoint::tribology
