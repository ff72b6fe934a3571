#include "deadpoint/study/laws/friction_physics.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/study/laws/viscosity.hpp"
#include "deadpoint/tribology/friction/ball_bearing.hpp"
#include "deadpoint/tribology/friction/guide.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/pin.hpp"
#include "deadpoint/tribology/friction/rolling_bearing.hpp"
#include "deadpoint/tribology/friction/skf.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::study {
namespace {

using casefile::Friction;
using tribology::Duty;

tribology::Lubricant lubricant_of(const casefile::Case& input, const Friction& friction)
{
    const auto& given = input.lubricants.at(friction.lubricant);
    if (!(given.density > 0))
        throw InputError(fmt::format("the shear of an oil film needs the density of '{0}'\n  help: add density = \"870 "
                                     "kg/m^3\" to [lubricants.{0}]",
                                     friction.lubricant));
    tribology::OilDensity density;
    density.density = given.density;
    return {viscosity_law(input, friction.lubricant), tribology::linear_density(density)};
}

HeatLaw scaled(HeatLaw law, double factor)
{
    return [law = std::move(law), factor](double temperature) {
        const LawValue value = law(temperature);
        return LawValue{factor * value.value, factor * value.slope, value.in_range};
    };
}

// As the library of laws spells it.
tribology::BearingType bearing_type(std::string name)
{
    std::ranges::replace(name, '_', ' ');
    return tribology::bearing_type(name);
}

double palmgren_load_heat(const tribology::PalmgrenBearing& bearing, const Duty& duty, double axial)
{
    double sum = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i)
        sum += duty.weight[i] * duty.speed[i] *
               tribology::palmgren_load_torque(bearing, tribology::equivalent_loads(bearing, duty.force[i], axial));
    return sum;
}

bool is_pair(const Friction& friction) { return friction.bearing == "angular_contact_ball_pair"; }

tribology::BallBearing ball_bearing(const Friction& friction)
{
    tribology::BallBearing bearing;
    bearing.balls = friction.balls;
    bearing.rows = is_pair(friction) ? 2 : 1;
    bearing.ball_diameter = *friction.ball_diameter;
    bearing.pitch_diameter = *friction.mean_diameter;
    bearing.contact_angle = friction.contact_angle.value_or(0);
    bearing.inner_osculation = friction.osculation;
    bearing.outer_osculation = friction.osculation;
    return bearing;
}

double spin_heat(const Friction& friction, const Duty& duty, double preload)
{
    const auto bearing = ball_bearing(friction);
    tribology::BallLoading loading;
    if (is_pair(friction))
        loading.base = tribology::preload_approach(bearing, preload);
    else
        loading.axial = preload;
    return tribology::spin_heat(bearing, friction.spin_friction, loading, duty);
}

// Heat without the oil of one bearing under its loads and a preload.
double load_heat(const tribology::PalmgrenBearing& bearing, const Friction& friction, const Duty& duty, double preload)
{
    return palmgren_load_heat(bearing, duty, preload) + (friction.balls > 0 ? spin_heat(friction, duty, preload) : 0);
}

// Preload when the inner ring is warmer than the outer one, the balls in between.
double warm_preload(const Friction& friction, double difference)
{
    const auto bearing = ball_bearing(friction);
    auto arrangement = tribology::PairArrangement::single;
    if (is_pair(friction))
        arrangement = friction.arrangement == "back_to_back" ? tribology::PairArrangement::back_to_back
                                                             : tribology::PairArrangement::face_to_face;
    const double approach = tribology::preload_approach(bearing, friction.axial_preload) +
                            tribology::thermal_approach(bearing, {difference, 0, difference / 2},
                                                        *friction.ring_expansion, arrangement, friction.row_distance);
    return tribology::preload_forces(bearing, approach).axial;
}

// What the rings' temperature difference adds, tabulated because each value is a mean over the turn.
RingHeatLaw ring_heat(const tribology::PalmgrenBearing& bearing, const Friction& friction,
                      const std::vector<RubbingJoint>& joints)
{
    constexpr double step = 2.5;  // [K]
    constexpr int steps = 24;     // to either side
    const auto heat = [&](double difference) {
        const double preload = warm_preload(friction, difference);
        double sum = 0;
        for (const auto& joint : joints)
            for (const auto& duty : joint.duties)
                sum += load_heat(bearing, friction, duty, preload);
        return sum;
    };
    const double cold = heat(0);
    std::vector<double> differences, added;
    for (int i = -steps; i <= steps; ++i) {
        const double difference = i * step;
        differences.push_back(difference);
        added.push_back(friction.scale * (heat(difference) - cold));
    }
    return [differences, added](double difference) { return interpolate_linear(differences, added, difference).value; };
}

