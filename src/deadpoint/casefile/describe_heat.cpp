#include "deadpoint/casefile/visitor.hpp"

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

}  // namespace deadpoint::casefile
