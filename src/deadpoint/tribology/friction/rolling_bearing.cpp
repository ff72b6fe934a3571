#include "deadpoint/tribology/friction/rolling_bearing.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace deadpoint::tribology {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double millimetre_cubed_torque = 1e6;  // N m per m^3 instead of N mm per mm^3
constexpr double high_branch_factor = 1e-7;
constexpr double low_branch_factor = 160e-7;

struct AngleRow {
    double angle;  ///< [degrees]
    double axial;  ///< Y0 of a single row
};

constexpr std::array<AngleRow, 9> iso_76_rows{
    {{5, 0.52}, {10, 0.50}, {15, 0.46}, {20, 0.42}, {25, 0.38}, {30, 0.33}, {35, 0.29}, {40, 0.26}, {45, 0.22}}};
constexpr std::array<AngleRow, 6> zheng_2018_rows{
    {{15, 0.47}, {20, 0.42}, {25, 0.38}, {30, 0.33}, {35, 0.29}, {40, 0.26}}};

template <std::size_t count>
double axial_factor(const std::array<AngleRow, count>& rows, double contact_angle)
{
    constexpr double rounding = 1e-9;
    const double angle = contact_angle / degree;
    if (!(angle >= rows.front().angle - rounding && angle <= rows.back().angle + rounding))
        throw InputError(fmt::format("static load factors: contact angle {:g} degrees is outside the table, {} to {} "
                                     "degrees\n  help: give the bearing's own X0 and Y0",
                                     angle, rows.front().angle, rows.back().angle));
    for (std::size_t i = 1; i + 1 < count; ++i)
        if (angle < rows[i].angle) {
            const double share = (angle - rows[i - 1].angle) / (rows[i].angle - rows[i - 1].angle);
            return rows[i - 1].axial + share * (rows[i].axial - rows[i - 1].axial);
        }
    const double share = (angle - rows[count - 2].angle) / (rows[count - 1].angle - rows[count - 2].angle);
    return rows[count - 2].axial + share * (rows[count - 1].axial - rows[count - 2].axial);
}

double cotangent(double contact_angle)
{
    if (!(contact_angle > 0) || !(contact_angle < std::numbers::pi / 2))
        throw InputError(fmt::format("roller bearing: contact angle {} rad is not between 0 and pi/2", contact_angle));
    return 1 / std::tan(contact_angle);
}

struct LoadRule {
    double factor;
    double exponent;
    double axial;
    double radial;
};

LoadRule load_rule(BearingType type, double contact_angle)
{
    switch (type) {
    case BearingType::deep_groove_ball:
        return {0.0006, 0.55, 3, -0.1};
    case BearingType::angular_contact_ball:
        return {0.001, 0.33, 1, -0.1};
    case BearingType::angular_contact_ball_pair:
        return {0.001, 0.33, 1.4, -0.1};
    case BearingType::cylindrical_roller:
        return {0.0003, 0, 0, 1};
    case BearingType::needle_roller:
        return {0.002, 0, 0, 1};
    case BearingType::tapered_roller:
        return {0.0004, 0, 0.8 * cotangent(contact_angle), 0};
    case BearingType::spherical_roller:
        return {0.0005, 0, 0.8 * cotangent(contact_angle), 0};
    }
    throw InputError("rolling bearing: unknown type");
}

/// nu n in mm2/s rpm.
double branch_number(double viscosity, double speed)
{
    return viscosity / square_millimetre * std::abs(speed) / turn_per_minute;
}

/// Sums over the turn that give the viscous heat at any viscosity: samples on the low branch are the slow ones.
class SpeedSpectrum {
public:
    explicit SpeedSpectrum(const Duty& duty) : speed_(duty.speed.size()), slow_(1, 0.0), fast_(1, 0.0)
    {
        std::vector<std::size_t> order(duty.speed.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](auto a, auto b) { return duty.speed[a] < duty.speed[b]; });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const double speed = duty.speed[order[i]];
            const double weight = duty.weight[order[i]];
            speed_[i] = speed;
            slow_.push_back(slow_.back() + weight * speed);
            fast_.push_back(fast_.back() + weight * std::pow(speed, rolling_drag_exponent));
        }
    }

    /// mean |w| below, and mean |w|^(5/3) from the speed on.
    [[nodiscard]] std::pair<double, double> split_at(double speed) const
    {
        const auto first_fast = std::lower_bound(speed_.begin(), speed_.end(), speed);
        const auto i = static_cast<std::size_t>(first_fast - speed_.begin());
        return {slow_[i], fast_.back() - fast_[i]};
    }

private:
    std::vector<double> speed_;
    std::vector<double> slow_;  ///< sums over the samples before each
    std::vector<double> fast_;
};

double mean_load_heat(const PalmgrenBearing& bearing, const Duty& duty, double axial)
{
    double heat = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i)
        heat += duty.weight[i] * duty.speed[i] *
                palmgren_load_torque(bearing, equivalent_loads(bearing, duty.force[i], axial));
    return heat;
}

}  // namespace