tribology::PalmgrenBearing palmgren_bearing(const Friction& friction)
{
    auto bearing = tribology::palmgren_bearing(
        bearing_type(friction.bearing), tribology::oil_supply(friction.oil_supply), friction.contact_angle.value_or(0),
        *friction.mean_diameter, *friction.static_rating);
    if (friction.lubrication_factor)
        bearing.lubrication_factor = *friction.lubrication_factor;
    return bearing;
}

/// Adds up the heat of the joints' bearings or bushes.
struct Sum {
    std::vector<HeatLaw> laws;
    double load_part = 0;
};

void add_palmgren(Sum& sum, const casefile::Case& input, const Friction& friction, const RubbingJoint& joint)
{
    const auto bearing = palmgren_bearing(friction);
    for (const auto& duty : joint.duties) {
        sum.laws.push_back(
            tribology::palmgren_heat(bearing, duty, friction.axial_preload, viscosity_law(input, friction.lubricant)));
        if (friction.balls > 0)
            sum.laws.push_back(tribology::constant_heat(spin_heat(friction, duty, friction.axial_preload)));
        sum.load_part += load_heat(bearing, friction, duty, friction.axial_preload);
    }
}

void add_skf(Sum& sum, const casefile::Case& input, const Friction& friction, const RubbingJoint& joint)
{
    const auto bearing = friction.bearing == "cylindrical_roller"
                             ? tribology::skf_cylindrical_roller(*friction.bore, *friction.outside_diameter)
                             : tribology::skf_angular_contact(*friction.bore, *friction.outside_diameter);
    for (const auto& duty : joint.duties)
        sum.laws.push_back(
            tribology::skf_heat(bearing, duty, friction.axial_preload, viscosity_law(input, friction.lubricant)));
}

// A size of a pin: by the row, else by the element, else by the interface.
double pin_size(const RubbingJoint& joint, const char* key, std::optional<double> by_row, double by_element,
                double by_interface)
{
    if (by_row)
        return *by_row;
    if (by_element > 0)
        return by_element;
    if (by_interface > 0)
        return by_interface;
    throw InputError(
        fmt::format("the {} of the pin of joints.{} is missing\n  help: add `{}` to the law, or an element "
                    "with its `diameter` and `width` to the joint",
                    key, joint.name, key));
}

void add_pins(Sum& sum, const casefile::Case& input, const Friction& friction, const RubbingJoint& joint)
{
    const auto& elements = joint.joint->elements;
    const auto& interfaces = joint.joint->interfaces;
    const double touching = interfaces.empty() ? 0 : interfaces.front().diameter.value_or(0);
    for (std::size_t i = 0; i < joint.duties.size(); ++i) {
        const bool stated = i < elements.size();
        tribology::Pin pin;
        pin.friction = *friction.coefficient;
        pin.radius = pin_size(joint, "diameter", friction.diameter, stated ? elements[i].diameter : 0, touching) / 2;
        sum.load_part += tribology::pin_load_heat(pin, joint.duties[i]);
        if (!friction.clearance) {
            sum.laws.push_back(tribology::pin_heat(pin, joint.duties[i]));
            continue;
        }
        pin.clearance = *friction.clearance;
        pin.length = pin_size(joint, "length", friction.length, stated ? elements[i].width : 0, 0);
        sum.laws.push_back(tribology::pin_heat(pin, joint.duties[i], lubricant_of(input, friction)));
    }
}

void add_guides(Sum& sum, const casefile::Case& input, const Friction& friction, const RubbingJoint& joint)
{
    const auto count = static_cast<double>(joint.duties.size());
    tribology::Guide guide;
    guide.friction = *friction.coefficient;
    guide.thickness = friction.film_thickness.value_or(0);
    guide.area = friction.film_area.value_or(0) / count;
    for (const auto& duty : joint.duties) {
        sum.load_part += tribology::guide_load_heat(guide, duty);
        sum.laws.push_back(friction.film_area ? tribology::guide_heat(guide, duty, lubricant_of(input, friction))
                                              : tribology::guide_heat(guide, duty));
    }
}

}  // namespace

PhysicalHeat physical_heat(const casefile::Case& input, const Friction& friction,
                           const std::vector<RubbingJoint>& joints)
{
    Sum sum;
    for (const auto& joint : joints) {
        if (friction.law == "palmgren")
            add_palmgren(sum, input, friction, joint);
        else if (friction.law == "skf")
            add_skf(sum, input, friction, joint);
        else if (friction.law == "pin")
            add_pins(sum, input, friction, joint);
        else if (friction.law == "guide")
            add_guides(sum, input, friction, joint);
        else
            throw InputError(fmt::format("law '{}' is not known", friction.law));
    }
    PhysicalHeat result;
    result.heat = scaled(tribology::summed_heat(std::move(sum.laws)), friction.scale);
    if (friction.law != "skf")
        result.load_part = friction.scale * sum.load_part;
    if (friction.ring_expansion)
        result.ring_heat = ring_heat(palmgren_bearing(friction), friction, joints);
    return result;
}

}  // namespace deadpoint::study
