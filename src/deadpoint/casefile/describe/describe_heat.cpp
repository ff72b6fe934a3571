#include "deadpoint/casefile/describe/visitor.hpp"

namespace deadpoint::casefile {
namespace {

using D = Dimension;

}  // namespace

void describe(Visitor& v, HeatInput& h)
{
    v.about("Heat that is not friction, uniform over the volume of parts or over a surface.");
    v.texts({"parts", "parts heated in their volume: names, `*` stands for any letters"}, h.parts);
    v.text({"surface", "surface that is heated instead of parts"}, h.surface);
    v.course({"power", "power of the whole press; a half model has half of it", required}, h.power, D::power,
             any_value);
    v.flag({"at_rest", "the source also heats while the press stands"}, h.at_rest);
    v.expect(h.parts.empty() != h.surface.empty(), "", "the heat source needs exactly one place",
             "give either `parts` or `surface`");
}

void describe(Visitor& v, OilCircuit& c)
{
    v.about("Oil that comes from a cooler or sump, flows through joints one after the other, and warms. [oil], or "
            "`oil` of an interface, states the heat transfer coefficient between joint and oil.");
    v.texts({"joints", "joints in the order in which the oil reaches them", required}, c.joints);
    v.quantity({"flow", "flow in the whole press", required}, c.flow, D::volume_flow, positive);
    v.text({"lubricant", "the oil; needs its density", required}, c.lubricant);
    v.quantity({"heat_capacity", "specific heat of the oil"}, c.heat_capacity, D::specific_heat, positive);
    v.quantity({"inlet_temperature", "temperature of the oil after a cooler (or heater); without it the oil reaches "
                                     "the first joint at the temperature of the sump"},
               c.inlet_temperature, D::temperature, positive);
    v.quantity({"sump_volume", "volume of volume of oil in the sump, which takes time to warm; 0: none"}, c.sump_volume,
               D::volume, non_negative);
    v.quantity({"sump_loss", "heat loss from the sump to the ambient, per kelvin"}, c.sump_loss, D::thermal_conductance,
               non_negative);
    v.quantity({"sump_temperature", "temperature of the sump at the start; else that of the machine"},
               c.sump_temperature, D::temperature, positive);
    v.flag({"at_rest", "the oil also flows while the press stands"}, c.at_rest);
    v.expect(!c.joints.empty(), "joints", "the circuit serves no joint", "name at least one");
    v.expect(c.inlet_temperature || c.sump_loss > 0 || c.sump_volume > 0, "", "the temperature of the oil is not given",
             "give `inlet_temperature` if it is cooled, else `sump_volume` and `sump_loss`");
}

void describe(Visitor& v, Enclosure& e)
{
    v.about("Well-mixed air inside the machine: its surfaces exchange heat with this air instead of the room. The "
            "temperature of the air is part of the solution. Surfaces of it whose `film` states an emissivity radiate "
            "to each other.");
    v.texts({"surfaces", "surfaces with a `film` that face it", required}, e.surfaces);
    v.quantity({"volume", "volume of the air, in the whole press"}, e.volume, D::volume, positive);
    v.quantity({"heat_capacity",
                "heat capacity of the air and of things that warm with it, for the whole press; instead of `volume`"},
               e.heat_capacity, D::heat_capacity, positive);
    v.quantity({"exchange",
                "heat exchange with the room through openings and walls, for the whole press; 0 W/K is a sealed box"},
               e.exchange, D::thermal_conductance, non_negative);
    v.quantity({"air_changes", "air changes per hour with the room, instead of `exchange`; needs `volume`"},
               e.air_changes, D::none, non_negative);
    v.quantity({"temperature", "temperature of the air at the start; else that of the machine"}, e.temperature,
               D::temperature, positive);
    v.course({"power", "heat into the air, of the whole press: windage, a motor"}, e.power, D::power, any_value);
    v.flag({"at_rest", "this heat also acts while the press stands"}, e.at_rest);
    v.expect(!e.surfaces.empty(), "surfaces", "no surface faces the enclosure", "name at least one");
    v.expect(e.volume.has_value() != e.heat_capacity.has_value(), "",
             "the heat capacity of the air needs one statement", "give either `volume` or `heat_capacity`");
    v.expect(e.exchange.has_value() != e.air_changes.has_value(), "", "the exchange with the room needs one statement",
             "give either `exchange` (\"0 W/K\" for a sealed box) or `air_changes`");
    v.expect(!e.air_changes || e.volume, "air_changes", "changes of the air need its volume", "give `volume`");
}

}  // namespace deadpoint::casefile
