#include "deadpoint/press/laws/friction_physics.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/press/laws/viscosity.hpp"
#include "deadpoint/tribology/friction/ball_bearing.hpp"
#include "deadpoint/tribology/friction/ball_seat.hpp"
#include "deadpoint/tribology/friction/guide.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/pin.hpp"
#include "deadpoint/tribology/friction/rolling_bearing.hpp"
#include "deadpoint/tribology/friction/skf.hpp"

#include <fmt/format.h>
#include <variant>

namespace deadpoint::press {
namespace {

using casefile::Friction;
using casefile::PalmgrenFriction;
using tribology::Duty;

tribology::Lubricant lubricant_of(const casefile::Case& input, const Friction& friction)
{
    const auto& given = input.lubricants.at(friction.lubricant);
    if (!(given.density > 0))
        throw mistake("lubricants." + friction.lubricant,
                      fmt::format("the shear of an oil film needs the density of '{}'", friction.lubricant),
                      fmt::format("add density = \"870 kg/m^3\" to [lubricants.{}]", friction.lubricant));
    tribology::OilDensity density;
    density.density = given.density;
    return {viscosity_law(input, friction.lubricant), tribology::linear_density(density)};
}

double palmgren_load_heat(const tribology::PalmgrenBearing& bearing, const Duty& duty, double axial)
{
    double sum = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i)
        sum += duty.weight[i] * duty.speed[i] *
               tribology::palmgren_load_torque(bearing, tribology::equivalent_loads(bearing, duty.force[i], axial));
    return sum;
}

bool is_pair(const PalmgrenFriction& friction) { return friction.bearing == BearingType::angular_contact_ball_pair; }

tribology::BallBearing ball_bearing(const PalmgrenFriction& friction)
{
    tribology::BallBearing bearing;
    bearing.balls = friction.balls;
    bearing.rows = is_pair(friction) ? 2 : 1;
    bearing.ball_diameter = *friction.ball_diameter;
    bearing.pitch_diameter = friction.mean_diameter;
    bearing.contact_angle = friction.contact_angle.value_or(0);
    bearing.inner_osculation = friction.osculation;
    bearing.outer_osculation = friction.osculation;
    return bearing;
}

double spin_heat(const PalmgrenFriction& friction, const Duty& duty, double preload)
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
double load_heat(const tribology::PalmgrenBearing& bearing, const PalmgrenFriction& friction, const Duty& duty,
                 double preload)
{
    return palmgren_load_heat(bearing, duty, preload) + (friction.balls > 0 ? spin_heat(friction, duty, preload) : 0);
}

// Preload when the inner ring is warmer than the outer one, the balls in between.
double warm_preload(const PalmgrenFriction& friction, double difference)
{
    const auto bearing = ball_bearing(friction);
    const auto arrangement = is_pair(friction) ? friction.arrangement : PairArrangement::single;
    const double approach = tribology::preload_approach(bearing, friction.axial_preload) +
                            tribology::thermal_approach(bearing, {difference, 0, difference / 2},
                                                        *friction.ring_expansion, arrangement, friction.row_distance);
    return tribology::preload_forces(bearing, approach).axial;
}

// Additional heat from the rings' temperature difference, tabulated because each value is a mean over the turn.
RingHeatLaw ring_heat(const tribology::PalmgrenBearing& bearing, const PalmgrenFriction& friction,
                      const std::vector<RubbingJoint>& joints)
{
    constexpr double step = 2.5;  // [K]
    constexpr int steps = 24;     // number of steps to either side
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
        added.push_back(heat(difference) - cold);
    }
    return [differences, added](double difference) { return interpolate_linear(differences, added, difference).value; };
}

tribology::PalmgrenBearing palmgren_bearing(const PalmgrenFriction& friction)
{
    auto bearing =
        tribology::palmgren_bearing(friction.bearing, friction.oil_supply, friction.contact_angle.value_or(0),
                                    friction.mean_diameter, friction.static_rating);
    if (friction.lubrication_factor)
        bearing.lubrication_factor = *friction.lubrication_factor;
    return bearing;
}

/// Adds up the heat of the joints' bearings or bushes, by the law of their row.
struct Sum {
    const casefile::Case& input;
    const Friction& row;
    std::vector<HeatLaw> laws;
    double load_part = 0;
};

