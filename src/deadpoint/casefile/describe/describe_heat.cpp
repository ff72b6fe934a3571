#include "deadpoint/casefile/describe/visitor.hpp"

namespace deadpoint::casefile {
namespace {

using D = Dimension;
constexpr auto required = Need::required;

}  // namespace

void describe(Visitor& v, HeatInput& h)
{
    v.about("Heat that is not friction, even over the volume of parts or over a surface.");
    v.texts({"parts", "names of parts, `*` stands for any letters: heated in their volume"}, h.parts);
    v.text({"surface", "heated instead of parts"}, h.surface);
    v.course({"power", "of the whole press; in a half model half of it counts", required}, h.power, D::power,
             any_value);
    v.flag({"at_rest", "heats also while the press stands"}, h.at_rest);
    v.expect(h.parts.empty() != h.surface.empty(), "", "the heat needs one place to go",
             "give either `parts` or `surface`");
}

void describe(Visitor& v, OilCircuit& c)
{
    v.about(
        "Oil that serves joints one after the other and warms on its way, from a cooler or a sump. How well a joint "
        "gives heat to it is said by [oil] or the interfaces' `oil`.");
    v.texts({"joints", "in the order in which the oil reaches them", required}, c.joints);
    v.quantity({"flow", "of the whole press", required}, c.flow, D::volume_flow, positive);
    v.text({"lubricant", "the oil; needs its density", required}, c.lubricant);
    v.quantity({"heat_capacity", "of the oil"}, c.heat_capacity, D::specific_heat, positive);
    v.quantity({"inlet_temperature",
                "held by a cooler (or heater); without it the oil reaches the first joint as warm as the sump"},
               c.inlet_temperature, D::temperature, positive);
    v.quantity({"sump_volume", "oil in the sump, which takes time to warm; 0: none"}, c.sump_volume, D::volume,
               non_negative);
    v.quantity({"sump_loss", "from the sump to the ambient, per kelvin"}, c.sump_loss, D::thermal_conductance,
               non_negative);
    v.quantity({"sump_temperature", "at the start; else that of the machine"}, c.sump_temperature, D::temperature,
               positive);
    v.flag({"at_rest", "the oil flows also while the press stands"}, c.at_rest);
    v.expect(!c.joints.empty(), "joints", "the circuit serves no joint", "name at least one");
    v.expect(c.inlet_temperature || c.sump_loss > 0 || c.sump_volume > 0, "", "nothing says how warm the oil is",
             "give `inlet_temperature` if it is cooled, else `sump_volume` and `sump_loss`");
}

void describe(Visitor& v, Enclosure& e)
{
    v.about(
        "Air inside the machine, well mixed: the films of its surfaces see its temperature instead of the room's. Its "
        "balance is part of the solution. Those whose film states an emissivity radiate to each other.");
    v.texts({"surfaces", "surfaces with a `film` that face it", required}, e.surfaces);
    v.quantity({"volume", "of the air, in the whole press"}, e.volume, D::volume, positive);
    v.quantity({"heat_capacity", "of the air and what warms with it, of the whole press; instead of `volume`"},
               e.heat_capacity, D::heat_capacity, positive);
    v.quantity({"exchange", "with the room by openings and walls, of the whole press; 0 W/K is a sealed box"},
               e.exchange, D::thermal_conductance, non_negative);
    v.quantity({"air_changes", "per hour with the room, instead of `exchange`; needs `volume`"}, e.air_changes, D::none,
               non_negative);
    v.quantity({"temperature", "at the start; else that of the machine"}, e.temperature, D::temperature, positive);
    v.course({"power", "heat into the air, of the whole press: windage, a motor"}, e.power, D::power, any_value);
    v.flag({"at_rest", "that heat comes also while the press stands"}, e.at_rest);
    v.expect(!e.surfaces.empty(), "surfaces", "no surface faces the enclosure", "name at least one");
    v.expect(e.volume.has_value() != e.heat_capacity.has_value(), "",
             "the heat capacity of the air needs one statement", "give either `volume` or `heat_capacity`");
    v.expect(e.exchange.has_value() != e.air_changes.has_value(), "", "the exchange with the room needs one statement",
             "give either `exchange` (\"0 W/K\" for a sealed box) or `air_changes`");
    v.expect(!e.air_changes || e.volume, "air_changes", "changes of the air need its volume", "give `volume`");
}

}  // namespace deadpoint::casefile
