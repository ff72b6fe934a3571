#include "deadpoint/casefile/describe/choose.hpp"

#include <array>
#include <initializer_list>
#include <numbers>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

bool within_a_turn(const Table& table)
{
    return table.x.empty() || table.x.back() - table.x.front() < 2 * std::numbers::pi + 1e-9;
}

}  // namespace

void describe(Visitor& v, Mechanism& m)
{
    v.about("Data of the whole linkage, for `loads`. Bodies and joints describe its members.");
    v.text({"slide_body", "the body that carries the tool; else that of [chain]"}, m.slide_body);
    v.vector({"stroke_direction",
              "direction from the table towards the slide; heights and the process force count along "
              "it. Default: along the guide that holds the slide on the ground, against gravity"},
             m.stroke_direction, D::none);
    v.expect(!m.stroke_direction || norm(*m.stroke_direction) > 0, "stroke_direction", "the direction has no length",
             "write it like [0, 1]");
    v.integer(
        {"positions", "crank positions over a turn, or a few more where they would miss the largest process force"},
        m.positions, {36, 100000, false});
    v.curve({"speed", "speed of the crank relative to that of the operation, over its angle after bottom dead point; "
                      "from the last point it is linear to the first; without it the speed is constant"},
            m.speed, {"angle", D::angle, D::none, positive});
    v.expect(within_a_turn(m.speed), "speed", "the angles cover more than one turn", "keep them within 360 deg");
}

void describe(Visitor& v, Crankshaft& c)
{
    v.about("The crankshaft on its bearings, as a beam along z. Angles count from the x axis towards y; angles of "
            "things that rotate with the shaft count from the crank throw.");
    choose(v, {"model", "`flexible`: a beam on springs; `rigid`: bearing loads by statics alone"}, c.model);
    v.text({"material", "its material", required}, c.material);
    v.quantity({"start", "z where the first section begins"}, c.start, D::length, any_value);
    v.quantity({"pin_position", "z of the crank pin's middle"}, c.pin_position, D::length, any_value);
    v.quantity({"pin_width", "width over which the load of the crank pin is spread"}, c.pin_width, D::length,
               non_negative);
    v.list({"sections", "one after the other along z", required}, c.sections);
    v.list({"disks", "flywheel, gears, counterweights"}, c.disks);
    v.list({"bearings", "supports, two or more", required}, c.bearings);
    v.table({"belt", "pull of the belt that drives the shaft"}, c.belt);
    v.flag({"throw_unbalance", "the unbalance of the crank's body (mass times distance of its centre of mass from the "
                               "axis) acts at the pin; false if disks state it"},
           c.throw_unbalance);
    v.number({"modal_damping", "damping ratio of every mode, in addition to the damping of the bearings"},
             c.modal_damping, {0, 1, false});
    v.number({"shear_factor", "Timoshenko's shear coefficient of its sections; 0: no shear deformation"},
             c.shear_factor, fraction);
    v.quantity({"axial_load", "tension in the shaft"}, c.axial_load, D::force, any_value);
    v.integer({"critical_speeds", "number of critical speeds to compute, starting with the lowest"}, c.critical_speeds,
              {1, 100, false});
    v.expect(c.bearings.size() >= 2, "bearings", "a shaft needs two bearings or more", "add the missing bearings");
}

void describe(Visitor& v, Crankshaft::Section& s)
{
    v.quantity({"length", "length along z", required}, s.length, D::length, positive);
    v.quantity({"diameter", "diameter of this section", required}, s.diameter, D::length, positive);
    v.quantity({"bore", "diameter of the hole along it; 0 for none"}, s.bore, D::length, non_negative);
    v.quantity({"density", "density instead of that of the material; 0 keeps the stiffness without the mass"},
               s.density, D::density, non_negative);
    v.quantity({"shear_factor",
                "shear factor instead of that of the crankshaft: about 0.9 for a solid section, 0.5 for a thin tube"},
               s.shear_factor, D::none, fraction);
    v.expect(s.bore < s.diameter || s.diameter == 0, "bore", "the bore is not smaller than the diameter",
             "make the bore smaller");
}

void describe(Visitor& v, Crankshaft::Disk& d)
{
    v.quantity({"position", "along z", required}, d.position, D::length, any_value);
    v.quantity({"mass", "mass of the disk", required}, d.mass, D::mass, non_negative);
    v.quantity({"polar_inertia", "moment of inertia about z", required}, d.polar_inertia, D::inertia, non_negative);
    v.quantity({"diametral_inertia", "moment of inertia about a diameter", required}, d.diametral_inertia, D::inertia,
               non_negative);
    v.quantity({"eccentricity", "distance of its centre of mass from the axis"}, d.eccentricity, D::length,
               non_negative);
    v.quantity({"eccentricity_angle", "angle of that centre, from the crank throw"}, d.eccentricity_angle, D::angle,
               any_value);
}