void add(Sum&, const casefile::CalibratedFriction&, const RubbingJoint&)
{
    throw InputError("its heat is calibrated, not computed from sizes");
}

void add(Sum& sum, const PalmgrenFriction& law, const RubbingJoint& joint)
{
    const auto bearing = palmgren_bearing(law);
    for (const auto& duty : joint.duties) {
        sum.laws.push_back(
            tribology::palmgren_heat(bearing, duty, law.axial_preload, viscosity_law(sum.input, sum.row.lubricant)));
        if (law.balls > 0)
            sum.laws.push_back(tribology::constant_heat(spin_heat(law, duty, law.axial_preload)));
        sum.load_part += load_heat(bearing, law, duty, law.axial_preload);
    }
}

void add(Sum& sum, const casefile::SkfFriction& law, const RubbingJoint& joint)
{
    const auto bearing = law.bearing == BearingType::cylindrical_roller
                             ? tribology::skf_cylindrical_roller(law.bore, law.outside_diameter)
                             : tribology::skf_angular_contact(law.bore, law.outside_diameter);
    for (const auto& duty : joint.duties)
        sum.laws.push_back(
            tribology::skf_heat(bearing, duty, law.axial_preload, viscosity_law(sum.input, sum.row.lubricant)));
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

tribology::BallSeat seat_of(const casefile::BallSeat& ball) { return {ball.diameter / 2, ball.from, ball.to}; }

/// The pin with the friction of a bush, or of the seat of a ball.
tribology::Pin pin_of(const casefile::PinFriction& law, const RubbingJoint& joint, std::size_t bush)
{
    tribology::Pin pin;
    pin.friction = law.coefficient;
    pin.clearance = law.clearance.value_or(0);
    if (const auto& ball = joint.joint->ball) {
        pin.radius = tribology::friction_radius(seat_of(*ball));
        pin.length = tribology::film_length(seat_of(*ball));
        return pin;
    }
    const auto& elements = joint.joint->elements;
    const auto& interfaces = joint.joint->interfaces;
    const double touching = interfaces.empty() ? 0 : interfaces.front().diameter.value_or(0);
    const auto element = bush < elements.size() ? elements[bush] : casefile::JointElement{};
    pin.radius = pin_size(joint, "diameter", law.diameter, element.diameter, touching) / 2;
    if (law.clearance)
        pin.length = pin_size(joint, "length", law.length, element.width, 0);
    return pin;
}

void add(Sum& sum, const casefile::PinFriction& law, const RubbingJoint& joint)
{
    for (std::size_t i = 0; i < joint.duties.size(); ++i) {
        const auto pin = pin_of(law, joint, i);
        sum.load_part += tribology::pin_load_heat(pin, joint.duties[i]);
        sum.laws.push_back(law.clearance ? tribology::pin_heat(pin, joint.duties[i], lubricant_of(sum.input, sum.row))
                                         : tribology::pin_heat(pin, joint.duties[i]));
    }
}

void add(Sum& sum, const casefile::GuideFriction& law, const RubbingJoint& joint)
{
    const auto count = static_cast<double>(joint.duties.size());
    tribology::Guide guide;
    guide.friction = law.coefficient;
    guide.thickness = law.film_thickness.value_or(0);
    guide.area = law.film_area.value_or(0) / count;
    for (const auto& duty : joint.duties) {
        sum.load_part += tribology::guide_load_heat(guide, duty);
        sum.laws.push_back(law.film_area ? tribology::guide_heat(guide, duty, lubricant_of(sum.input, sum.row))
                                         : tribology::guide_heat(guide, duty));
    }
}

}  // namespace

PhysicalHeat physical_heat(const casefile::Case& input, const Friction& friction,
                           const std::vector<RubbingJoint>& joints)
{
    Sum sum{input, friction, {}};
    std::visit(
        [&](const auto& law) {
            for (const auto& joint : joints)
                add(sum, law, joint);
        },
        friction.law);
    PhysicalHeat result;
    result.heat = tribology::summed_heat(std::move(sum.laws));
    if (!std::holds_alternative<casefile::SkfFriction>(friction.law))
        result.load_part = sum.load_part;
    const auto* rolling = std::get_if<PalmgrenFriction>(&friction.law);
    if (rolling && rolling->ring_expansion)
        result.ring_heat = ring_heat(palmgren_bearing(*rolling), *rolling, joints);
    return result;
}

}  // namespace deadpoint::press
