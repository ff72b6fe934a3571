#include "deadpoint/tribology/friction/skf.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/units.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::tribology {
namespace {

constexpr double millimetre = 1e-3;
constexpr double newton_millimetre = 1e-3;
constexpr double boundary_friction = 0.15;
constexpr double oil_bath_replenishment = 3e-8;

void check(const SkfBearing& bearing)
{
    require_positive("bore of a rolling bearing [m]", bearing.bore);
    if (!(bearing.outside_diameter > bearing.bore) || !std::isfinite(bearing.outside_diameter))
        throw InputError(fmt::format("rolling bearing: outside diameter {} m is not larger than the bore {} m",
                                     bearing.outside_diameter, bearing.bore));
}

double rolling_variable(const SkfBearing& b, double dm, double n, double radial, double axial)
{
    if (b.kind == SkfBearing::Kind::cylindrical_roller)
        return b.r1 * std::pow(dm, 2.41) * std::pow(radial, 0.31);
    const double centrifugal = b.r3 * std::pow(dm, 4) * n * n;
    return b.r1 * std::pow(dm, 1.97) * std::pow(radial + centrifugal + b.r2 * axial, 0.54);
}

double sliding_variable(const SkfBearing& b, double dm, double n, double radial, double axial)
{
    if (b.kind == SkfBearing::Kind::cylindrical_roller)
        return b.s1 * std::pow(dm, 0.9) * axial + b.s2 * dm * radial;
    const double centrifugal = b.s3 * std::pow(dm, 4) * n * n;
    return b.s1 * std::pow(dm, 0.26) * (std::pow(radial + centrifugal, 4.0 / 3.0) + b.s2 * std::pow(axial, 4.0 / 3.0));
}

}  // namespace

SkfBearing skf_angular_contact(double bore, double outside_diameter)
{
    SkfBearing bearing{SkfBearing::Kind::angular_contact_ball, bore, outside_diameter};
    bearing.r1 = 5.03e-7;
    bearing.r2 = 1.97;
    bearing.r3 = 1.9e-12;
    bearing.s1 = 1.3e-2;
    bearing.s2 = 0.68;
    bearing.s3 = 1.91e-12;
    bearing.geometry = 4.4;
    bearing.replenishment = oil_bath_replenishment;
    bearing.film_friction = 0.05;
    check(bearing);
    return bearing;
}

SkfBearing skf_cylindrical_roller(double bore, double outside_diameter)
{
    SkfBearing bearing{SkfBearing::Kind::cylindrical_roller, bore, outside_diameter};
    bearing.r1 = 1.12e-6;
    bearing.s1 = 0.16;
    bearing.s2 = 0.0015;
    bearing.geometry = 5.1;
    bearing.replenishment = oil_bath_replenishment;
    bearing.film_friction = 0.02;
    check(bearing);
    return bearing;
}

SkfTorque skf_torque(const SkfBearing& bearing, double speed, double viscosity, double radial, double axial)
{
    check(bearing);
    require_not_negative("radial force of a rolling bearing [N]", radial);
    require_not_negative("axial force of a rolling bearing [N]", axial);
    require_positive_state("oil viscosity [m2/s]", viscosity);
    const double d = bearing.bore / millimetre;
    const double D = bearing.outside_diameter / millimetre;
    const double dm = (d + D) / 2;
    const double n = std::abs(speed) / turn_per_minute;
    const double nu = viscosity / square_millimetre;

    const double heating = 1.84e-9 * std::pow(n * dm, 1.28) * std::pow(nu, 0.64);
    const double starvation = bearing.replenishment * nu * n * (d + D) * std::sqrt(bearing.geometry / (2 * (D - d)));
    const double film = 2.6e-8 * std::pow(n * nu, 1.4) * dm;

    SkfTorque result;
    result.inlet_heating = 1 / (1 + heating);
    result.replenishment = std::exp(-starvation);
    result.boundary_share = std::exp(-film);
    result.rolling = newton_millimetre * result.inlet_heating * result.replenishment *
                     rolling_variable(bearing, dm, n, radial, axial) * std::pow(nu * n, 0.6);
    const double sliding = newton_millimetre * sliding_variable(bearing, dm, n, radial, axial);
    result.sliding =
        sliding * (boundary_friction * result.boundary_share + bearing.film_friction * (1 - result.boundary_share));
    result.total = result.rolling + result.sliding;

    // Each factor is a power or an exponential of nu, so that nu dM/dnu is M times its logarithmic derivative.
    const double rolling_log_slope = 0.6 - 0.64 * heating * result.inlet_heating - starvation;
    const double sliding_change =
        sliding * (boundary_friction - bearing.film_friction) * result.boundary_share * -1.4 * film;
    result.slope = (result.rolling * rolling_log_slope + sliding_change) / viscosity;
    return result;
}

HeatLaw skf_heat(const SkfBearing& bearing, const Duty& duty, double axial, const ViscosityLaw& viscosity)
{
    check(bearing);
    check(duty);
    require_not_negative("axial force of a rolling bearing [N]", axial);
    if (!viscosity)
        throw InputError("rolling bearing: its friction needs a lubricant\n  help: name one");
    return [bearing, duty, axial, viscosity](double temperature) {
        const LawValue nu = viscosity(temperature);
        LawValue heat{0, 0, nu.in_range};
        for (std::size_t i = 0; i < duty.weight.size(); ++i) {
            if (duty.speed[i] == 0)
                continue;
            const SkfTorque torque = skf_torque(bearing, duty.speed[i], nu.value, duty.force[i], axial);
            heat.value += duty.weight[i] * duty.speed[i] * torque.total;
            heat.slope += duty.weight[i] * duty.speed[i] * torque.slope * nu.slope;
        }
        return heat;
    };
}

}  // namespace deadpoint::tribology
