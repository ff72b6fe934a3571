#include "deadpoint/tribology/friction/calibrated.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/rolling_bearing.hpp"
#include "deadpoint/tribology/units.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::tribology {
namespace {

constexpr double least_speed_factor = 160;  // Palmgren, instead of (nu n)^(2/3)
constexpr double palmgren_exponent = 2.0 / 3.0;

double load_exponent(FrictionKind kind) { return kind == FrictionKind::rolling ? rolling_load_exponent : 1.0; }

double viscous_speed_exponent(FrictionKind kind) { return kind == FrictionKind::rolling ? rolling_drag_exponent : 2.0; }

void check(const CalibratedFriction& friction, bool has_lubricant)
{
    const auto wrong = [](double value) { return !std::isfinite(value) || value < 0; };
    if (wrong(friction.load_part) || wrong(friction.viscous_part) || wrong(friction.scale) ||
        !std::isfinite(friction.exponent))
        throw InputError(
            fmt::format("friction law: load part {} W, viscous part {} W and scale {} must not be negative",
                        friction.load_part, friction.viscous_part, friction.scale));
    if (!(friction.reference_speed > 0) || !std::isfinite(friction.reference_speed))
        throw InputError(
            "friction law: give the speed at which it was calibrated (reference_speed), greater than zero");
    if (friction.viscous_part > 0 && !has_lubricant)
        throw InputError("friction law: a viscous part needs a lubricant; name one, or set viscous_part to zero");
}

/// Viscosity below which Palmgren's law takes its low branch at a speed other than zero [m2/s]; zero where the law is
/// not Palmgren's.
double branch_viscosity(const CalibratedFriction& friction, double speed)
{
    constexpr double rounding = 1e-3;  // of an exponent written as 0.667
    if (friction.kind != FrictionKind::rolling || std::abs(friction.exponent - palmgren_exponent) > rounding)
        return 0;
    return palmgren_branch * square_millimetre * turn_per_minute / std::abs(speed);
}

double ratio_of(double now, double reference, const char* what)
{
    if (!(reference > 0))
        throw InputError(
            fmt::format("calibrated friction: at the reference the joint has no {}, so there is nothing to "
                        "scale from\n  help: take a reference where it has",
                        what));
    return now / reference;
}

}  // namespace

DutyRatio speed_ratio(const CalibratedFriction& friction, double speed, double load_ratio)
{
    check(friction, true);
    require_not_negative("speed of the crank, its sign dropped [rad/s]", std::abs(speed));
    require_not_negative("force over that of the reference", load_ratio);
    const double s = std::abs(speed) / friction.reference_speed;
    return {s * std::pow(load_ratio, load_exponent(friction.kind)), std::pow(s, viscous_speed_exponent(friction.kind))};
}

DutyRatio duty_ratio(FrictionKind kind, const Duty& now, const Duty& reference)
{
    const double drag = viscous_speed_exponent(kind);
    const double load = load_exponent(kind);
    return {ratio_of(duty_mean(now, load, 1), duty_mean(reference, load, 1), "load while it moves"),
            ratio_of(duty_mean(now, 0, drag), duty_mean(reference, 0, drag), "motion")};
}

HeatParts heat_parts(const CalibratedFriction& friction, const DutyRatio& ratio)
{
    check(friction, true);
    require_not_negative("factor on the load part", ratio.load);
    require_not_negative("factor on the viscous part", ratio.viscous);
    return {friction.scale * friction.load_part * ratio.load, friction.scale * friction.viscous_part * ratio.viscous};
}

HeatLaw viscous_shape(const CalibratedFriction& friction, const ViscosityLaw& viscosity, double speed)
{
    const double branch = branch_viscosity(friction, speed);
    const double low = std::pow(branch / square_millimetre, palmgren_exponent) * least_speed_factor /
                       std::pow(palmgren_branch, palmgren_exponent);
    return [low, branch, p = friction.exponent, viscosity](double temperature) {
        const LawValue nu = viscosity(temperature);
        if (nu.value < branch)
            return LawValue{low, 0, nu.in_range};
        const double part = std::pow(nu.value / square_millimetre, p);
        return LawValue{part, part * p * nu.slope / nu.value, nu.in_range};
    };
}

HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityLaw& viscosity, double speed,
                        const DutyRatio& ratio)
{
    check(friction, static_cast<bool>(viscosity));
    const auto parts = heat_parts(friction, ratio);
    require_not_negative("speed of the crank, its sign dropped [rad/s]", std::abs(speed));
    if (speed == 0)
        return constant_heat(0);
    if (parts.viscous == 0)
        return constant_heat(parts.load);
    return [parts, shape = viscous_shape(friction, viscosity, speed)](double temperature) {
        const LawValue value = shape(temperature);
        return LawValue{parts.load + parts.viscous * value.value, parts.viscous * value.slope, value.in_range};
    };
}

HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityCurve* viscosity, double speed)
{
    return calibrated_heat(friction, viscosity ? ViscosityLaw(*viscosity) : ViscosityLaw(), speed,
                           speed_ratio(friction, speed));
}

}  // namespace deadpoint::tribology
