#include "deadpoint/press/laws/conductance.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern_pair.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/press/laws/guide_sides.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "deadpoint/tribology/conductance/bearing_conductance.hpp"
#include "deadpoint/tribology/conductance/conductance.hpp"
#include "deadpoint/tribology/conductance/fractal_contact.hpp"
#include "deadpoint/tribology/friction/ball_seat.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <variant>

namespace deadpoint::press {
namespace {

using tribology::ContactConductance;

/// The joint of an interface.
struct OfJoint {
    const std::string& name;
    const casefile::Joint& joint;
    const casefile::Interface& interface;
    std::size_t first;  ///< index of the joint's first interface in Machine::interfaces
};

/// One interface with all data that its law may need.
struct InterfacePlace {
    const casefile::Case& input;
    const Machine& machine;
    const LoadsResult* loads;
    double speed;
    const casefile::Conductance& conductance;
    std::string path;
    std::size_t index;             ///< index into Machine::interfaces
    std::optional<OfJoint> joint;  ///< none for a bond

    [[nodiscard]] const Contact& contact() const { return machine.interfaces[index]; }
    /// Uses the values at the initial temperature.
    [[nodiscard]] casefile::Material material(std::uint32_t part) const
    {
        return material(input.parts.at(machine.parts[part].name).material);
    }
    [[nodiscard]] casefile::Material material(const std::string& called) const
    {
        return at_temperature(input.materials.at(called), input.machine.initial_temperature);
    }
};

/// The joint exists once in the press, of which the half model holds a half.
bool halved(const InterfacePlace& at)
{
    return at.machine.half_model && std::ranges::none_of(at.joint->joint.bodies, [&](const std::string& body) {
               return at.input.bodies.at(body).mirror;
           });
}

double area_side_by_side(const InterfacePlace& at)
{
    const auto& own = at.joint->interface;
    double area = 0;
    for (std::size_t i = 0; i < at.joint->joint.interfaces.size(); ++i) {
        const auto& other = at.joint->joint.interfaces[i];
        if (other.seat == own.seat && other.journal == own.journal && other.stands_still == own.stands_still)
            area += at.machine.interfaces[at.joint->first + i].area;
    }
    return halved(at) ? 2 * area : area;
}

double seat_area_of(const casefile::BallSeat& ball)
{
    return tribology::seat_area({ball.diameter / 2, ball.from, ball.to});
}

double mean_load(const LoadsResult& loads, const std::string& joint)
{
    const auto found = std::ranges::find(loads.linkage.joints, joint, &LinkageJoint::name);
    const auto index = static_cast<std::size_t>(found - loads.linkage.joints.begin());
    for (const auto& guide : loads.guides)
        if (guide.joint == static_cast<int>(index))
            return guide.mean_normal;
    return tribology::duty_mean(tribology::duty_of(loads.history, loads.history.joints.at(index)), 1, 0);
}

/// The mean force that presses the interfaces side by side with this one, over their area [Pa].
double pressure_by_loads(const InterfacePlace& at)
{
    const auto& own = *at.joint;
    if (own.joint.ball)
        return mean_load(*at.loads, own.name) / seat_area_of(*own.joint.ball);
    const auto sides = guide_sides(at.input, at.machine, *at.loads, own.name, own.first);
    const int side = sides ? sides->of_interface[at.index - own.first] : 0;
    if (side == 0)
        return mean_load(*at.loads, own.name) / area_side_by_side(at);
    double area = 0;
    for (std::size_t i = 0; i < sides->of_interface.size(); ++i)
        area += sides->of_interface[i] == side ? at.machine.interfaces[own.first + i].area : 0;
    return sides->load(side) / area;
}

double contact_pressure(const InterfacePlace& at, const std::optional<double>& given, InterfaceConductance& result)
{
    if (!given && !at.joint)
        throw mistake(at.path + ".conductance",
                      fmt::format("the law \"{}\" needs the contact pressure, which no load of a joint gives to a bond",
                                  casefile::law_name(at.conductance)),
                      "add pressure = \"5 MPa\": the force of the bolts divided by the area");
    if (!given && !at.loads)
        throw mistake(
            at.path + ".conductance",
            fmt::format("the law \"{}\" needs the contact pressure, and there are no loads to compute it from",
                        casefile::law_name(at.conductance)),
            "add pressure = \"1 MPa\", or describe the linkage with its driver and slide body");
    result.pressure = given ? *given : pressure_by_loads(at);
    result.pressure_from_loads = !given;
    return *result.pressure;
}

tribology::GapFluid fluid_of(double conductivity, const std::optional<double>& jump)
{
    return {conductivity, jump.value_or(0)};
}

ContactConductance by_law(const InterfacePlace& at, const casefile::FractalContact& c, InterfaceConductance& result)
{
    const double pressure = contact_pressure(at, c.surfaces.pressure, result);
    const auto a = at.material(at.contact().part_a);
    const auto b = at.material(at.contact().part_b);
    tribology::FractalContact contact;
    contact.dimension = c.fractal_dimension;
    contact.roughness = c.fractal_roughness;
    contact.sample = c.sample_length;
    contact.separation = c.separation;
    contact.hardness = c.surfaces.hardness;
    contact.modulus =
        tribology::contact_modulus(a.youngs_modulus, a.poissons_ratio, b.youngs_modulus, b.poissons_ratio);
    contact.conductivity1 = a.conductivity;
    contact.conductivity2 = b.conductivity;
    return tribology::fractal_conductance(contact, fluid_of(c.surfaces.fluid_conductivity, c.surfaces.gas_jump),
                                          pressure);
}

ContactConductance by_law(const InterfacePlace& at, const casefile::RoughContact& c, InterfaceConductance& result)
{
    const double pressure = contact_pressure(at, c.surfaces.pressure, result);
    tribology::RoughContact contact;
    contact.roughness = c.roughness;
    contact.slope = c.slope ? *c.slope : tribology::slope_of_roughness(contact.roughness);
    contact.hardness = c.surfaces.hardness;
    contact.conductivity1 = at.material(at.contact().part_a).conductivity;
    contact.conductivity2 = at.material(at.contact().part_b).conductivity;
    auto value =
        tribology::rough_conductance(contact, fluid_of(c.surfaces.fluid_conductivity, c.surfaces.gas_jump), pressure);
    if (!c.slope)
        value.notes.push_back(fmt::format("slope {:.3g} estimated from the roughness", contact.slope));
    return value;
}

ContactConductance by_law(const InterfacePlace&, const casefile::OilFilm& c, InterfaceConductance&)
{
    if (c.thickness)
        return tribology::film_conductance(fluid_of(c.fluid_conductivity, c.gas_jump), *c.thickness);
    return tribology::journal_film_conductance(c.fluid_conductivity, c.clearance.value_or(0),
                                               c.eccentricity.value_or(0));
}

tribology::SolidHeat solid_of(const casefile::Material& m) { return {m.conductivity, m.density, m.specific_heat}; }

ContactConductance by_law(const InterfacePlace& at, const casefile::RollingElements& c, InterfaceConductance&)
{
    const auto material = c.material.empty() ? at.material(at.contact().part_a) : at.material(c.material);
    tribology::BearingPath path;
    path.elements.assign(static_cast<std::size_t>(c.loaded_elements),
                         {{c.inner_spot[0], c.inner_spot[1]}, {c.outer_spot[0], c.outer_spot[1]}});
    path.element_diameter = c.element_diameter;
    path.element = solid_of(material);
    path.ring = path.element;
    if (c.pitch_diameter) {
        const double ratio = path.element_diameter / *c.pitch_diameter;
        path.rolling_speed = at.speed * *c.pitch_diameter * (1 - ratio * ratio) / 4;
    }
    path.film_thickness = c.thickness.value_or(0);
    path.film_conductivity = c.fluid_conductivity.value_or(0);
    const auto& contact = at.contact();
    const bool cut = at.machine.parts[contact.part_a].cut;
    return tribology::bearing_conductance(path).per_area(cut ? 2 * contact.area : contact.area);
}

void set_films(const InterfacePlace&, const casefile::ContactResistance& known, InterfaceConductance& result)
{
    result.film_a = result.film_b = known.value > 0 ? 2 / known.value : 0;
}

void set_films(const InterfacePlace&, const casefile::WholeConductance& known, InterfaceConductance& result)
{
    result.film_a = result.film_b = 2 * known.value;
}

void set_films(const InterfacePlace&, const casefile::SideFilms& known, InterfaceConductance& result)
{
    result.film_a = known.a;
    result.film_b = known.b;
}

template <class Law>
void set_films(const InterfacePlace& at, const Law& law, InterfaceConductance& result)
{
    const auto value = by_law(at, law, result);
    result.film_a = result.film_b = 2 * value.conductance;
    result.in_range = value.in_range;
    result.notes = value.notes;
}

InterfaceConductance conductance_of(const InterfacePlace& at)
{
    InterfaceConductance result;
    result.joint = at.joint ? at.joint->name : "";
    result.name = at.joint ? at.joint->interface.name : at.contact().name;
    result.path = at.path;
    result.area = at.contact().area;
    const auto law = casefile::law_name(at.conductance);
    result.law = law.empty() ? "given" : law;
    std::visit([&](const auto& given) { set_films(at, given, result); }, at.conductance);
    if (at.joint && at.joint->joint.ball)
        result.seat_over_drawn = seat_area_of(*at.joint->joint.ball) / area_side_by_side(at);
    result.film_a *= result.seat_over_drawn;
    result.film_b *= result.seat_over_drawn;
    return result;
}

/// The stated bond of a contact, "part|part".
const std::pair<const std::string, casefile::Bond>& bond_of(const casefile::Case& input, const std::string& contact)
{
    const auto parts = pattern_pair(contact).value_or(PatternPair{});
    const auto found = std::ranges::find_if(input.bonds, [&](const auto& entry) {
        return std::ranges::any_of(entry.second.between, [&](const std::string& text) {
            return pattern_pair(text).value_or(PatternPair{}).names(parts.first, parts.second);
        });
    });
    if (found == input.bonds.end())
        throw InputError(fmt::format("[bonds] states no bond of '{}'", contact));
    return *found;
}

}  // namespace

double conductance_speed(const casefile::Case& input)
{
    const int running = first_running_segment(input);
    return running < 0 ? 0 : input.operation[static_cast<std::size_t>(running)].speed;
}

std::string out_of_range_text(const InterfaceConductance& conductance)
{
    std::string reasons;
    for (const auto& note : conductance.notes)
        reasons += (reasons.empty() ? "" : "; ") + note;
    return fmt::format("{}: the conductance by law '{}' is outside its tested range: {}", conductance.path,
                       conductance.law, reasons);
}

std::vector<InterfaceConductance> interface_conductances(const casefile::Case& input, const Machine& machine,
                                                         const LoadsResult* loads, double speed)
{
    std::vector<InterfaceConductance> result;
    Mistakes mistakes;
    for (const auto& [name, joint] : input.joints) {
        const std::size_t first = result.size();
        for (const auto& interface : joint.interfaces) {
            const InterfacePlace at{input,
                                    machine,
                                    loads,
                                    speed,
                                    interface.conductance,
                                    fmt::format("joints.{}.interfaces.{}", name, interface.name),
                                    result.size(),
                                    OfJoint{name, joint, interface, first}};
            auto& conductance = result.emplace_back();
            mistakes.attempt(at.path, [&] { conductance = conductance_of(at); });
        }
    }
    while (result.size() < machine.interfaces.size()) {
        const auto& [name, bond] = bond_of(input, machine.interfaces[result.size()].name);
        const InterfacePlace at{input, machine, loads, speed, bond.conductance, "bonds." + name, result.size(), {}};
        auto& conductance = result.emplace_back();
        mistakes.attempt(at.path, [&] { conductance = conductance_of(at); });
    }
    mistakes.raise();
    return result;
}

}  // namespace deadpoint::press