StaticFactors static_factors(BearingType type, double contact_angle, StaticTable table)
{
    const auto single = [&] {
        return table == StaticTable::iso_76 ? axial_factor(iso_76_rows, contact_angle)
                                            : axial_factor(zheng_2018_rows, contact_angle);
    };
    switch (type) {
    case BearingType::deep_groove_ball:
        return {0.6, 0.5};
    case BearingType::angular_contact_ball:
        return {0.5, single()};
    case BearingType::angular_contact_ball_pair:
        return {1, 2 * single()};
    case BearingType::cylindrical_roller:
    case BearingType::needle_roller:
        return {1, 0};
    case BearingType::tapered_roller:
        return {0.5, 0.22 * cotangent(contact_angle)};
    case BearingType::spherical_roller:
        return {1, 0.44 * cotangent(contact_angle)};
    }
    throw InputError("rolling bearing: unknown type");
}

double lubrication_factor(BearingType type, OilSupply supply)
{
    const double of_supply = supply == OilSupply::mist ? 0.5 : supply == OilSupply::jet ? 2 : 1;
    switch (type) {
    case BearingType::deep_groove_ball:
        return 2 * of_supply;
    case BearingType::angular_contact_ball:
        return 3.3 * of_supply;
    case BearingType::angular_contact_ball_pair:
        return 6.5 * of_supply;
    case BearingType::cylindrical_roller:
        return 3 * of_supply;
    case BearingType::needle_roller:
        return 12 * of_supply;
    case BearingType::tapered_roller:
    case BearingType::spherical_roller:
        return 6 * of_supply;
    }
    throw InputError("rolling bearing: unknown type");
}

PalmgrenBearing palmgren_bearing(BearingType type, OilSupply supply, double contact_angle, double mean_diameter,
                                 double static_rating, StaticTable table)
{
    require_positive("mean diameter of a rolling bearing [m]", mean_diameter);
    require_positive("static load rating of a rolling bearing [N]", static_rating);
    const LoadRule rule = load_rule(type, contact_angle);
    return {mean_diameter, static_rating, lubrication_factor(type, supply),          rule.factor, rule.exponent,
            rule.axial,    rule.radial,   static_factors(type, contact_angle, table)};
}

EquivalentLoads equivalent_loads(const PalmgrenBearing& bearing, double radial, double axial)
{
    require_not_negative("radial force of a rolling bearing [N]", radial);
    require_not_negative("axial force of a rolling bearing [N]", axial);
    return {std::max(radial, bearing.statics.radial * radial + bearing.statics.axial * axial),
            std::max(radial, bearing.torque_radial * radial + bearing.torque_axial * axial)};
}

double palmgren_load_torque(const PalmgrenBearing& bearing, const EquivalentLoads& loads)
{
    require_positive("mean diameter of a rolling bearing [m]", bearing.mean_diameter);
    require_not_negative("load factor of a rolling bearing", bearing.load_factor);
    double f1 = bearing.load_factor;
    if (bearing.load_exponent != 0) {
        require_positive("static load rating of a rolling bearing [N]", bearing.static_rating);
        f1 *= std::pow(loads.static_load / bearing.static_rating, bearing.load_exponent);
    }
    return f1 * loads.torque_load * bearing.mean_diameter;
}

ViscousTorque palmgren_viscous_torque(double lubrication_factor, double mean_diameter, double viscosity, double speed)
{
    require_not_negative("lubrication factor of a rolling bearing", lubrication_factor);
    require_positive("mean diameter of a rolling bearing [m]", mean_diameter);
    require_positive_state("oil viscosity [m2/s]", viscosity);
    const double size = lubrication_factor * millimetre_cubed_torque * std::pow(mean_diameter, 3);
    const double number = branch_number(viscosity, speed);
    if (number < palmgren_branch)
        return {low_branch_factor * size, 0, true};
    const double torque = high_branch_factor * size * std::pow(number, 2.0 / 3.0);
    return {torque, 2.0 / 3.0 * torque / viscosity, false};
}

HeatLaw palmgren_heat(const PalmgrenBearing& bearing, const Duty& duty, double axial, const ViscosityLaw& viscosity)
{
    check(duty);
    require_not_negative("lubrication factor of a rolling bearing", bearing.lubrication_factor);
    if (!viscosity)
        throw InputError("rolling bearing: its viscous friction needs a lubricant\n  help: name one");
    const double load = mean_load_heat(bearing, duty, axial);
    const double size = bearing.lubrication_factor * millimetre_cubed_torque * std::pow(bearing.mean_diameter, 3);
    return [load, size, viscosity, spectrum = SpeedSpectrum(duty)](double temperature) {
        const LawValue nu = viscosity(temperature);
        require_positive_state("oil viscosity [m2/s]", nu.value);
        const auto [slow, fast] = spectrum.split_at(palmgren_branch * square_millimetre * turn_per_minute / nu.value);
        const double drag =
            high_branch_factor * size * std::pow(nu.value / square_millimetre / turn_per_minute, 2.0 / 3.0) * fast;
        const double value = load + low_branch_factor * size * slow + drag;
        return LawValue{value, 2.0 / 3.0 * drag * nu.slope / nu.value, nu.in_range};
    };
}

}  // namespace deadpoint::tribology
