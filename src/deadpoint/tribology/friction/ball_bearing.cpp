#include "deadpoint/tribology/friction/ball_bearing.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/hertz.hpp"
#include "deadpoint/tribology/friction/load_zone.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::tribology {
namespace {

double compliance(const BallBearing& bearing)
{
    return contact_compliance(bearing.youngs_modulus, bearing.poissons_ratio, bearing.youngs_modulus,
                              bearing.poissons_ratio);
}

/// @param ring  2 gamma/(1 - gamma) at the inner, -2 gamma/(1 + gamma) at the outer groove
ContactCurvature groove_curvature(double ball_diameter, double osculation, double ring)
{
    const double sum = 4 - 1 / osculation + ring;
    return {sum / ball_diameter, (1 / osculation + ring) / sum};
}

double gamma_of(const BallBearing& bearing)
{
    return bearing.ball_diameter * std::cos(bearing.contact_angle) / bearing.pitch_diameter;
}

}  // namespace

void check(const BallBearing& bearing)
{
    require_positive("ball diameter [m]", bearing.ball_diameter);
    require_positive("pitch diameter of a ball bearing [m]", bearing.pitch_diameter);
    if (bearing.rows != 1 && bearing.rows != 2)
        throw InputError(fmt::format("ball bearing: {} rows; it has 1 or 2", bearing.rows));
    if (bearing.balls < 3 || bearing.balls * bearing.ball_diameter > std::numbers::pi * bearing.pitch_diameter)
        throw InputError(
            fmt::format("ball bearing: {} balls of {} m do not fit on a pitch diameter of {} m\n  help: give "
                        "at least 3, and no more than touch each other",
                        bearing.balls, bearing.ball_diameter, bearing.pitch_diameter));
    for (const double osculation : {bearing.inner_osculation, bearing.outer_osculation})
        if (!(osculation > 0.5) || !(osculation < 1))
            throw InputError(
                fmt::format("ball bearing: osculation {} (groove radius over ball diameter) is not between "
                            "0.5 and 1\n  help: usual are 0.51 to 0.54",
                            osculation));
    if (!(bearing.contact_angle >= 0) || bearing.contact_angle >= std::numbers::pi / 2)
        throw InputError(fmt::format("ball bearing: contact angle {} rad is outside 0 .. pi/2", bearing.contact_angle));
}

ContactCurvature inner_curvature(const BallBearing& bearing)
{
    check(bearing);
    const double gamma = gamma_of(bearing);
    return groove_curvature(bearing.ball_diameter, bearing.inner_osculation, 2 * gamma / (1 - gamma));
}

ContactCurvature outer_curvature(const BallBearing& bearing)
{
    check(bearing);
    const double gamma = gamma_of(bearing);
    return groove_curvature(bearing.ball_diameter, bearing.outer_osculation, -2 * gamma / (1 + gamma));
}

ContactEllipse inner_contact(const BallBearing& bearing, double load)
{
    return contact_ellipse(inner_curvature(bearing), compliance(bearing), load);
}

ContactEllipse outer_contact(const BallBearing& bearing, double load)
{
    return contact_ellipse(outer_curvature(bearing), compliance(bearing), load);
}

RollingRow rolling_row(const BallBearing& bearing)
{
    const double both = inner_contact(bearing, 1).approach + outer_contact(bearing, 1).approach;
    return {bearing.balls, bearing.contact_angle, std::pow(both, -1.5), 1.5};
}

double preload_approach(const BallBearing& bearing, double axial_preload)
{
    return spread_single(rolling_row(bearing), 0, axial_preload).base;
}

double clearance_approach(const BallBearing& bearing, double diametral_clearance)
{
    if (!std::isfinite(diametral_clearance))
        throw InputError(fmt::format("ball bearing: clearance {} m is no number", diametral_clearance));
    return -diametral_clearance / 2 * std::cos(bearing.contact_angle);
}

std::vector<RowApproach> spread_load(const BallBearing& bearing, double radial, const BallLoading& loading)
{
    const RollingRow row = rolling_row(bearing);
    if (bearing.rows == 2)
        return spread_pair(row, radial, loading.axial, loading.base);
    if (bearing.contact_angle == 0 && loading.axial == 0)
        return {spread_radial(row, radial, loading.base)};
    return {spread_single(row, radial, loading.axial + preload_forces(bearing, loading.base).axial)};
}

double spin_moment(double friction, double load, double major, double minor)
{
    require_not_negative("friction coefficient of spin", friction);
    require_not_negative("load of a ball [N]", load);
    require_not_negative("minor semi-axis of a contact [m]", minor);
    if (load == 0 || friction == 0)
        return 0;
    require_positive("major semi-axis of a contact [m]", major);
    if (minor > major)
        throw InputError(fmt::format("spin friction: minor axis {} m is longer than the major {} m\n  help: swap them",
                                     minor, major));
    return 3.0 / 8.0 * friction * load * major * elliptic_integrals(minor / major).second;
}

double spin_power(double moment, int balls, double speed, double contact_angle)
{
    require_not_negative("spin moment [N m]", moment);
    return balls * moment * std::abs(speed) * std::sin(contact_angle);
}

double spin_torque(const BallBearing& bearing, double friction, const std::vector<RowApproach>& rows)
{
    const RollingRow row = rolling_row(bearing);
    const ContactEllipse unit = inner_contact(bearing, 1);
    const double moment_of_unit = spin_moment(friction, 1, unit.major, unit.minor);
    double loads = 0;
    for (const RowApproach& approach : rows)
        loads += summed_load(row, approach, 4.0 / 3.0);
    return moment_of_unit * loads * std::sin(bearing.contact_angle);
}

double spin_heat(const BallBearing& bearing, double friction, const BallLoading& loading, const Duty& duty)
{
    check(duty);
    double heat = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i)
        if (duty.speed[i] > 0)
            heat += duty.weight[i] * duty.speed[i] *
                    spin_torque(bearing, friction, spread_load(bearing, duty.force[i], loading));
    return heat;
}

double thermal_approach(const BallBearing& bearing, const BearingWarmth& warmth, double expansion,
                        PairArrangement arrangement, double distance)
{
    check(bearing);
    require_positive("expansion of the bearing's steel [1/K]", expansion);
    require_not_negative("distance between the rows of a pair [m]", distance);
    double across = bearing.pitch_diameter * std::cos(bearing.contact_angle);
    if (arrangement == PairArrangement::back_to_back)
        across -= distance * std::sin(bearing.contact_angle);
    if (arrangement == PairArrangement::face_to_face)
        across += distance * std::sin(bearing.contact_angle);
    const double ring_mean = (warmth.inner + warmth.outer) / 2;
    return expansion *
           ((warmth.inner - warmth.outer) / 2 * across + bearing.ball_diameter * (warmth.balls - ring_mean));
}

PreloadForces preload_forces(const BallBearing& bearing, double approach)
{
    const RollingRow row = rolling_row(bearing);
    const double ball = element_load(row, {approach, 0}, 0);
    return {ball, bearing.balls * ball * std::sin(bearing.contact_angle),
            bearing.balls * ball * std::cos(bearing.contact_angle)};
}

}  // namespace deadpoint::tribology
