#pragma once

#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/tribology/friction/lubricant.hpp"

/// Friction heat by a calibrated law of the temperature, scaled from the reference state of the
/// calibration.
namespace deadpoint::tribology {

struct Duty;

using deadpoint::FrictionKind;

/// A friction law H(T) = c0 s + c1 s^q (nu(T) / 1 mm2/s)^p with s = speed / reference speed, and q = 5/3 or 2 by kind.
struct CalibratedFriction {
    FrictionKind kind = FrictionKind::pin;
    double load_part = 0;        ///< c0 [W]
    double viscous_part = 0;     ///< c1 [W]
    double exponent = 1;         ///< p [-]
    double reference_speed = 0;  ///< at which c0 and c1 hold [rad/s]
    double scale = 1;            ///< factor on the whole heat [-]
};

/// Duty of a joint relative to the reference: factors on the parts of its heat, all 1 at the
/// reference.
struct DutyRatio {
    double load = 1;     ///< of mean(F^1.33 |w|) (rolling) or mean(F |w|) (pin, guide)
    double viscous = 1;  ///< of mean(|w|^(5/3)) (rolling) or mean(w^2) (pin, guide)
};

/// The same path at another speed of the crank, and another force: load s f^1.33 (rolling) or s f, viscous s^(5/3) or
/// s^2, with s the ratio of speeds (sign dropped) and f that of forces.
/// @param load_ratio  f, force over the force of the reference, not negative
/// @throws InputError if the reference speed is not positive, the speed not finite, or the load ratio negative
DutyRatio speed_ratio(const CalibratedFriction& friction, double speed, double load_ratio = 1);

/// From the joint's duty now and at the reference, which may differ in force, stiffness or linkage.
/// For the peak load measure, pass duties through measured() first.
/// @throws InputError if at the reference the joint does not move, or carries no load
DutyRatio duty_ratio(FrictionKind kind, const Duty& now, const Duty& reference);

/// The heat of a joint at given duty [W]: load + viscous shape(T).
struct HeatParts {
    double load = 0;     ///< scale c0 load
    double viscous = 0;  ///< scale c1 viscous, at a viscosity of 1 mm2/s
};

/// @throws InputError if a part, the scale or a factor is negative or not finite
HeatParts heat_parts(const CalibratedFriction& friction, const DutyRatio& ratio);

/// Viscous heat over that at 1 mm2/s: (nu(T)/1 mm2/s)^p, of a rolling part with its low branch (see below). Joints
/// share it that share lubricant and exponent, rolling ones the speed besides.
/// @param friction  its kind and exponent; the rest is not read
/// @param speed     not zero
HeatLaw viscous_shape(const CalibratedFriction& friction, const ViscosityLaw& viscosity, double speed);

/// The friction heat of a joint at given duty, as a curve over the joint's temperature:
///     scale (c0 load + c1 viscous (nu(T)/1 mm2/s)^p)
///
/// The two-part form is the decomposition of Table 5 of Zheng et al. 2018, exact to the digits
/// printed there. A rolling part with p = 2/3 follows Palmgren's law to its low branch: where nu n
/// < 2000 mm2/s rpm, n the crank's speed, it stays at 160/2000^(2/3) = 1.008 times its value at
/// nu = 2000 mm2/s rpm / n; at a duty of the same course it then goes with speed and no viscosity.
/// Out of range where the viscosity is. Left out: load in the viscous part, and sliding that the
/// duty does not contain.
///
/// @param friction   the law
/// @param viscosity  kinematic, of the joint's lubricant; may be empty where the viscous part is zero
/// @param speed      of the crank, any sign [rad/s]; decides the branch, and at zero there is no heat
/// @param ratio      factors not negative
/// @throws InputError if a part, the scale or a factor is negative or not finite, the reference speed is not positive,
///         or a viscous part has no lubricant
HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityLaw& viscosity, double speed,
                        const DutyRatio& ratio);

/// The same at the load of the reference.
///
/// @param viscosity  of the joint's lubricant; may be null where the viscous part is zero
/// @param speed      of the crank, any sign [rad/s]; at zero speed there is no heat
/// @throws InputError as above
HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityCurve* viscosity, double speed);

}  // namespace deadpoint::tribology