void describe(Visitor& v, Crankshaft::Bearing& b)
{
    v.about("Stiffness and damping are one value for both directions, or [[xx, xy], [yx, yy]].");
    v.text({"name", "name in reports; else bearing_1 and so on"}, b.name);
    v.text({"seat", "seat of the bearing; bearings with the same seat are also reported together"}, b.seat);
    v.quantity({"position", "along z", required}, b.position, D::length, any_value);
    v.matrix({"stiffness", "radial stiffness", required}, b.stiffness, D::stiffness);
    v.matrix({"damping", "radial damping"}, b.damping, D::damping);
    v.quantity({"housing_mass", "mass that moves with the outer ring, on a support"}, b.housing_mass, D::mass,
               non_negative);
    v.matrix({"support_stiffness", "stiffness between housing and ground; without it the housing stands still"},
             b.support_stiffness, D::stiffness);
    v.matrix({"support_damping", "damping between housing and ground"}, b.support_damping, D::damping);
    v.number({"hertz_exponent",
              "n of force = constant * deflection^n; the stiffness depends on the mean load; 1: constant stiffness"},
             b.hertz_exponent, {1, 2, false});
    v.quantity({"reference_load", "load at which the stiffness is valid, with a `hertz_exponent` above 1"},
               b.reference_load, D::force, non_negative);
    v.expect(b.stiffness[0][0] > 0 && b.stiffness[1][1] > 0, "stiffness", "a bearing must hold the shaft in x and in y",
             "write it like \"5e8 N/m\", or [[xx, xy], [yx, yy]] with positive xx and yy");
    v.expect(b.damping[0][0] >= 0 && b.damping[1][1] >= 0, "damping", "damping is negative",
             "make xx and yy positive or zero");
    v.expect(b.hertz_exponent == 1 || b.reference_load > 0, "hertz_exponent",
             "a load-dependent stiffness needs the load at which it is stated", "add reference_load = \"10 kN\"");
    v.expect(b.housing_mass == 0 || b.support_stiffness, "housing_mass", "the housing has a mass but no support",
             "add `support_stiffness`, or remove `housing_mass`");
}

void describe(Visitor& v, Crankshaft::Belt& b)
{
    v.about("Either the `force` of the pull, or the motor's `power` and the `pulley_diameter`: the pull is then the "
            "power divided by the speed of the belt.");
    v.quantity({"position", "along z", required}, b.position, D::length, any_value);
    v.quantity({"angle", "direction of the pull on the shaft, from the x axis"}, b.angle, D::angle, any_value);
    v.quantity({"force", "force of the pull"}, b.force, D::force, non_negative);
    v.quantity({"power", "power of the motor"}, b.power, D::power, non_negative);
    v.quantity({"pulley_diameter", "diameter of the pulley on the shaft"}, b.pulley_diameter, D::length, non_negative);
    const bool by_power = b.power > 0 || b.pulley_diameter > 0;
    v.expect(b.force || by_power, "", "the pull of the belt is not given",
             "give `force`, or `power` and `pulley_diameter`");
    v.expect(!(b.force && by_power), "force", "the pull of the belt is given twice",
             "keep either `force`, or `power` and `pulley_diameter`");
    v.expect(!by_power || (b.power > 0 && b.pulley_diameter > 0), b.power > 0 ? "power" : "pulley_diameter",
             "a pull by power needs both `power` and `pulley_diameter`", "give both");
}

void describe(Visitor& v, ProcessForce& p)
{
    v.about(
        "The process force (piling, blanking or forming force) on the slide over a turn of the crank. Its peak is the "
        "`force` of the operation. Crank angles count from the x axis, so a throw that points down is at 270 deg.");
    choose(v,
           {"kind",
            "course of the force; without it `elastic` with a flexible crankshaft, else `rectangular`. `elastic`: "
            "a die of `stiffness`; the slide meets it so early that the force reaches its peak at bottom dead point; "
            "`half_sine` and `rectangular`: between `from` and `to`; `angle_table` and `travel_table`: a share "
            "of the force over crank angle or slide height"},
           p.kind);
    v.quantity({"stiffness", "stiffness of press and die together"}, p.stiffness, D::stiffness, positive);
    v.quantity({"from", "crank angle where the force begins; else 15 deg before bottom dead point"}, p.from, D::angle,
               any_value);
    v.quantity({"to", "crank angle where it ends; else 15 deg after bottom dead point"}, p.to, D::angle, any_value);
    v.curve({"over_angle", "share of the force over the crank angle; from the last point it is linear to the first "
                           "point of the next turn"},
            p.over_angle, {"angle", D::angle, D::none, any_value});
    v.curve({"over_height", "share of the force over the height of the slide above bottom dead point, on its way down; "
                            "no force above the last height"},
            p.over_height, {"height", D::length, D::none, any_value});
    v.flag({"both_ways", "`over_height` holds on the way up as well"}, p.both_ways);
    v.quantity({"offset", "distance of the line of action from the slide's guided point, along x where the stroke "
                          "points up (eccentric load)"},
               p.offset, D::length, any_value);
    v.expect(!p.from || !p.to || *p.from < *p.to, "to", "the force must end after it begins",
             "write it like from = \"255 deg\", to = \"285 deg\"");
    v.expect(p.kind != ProcessForce::Kind::angle_table || !p.over_angle.x.empty(), "kind", "the table is missing",
             "add over_angle = { angle = [\"250 deg\", ...], value = [0, ...] }");
    v.expect(p.kind != ProcessForce::Kind::travel_table || !p.over_height.x.empty(), "kind", "the table is missing",
             "add over_height = { height = [\"0 mm\", ...], value = [1, ...] }");
    v.expect(within_a_turn(p.over_angle), "over_angle", "the angles cover more than one turn",
             "keep them within 360 deg");
}

}  // namespace deadpoint::casefile
