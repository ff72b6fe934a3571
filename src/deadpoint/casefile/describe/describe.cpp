#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/casefile/describe/choose.hpp"
#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/exchange/named_axes.hpp"
#include "deadpoint/exchange/solid_print.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace deadpoint::casefile {
namespace {

using D = Dimension;
constexpr Need optional = Need::optional;
constexpr Range absolute_temperature = positive;
constexpr double everywhere = 1e3;  ///< half width of an unlimited window [m]

void describe_form(Visitor& v, BoxShape& box)
{
    v.extent({"x", "extent along x", required}, box.min[0], box.max[0]);
    v.extent({"y", "extent along y", required}, box.min[1], box.max[1]);
    v.extent({"z", "extent along z", required}, box.min[2], box.max[2]);
}

constexpr std::string_view across =
    "the two coordinates across the axis in the order of the alphabet (axis z: x, y; axis y: x, z; axis x: y, z)";

void describe_form(Visitor& v, CylinderShape& c)
{
    choose(v, {"axis", "direction of the cylinder", required}, c.axis);
    v.vector({"centre", across, required}, c.centre, D::length);
    v.quantity({"diameter", "outer diameter", required}, c.diameter, D::length, positive);
    v.quantity({"bore", "diameter of the hole along it; 0 for none", optional}, c.bore, D::length, non_negative);
    v.extent({"range", "from and to along the axis", required}, c.from, c.to);
    v.expect(c.bore < c.diameter, "bore", "the bore is not smaller than the diameter", "make the bore smaller");
}

void describe_form(Visitor& v, OutlineShape& o)
{
    choose(v, {"axis", "direction of extrusion", required}, o.axis);
    v.points(
        {"points", "corners around the outline, either way; their coordinates are those across the axis", required},
        o.points);
    v.loops({"holes", "outlines to leave out", optional}, o.holes);
    v.extent({"range", "from and to along the axis", required}, o.from, o.to);
    v.expect(o.points.size() >= 3, "points", "an outline needs three corners or more", "add the missing corners");
    v.expect(std::ranges::all_of(o.holes, [](const auto& hole) { return hole.size() >= 3; }), "holes",
             "a hole needs three corners or more", "add the missing corners");
}

void describe_form(Visitor& v, ShaftShape& s)
{
    choose(v, {"axis", "direction of the shaft", required}, s.axis);
    v.vector({"centre", across, required}, s.centre, D::length);
    v.quantity({"from", "coordinate along the axis where the first section begins", required}, s.from, D::length,
               any_value);
    v.list({"sections", "one after the other along the axis", required}, s.sections);
}

template <class T>
T& form_as(Shape& shape)
{
    if (!std::holds_alternative<T>(shape.form)) {
        shape.form = T{};
    }
    return std::get<T>(shape.form);
}

}  // namespace

void describe(Visitor& v, Case& c)
{
    v.about(
        "A case is one TOML file, or several by `include`. Every quantity is text with its unit, like `\"300 kN\"`; "
        "plain numbers have none. Coordinates are those of the machine at bottom dead point: z along the crankshaft, "
        "x and y across it, y up unless [machine] says otherwise; seen from z > 0, x points to the right.");
    v.integer({"format", "version of this format; 1", required}, c.format, {1, 1, false});
    v.table({"machine", "the machine as a whole", required}, c.machine);
    v.named({"materials", "solids"}, c.materials, "name");
    v.named({"lubricants", "oils and greases"}, c.lubricants, "name");
    v.named({"bodies", "the bodies of the linkage; the parts of a body move together", required}, c.bodies, "name");
    v.named({"parts", "solids of one material, each with its own mesh; `loads` does not need them"}, c.parts, "name");
    v.named({"friction", "laws of friction heat"}, c.friction, "name");
    v.quantities({"oil", "heat transfer coefficient to the circulating oil, per area of the joints, by friction law"},
                 c.oil, D::heat_transfer_coefficient);
    v.named({"oil_with_speed", "how oil coefficients change with the speed of the crank, by friction law: those of "
                               "[oil], and `oil` of the interfaces of its joints"},
            c.oil_with_speed, "friction law");
    v.named({"oil_circuits", "circulating oil that warms from joint to joint"}, c.oil_circuits, "name");
    v.named({"joints", "connections of two bodies"}, c.joints, "name");
    v.named({"bonds", "touching parts of one body that are not in perfect contact for heat: bolted, clamped, shimmed"},
            c.bonds, "name");
    v.named({"surfaces", "named sets of faces, with a boundary condition"}, c.surfaces, "name");
    v.named({"heat_sources", "heat of a motor, a clutch or a belt"}, c.heat_sources, "name");
    v.named({"enclosures", "volumes of air inside the machine, each with its own temperature"}, c.enclosures, "name");
    v.table({"mechanism", "data of the whole linkage, for the loads"}, c.mechanism);
    v.table({"crankshaft", "the crankshaft as a beam"}, c.crankshaft);
    v.table({"process_force",
             "the process (piling, blanking, forming) force over a turn; without this table its defaults hold"},
            c.process_force);
    v.list({"operation", "segments of the operation, one after the other", required}, c.operation);
    v.named({"probes", "points whose temperature is recorded"}, c.probes, "name");
    v.table({"chain", "the dimension chain from slide to table"}, c.chain);
    v.table({"foundation", "supports of the feet, and weights"}, c.foundation);
    v.named({"preload", "rods that press parts together"}, c.preload, "name");
    v.table({"numerics", "mesh, time stepping and solvers"}, c.numerics);
    v.table({"output", "what is written"}, c.output);
    v.table({"reduce", "the reduced model that `deadpoint reduce` builds"}, c.reduce);
    v.table({"reference", "published or measured values"}, c.reference);
}

void describe(Visitor& v, MachineSection& m)
{
    v.about("The machine as a whole.");
    v.text({"name", "name in reports", required}, m.name);
    v.text({"description", "a sentence for reports"}, m.description);
    v.flag({"half_model", "model x <= 0 only; the plane x = 0 is the plane of symmetry"}, m.half_model);
    v.quantity({"initial_temperature", "temperature at the start of all parts that state no other; dimensions are "
                                       "valid at this temperature, and rises count from it"},
               m.initial_temperature, D::temperature, absolute_temperature);
    v.quantity({"ambient", "temperature of the air, unless the operation or a `film` states another"}, m.ambient,
               D::temperature, absolute_temperature);
    v.vector({"gravity_direction", "direction of the weights of links and crankshaft and, with `gravity` in "
                                   "[foundation], of the frame; its component along the crankshaft loads no joint"},
             m.gravity_direction, D::none);
    v.expect(norm(m.gravity_direction) > 0, "gravity_direction", "the direction has no length",
             "write it like [0, -1, 0]");
    v.text({"front",
            "direction from the machine to its operator: x, y or z, or the opposite such as \"-z\", at right angles "
            "to the stroke; else by `left`, or z. Names of corners, slopes and views follow it"},
           m.front);
    v.text({"left",
            "direction to the left of the operator, who looks at the machine; follows from `front` and `up` "
            "(left = front x up: -x for front z and up y) and may be stated to check them, or in place of `front`"},
           m.left);
    v.text({"up", "direction of the views upwards; else the axis that is most against `gravity_direction`, which must "
                  "fit it"},
           m.up);
    for (const auto& [key, name] : {std::pair{"front", m.front}, std::pair{"left", m.left}, std::pair{"up", m.up}})
        v.expect(name.empty() || named_axis(name).has_value(), key, "this is not the name of an axis",
                 "write x, y or z, or with a sign \"-x\", \"-y\" or \"-z\"");
    v.texts({"unbonded", "pairs \"part|part\" (`*` stands for any letters) of one body that touch but are not bonded. "
                         "Other touching parts of one body are bonded, in perfect contact unless [bonds] states a "
                         "conductance"},
            m.unbonded);
}

void describe(Visitor& v, Material& m)
{
    v.about(
        "A solid. With `library`, keys that are not given come from the shipped library (see the end of this page). "
        "Tables are linear between their points and constant beyond them; a run warns if it leaves the range of a "
        "table.");
    v.text({"library", "name in the shipped library"}, m.library);
    v.from_library(m);
    const Need need = m.library.empty() ? required : optional;
    v.quantity({"density", "mass per volume", need}, m.density, D::density, positive);
    v.property({"conductivity", "thermal conductivity", need}, m.conductivity, m.conductivity_table, D::conductivity,
               positive);
    v.property({"specific_heat", "heat per mass and kelvin", need}, m.specific_heat, m.specific_heat_table,
               D::specific_heat, positive);
    v.property({"expansion", "linear thermal expansion", need}, m.expansion, m.expansion_table, D::expansion,
               any_value);
    choose(v,
           {"expansion_kind",
            "kind of a table: `mean` coefficients count from `expansion_reference` to the temperature, "
            "`instantaneous` coefficients are the slope of the length over the temperature"},
           m.expansion_kind);
    v.quantity({"expansion_reference", "temperature from which mean coefficients count"}, m.expansion_reference,
               D::temperature, absolute_temperature);
    v.quantity({"youngs_modulus", "modulus of elasticity", need}, m.youngs_modulus, D::pressure, positive);
    v.number({"poissons_ratio", "lateral contraction", need}, m.poissons_ratio, {-1, 0.5, true});
    v.text({"source", "where the values are from"}, m.source);
    const bool table = !m.expansion_table.x.empty();
    v.expect(!table || m.expansion_kind, "expansion", "the kind of coefficients in its table is not stated",
             "add expansion_kind = \"mean\" or \"instantaneous\"");
    v.expect(table || !m.expansion_kind || !m.library.empty(), "expansion_kind", "a constant coefficient has no kind",
             "remove it, or give a table");
    v.expect(!table || m.expansion_kind != Material::Expansion::mean || m.expansion_reference, "expansion",
             "the reference temperature of its mean coefficients is not stated",
             "add expansion_reference = \"20 degC\"");
    v.expect(!m.expansion_reference || m.expansion_kind == Material::Expansion::mean, "expansion_reference",
             "only mean coefficients have a reference temperature", "remove it, or say expansion_kind = \"mean\"");
}

void describe(Visitor& v, Lubricant& l)
{
    v.about("An oil. With `library`, keys that are not given come from the shipped library.");
    v.text({"library", "name in the shipped library"}, l.library);
    v.from_library(l);
    const Need need = l.library.empty() ? required : optional;
    v.quantity({"density", "mass per volume; 0 if not known"}, l.density, D::density, non_negative);
    choose(v,
           {"law",
            "`table`: log-linear between the points of `viscosity`, and beyond them with the end slopes and a warning, "
            "within the range of liquid oils (0.1 to 1e6 mm^2/s); `walther`: the line of ASTM D341 through its "
            "two points; `vogel`: nu = vogel_factor "
            "exp(vogel_b / (T - vogel_pole))"},
           l.law);
    v.curve(
        {"viscosity", "kinematic viscosity of `table` and `walther`", l.law == Lubricant::Law::vogel ? optional : need},
        l.viscosity, {"temperature", D::temperature, D::kinematic_viscosity, positive});
    v.quantity({"vogel_factor", "factor of `vogel`"}, l.vogel_factor, D::kinematic_viscosity, positive);
    v.quantity({"vogel_b", "b of `vogel`"}, l.vogel_b, D::temperature_difference, positive);
    v.quantity({"vogel_pole", "pole temperature of `vogel`"}, l.vogel_pole, D::temperature, positive);
    v.expect(l.law != Lubricant::Law::walther || l.viscosity.x.size() == 2, "viscosity",
             "the line of ASTM D341 goes through two points",
             "give two temperatures, usually 40 and 100 degC, or law = \"table\"");
    const bool vogel = l.law == Lubricant::Law::vogel;
    v.expect(!vogel || (l.vogel_factor && l.vogel_b), "law", "`vogel` needs `vogel_factor` and `vogel_b`", "add both");
    v.expect(vogel || !(l.vogel_factor || l.vogel_b), l.vogel_factor ? "vogel_factor" : "vogel_b",
             "it belongs to law = \"vogel\"", "remove it, or add the law");
    v.text({"source", "where the values are from"}, l.source);
}

void describe(Visitor& v, Body& b)
{
    v.about("A body of the linkage: parts that move together. Exactly one body is the ground. Mass, centre and inertia "
            "follow from the parts unless stated. A body without parts must state mass and centre; without a stated "
            "inertia it is a slender rod between its joints.");
    v.quantity(
        {"mass", "mass of the whole body (with `mirror`, of one of the two); compared with the mass of its parts"},
        b.mass, D::mass, positive);
    v.vector({"centre_of_mass", "x and y at bottom dead point"}, b.centre_of_mass, D::length);
    v.quantity({"inertia", "moment of inertia about the z axis through the centre of mass"}, b.inertia, D::inertia,
               positive);
    v.quantity({"initial_temperature", "temperature of its parts at the start; else that of the machine"},
               b.initial_temperature, D::temperature, absolute_temperature);
    v.flag({"ground", "the body that stands still"}, b.ground);
    v.flag({"mirror", "the body exists twice; the loads include its image at x = 0 and the images of its joints"},
           b.mirror);
    v.flag({"thermal_only", "the body conducts heat but is not a link of the dimension chain (bearing rings)"},
           b.thermal_only);
    v.expect(!(b.ground && b.thermal_only), "thermal_only", "the ground is a link of the dimension chain",
             "remove one of `ground` and `thermal_only`");
    v.expect(!(b.ground && b.mirror), "mirror", "the ground exists once only", "remove one of `ground` and `mirror`");
}

void describe(Visitor& v, Part& p)
{
    v.about("A solid of one material. Exactly one of `shapes`, `step` and `mesh` gives its form.");
    v.text({"body", "the body it belongs to", required}, p.body);
    v.text({"material", "its material", required}, p.material);
    v.quantity({"size", "target cell size; else that of [numerics]"}, p.size, D::length, positive);
    v.list({"shapes", "primitives, joined and cut in the order given"}, p.shapes);
    v.path({"step", "STEP file, relative to the file that names it"}, p.step);
    SolidReference solid = solid_reference(p.solid);
    v.text({"solid", "the solid of the STEP file that is this part, by its name there; else all solids of the file"},
           solid.name);
    v.text({"fingerprint",
            "figures that tell the solid from others, written by `init`: \"0.25 L, 100 x 50 x 50 mm at (50, 0, "
            "25) mm\" are its volume, the box around it and the centre of its volume, in the axes of the file. "
            "Of several solids of one name they choose; where they are another solid's, the name is refused. "
            "Volumes agree within 0.5 %, lengths within 0.2 % of the longest edge"},
           solid.fingerprint);
    p.solid = text_of(solid);
    v.texts({"axes",
             "the directions of the STEP file that are x, y and z of the machine, such as [\"x\", \"z\", \"-y\"]; "
             "right-handed"},
            p.axes);
    v.integer({"circle_cells", "cells of a STEP part around a full circle, where `smallest_cell` allows"},
              p.circle_cells, {6, 200, false});
    v.quantity({"smallest_cell", "smallest cell of a STEP part on curved faces; else a third of its size"},
               p.smallest_cell, D::length, positive);
    v.quantity({"omit", "holes and roundings of a STEP part up to this diameter are left out; else those up to "
                        "`smallest_cell`; \"0 mm\": none"},
               p.omit, D::length, non_negative);
    v.path({"mesh", "Gmsh mesh file (MSH 2 or 4), relative to the file that names it"}, p.mesh);
    v.quantity(
        {"unit", "length of one unit of the STEP or mesh file; else what a STEP file says, and 1 m for a mesh file"},
        p.unit, D::length, positive);
    v.vector({"position", "position of the origin of the STEP or mesh file"}, p.position, D::length);
    v.quantity({"initial_temperature", "temperature at the start; else that of its body"}, p.initial_temperature,
               D::temperature, absolute_temperature);
    v.flag({"tetrahedra", "use tetrahedra even where hexahedra are possible"}, p.tetrahedra);
    v.integer({"order", "order of its finite elements; 0: that of [numerics]"}, p.order, {0, 2, false});
    const int sources = (p.shapes.empty() ? 0 : 1) + (p.step.empty() ? 0 : 1) + (p.mesh.empty() ? 0 : 1);
    v.expect(sources > 0, "", "the part has no form", "give one of `shapes`, `step` and `mesh`");
    v.expect(sources < 2, p.step.empty() ? "mesh" : "step", "the part has more than one form",
             "keep one of `shapes`, `step` and `mesh`");
    for (const auto& [key, given] :
         {std::pair{"solid", !solid.name.empty()}, std::pair{"fingerprint", !solid.fingerprint.empty()},
          std::pair{"axes", !p.axes.empty()}, std::pair{"smallest_cell", p.smallest_cell.has_value()},
          std::pair{"omit", p.omit.has_value()}}) {
        v.expect(!given || !p.step.empty(), key, "it belongs to a part from a STEP file", "remove it, or add `step`");
    }
    v.expect(solid.fingerprint.empty() || solid_print(solid.fingerprint), "fingerprint",
             "these are no figures of a solid", "write them like \"0.25 L, 100 x 50 x 50 mm at (50, 0, 25) mm\"");
    v.expect(p.axes.empty() || named_axes(p.axes).has_value(), "axes",
             "these are not three directions of a right-handed system",
             "name each of x, y and z once, with signs that do not mirror: [\"x\", \"z\", \"-y\"]");
    v.expect(p.shapes.empty() || p.shapes.front().operation == Shape::Operation::add, "shapes",
             "the first shape must be added: there is nothing to cut or to draw on", "begin with add = ...");
}

void describe(Visitor& v, Shape& s)
{
    constexpr std::array<std::string_view, 3> operations{"add", "cut", "imprint"};
    constexpr std::array<std::string_view, 4> forms{"box", "cylinder", "outline", "shaft"};
    v.about(
        "A primitive. Its first key says what it does: `add` joins it to the part, `cut` removes it, `imprint` only "
        "draws its outline into the mesh; the value of that key is its form.");
    auto operation = static_cast<std::size_t>(s.operation);
    for (const std::size_t form : v.tagged(operations, operation, forms, s.form.index(), "form of the primitive")) {
        s.operation = static_cast<Shape::Operation>(operation);
        v.alternative(forms.at(form));
        if (form == 0) {
            describe_form(v, form_as<BoxShape>(s));
        }
        if (form == 1) {
            describe_form(v, form_as<CylinderShape>(s));
        }
        if (form == 2) {
            describe_form(v, form_as<OutlineShape>(s));
        }
        if (form == 3) {
            describe_form(v, form_as<ShaftShape>(s));
        }
    }
}

void describe(Visitor& v, ShaftSection& s)
{
    v.quantity({"length", "length along the axis", required}, s.length, D::length, positive);
    v.quantity({"diameter", "diameter of this section", required}, s.diameter, D::length, positive);
    v.vector({"offset", "offset of this section's centre from the axis of the shaft (crank throw)"}, s.offset,
             D::length);
}

void describe(Visitor& v, Joint& j)
{
    v.about("A joint describes one connection of two bodies completely: their relative motion, their friction law, and "
            "the surfaces that touch with their conductance.");
    choose(v, {"kind", "relative motion of the bodies", required}, j.kind);
    v.texts({"bodies", "the two bodies", required}, j.bodies);
    v.vector({"centre", "x and y at bottom dead point", required}, j.centre, D::length);
    v.vector({"direction", "direction of travel of a slide: any direction of the plane"}, j.direction, D::none);
    v.flag({"guides_rotation", "false for a slide whose body can rotate"}, j.guides_rotation);
    v.flag({"swept", "for a slide: heat and conductance are distributed over the length that it sweeps, by the share "
                     "of time; false keeps them at the drawn position"},
           j.swept);
    v.quantity({"preload", "for a slide: force by which the gib presses on each of the two faces"}, j.preload, D::force,
               non_negative);
    v.quantity({"guide_length",
                "for a slide that guides rotation: distance of the guide's two ends along the travel, with "
                "`centre` in the middle; without it, the moment on the guide does not load its faces"},
               j.guide_length, D::length, positive);
    v.flag({"turns_fully", "the joint makes full turns, so that each side sees the circumferential mean of the other"},
           j.turns_fully);
    v.flag({"driver", "its angle is the crank angle"}, j.driver);
    v.text({"friction", "law of its friction heat"}, j.friction);
    v.quantity({"oil_temperature", "temperature of the oil that carries heat away, if no circuit serves the joint"},
               j.oil_temperature, D::temperature, absolute_temperature);
    v.quantity({"clearance", "clearance of each of its bearings at the start, on the diameter; for a slide, of both "
                             "faces together. A run warns when heat uses it up"},
               j.clearance, D::length, positive);
    v.table({"ball", "seat of a ball joint"}, j.ball);
    v.list({"elements", "the bearings or bushes that share the joint"}, j.elements);
    v.list({"interfaces", "pairs of touching surfaces"}, j.interfaces);
    v.expect(j.bodies.size() == 2, "bodies", "a joint connects two bodies",
             "write it like bodies = [\"crank\", \"frame\"]");
    v.expect(norm(j.direction) > 0, "direction", "the direction of travel has no length", "write it like [0, 1]");
    v.expect(j.preload == 0 || j.kind == Joint::Kind::slide, "preload", "only a slide has a gib to press on it",
             "remove `preload`");
    v.expect(j.swept || j.kind == Joint::Kind::slide, "swept", "only a slide travels along a guide", "remove `swept`");
    v.expect(!j.guide_length || (j.kind == Joint::Kind::slide && j.guides_rotation), "guide_length",
             "only a slide that guides rotation carries a moment over its length", "remove `guide_length`");
    v.expect(!j.driver || j.kind == Joint::Kind::revolute, "driver",
             j.kind == Joint::Kind::ball ? "a ball joint cannot drive the crank" : "a slide cannot drive the crank",
             "name a revolute joint as driver");
    v.expect(j.ball || j.kind != Joint::Kind::ball, "kind", "a ball joint needs its seat",
             "add ball = { diameter = \"80 mm\" }");
    v.expect(!j.ball || j.elements.empty(), "elements", "a ball joint has one seat and no bearings side by side",
             "remove `elements`");
    v.expect(!j.ball || !j.turns_fully, "turns_fully", "a ball in its socket swings to and fro",
             "remove `turns_fully`");
    v.expect(!j.ball || j.kind == Joint::Kind::ball, "ball", "only a ball joint has a spherical seat",
             "remove `ball`, or let `kind` be \"ball\"");
}

void describe(Visitor& v, BallSeat& s)
{
    v.about("The zone of the ball that touches its socket. The joint turns like a pin about z; its friction, contact "
            "pressure and conductance are those of the seat, whose heat enters at the interfaces as drawn.");
    constexpr double quarter = 0.5 * std::numbers::pi;
    v.quantity({"diameter", "diameter of the ball", required}, s.diameter, D::length, positive);
    v.quantity({"from", "half angle of the relief in the middle of the seat, from the line of force"}, s.from, D::angle,
               {0, quarter, false});
    v.quantity({"to", "half angle to the rim of the seat; \"90 deg\" for a half ball"}, s.to, D::angle,
               {0, quarter, false});
    v.expect(s.from < s.to, "to", "the rim of the seat lies inside its relief", "let `to` be larger than `from`");
}

void describe(Visitor& v, JointElement& e)
{
    v.text({"name", "name in reports", required}, e.name);
    choose(v, {"type", "type of the bearing", required}, e.type);
    v.quantity({"position", "position along the axis"}, e.position, D::length, any_value);
    v.quantity({"width", "width along the axis"}, e.width, D::length, non_negative);
    v.quantity({"diameter", "diameter of its running surface"}, e.diameter, D::length, non_negative);
}

void describe(Visitor& v, Interface& i)
{
    v.text({"name", "name within the joint", required}, i.name);
    v.text({"a", "the integrated side, which the other must cover: a part (with `diameter`) or a surface", required},
           i.a);
    v.text({"b", "the other side: a part (with `diameter`) or a surface", required}, i.b);
    v.quantity({"diameter", "diameter of the cylinder about the joint's centre; without it both sides are surfaces"},
               i.diameter, D::length, positive);
    v.table({"conductance", "contact conductance", required}, i.conductance);
    v.quantity({"oil", "heat transfer coefficient to the circulating oil, per area of the joint"}, i.oil,
               D::heat_transfer_coefficient, non_negative);
    v.number({"heat_share", "share of the friction heat per area, relative to the other interfaces of the law"},
             i.heat_share, non_negative);
    v.text({"heat_into", "part whose volume receives the friction heat of this interface; else the contact layer "
                         "between the sides receives it"},
           i.heat_into);
    v.flag({"load_zone", "the load part of that heat is distributed over the zone in which the joint is pressed during "
                         "the turn; only if no side rotates away from it"},
           i.load_zone);
    v.flag({"partial", "side a may reach beyond side b; only the touching area conducts, the rest is exposed"},
           i.partial);
    v.quantity({"drawn_gap",
                "largest distance of the two sides as drawn that still counts as contact; else 10 um. For parts "
                "that are drawn with their clearance"},
               i.drawn_gap, D::length, positive);
    v.flag({"stands_still", "this interface does not rotate, although the joint makes full turns (outer rings)"},
           i.stands_still);
    v.flag({"seat",
            "it carries the joint in the ground body, whose centre there is the mean of the centres fitted to the "
            "interfaces so marked; to all of them if none is. A bearing of the crank has play if it has a seat "
            "and a journal"},
           i.seat);
    v.flag({"journal", "as `seat`, in the body that moves in the ground; between two moving bodies either mark counts"},
           i.journal);
}

void describe(Visitor& v, Bond& b)
{
    v.about("Parts of one body that are held together without being one solid. They still move together; heat passes "
            "by a conductance. Where the parts do not touch, or [machine] leaves them `unbonded`, there is no bond.");
    v.texts({"between", "pairs \"part|part\" (`*` stands for any letters) of touching parts of one body", required},
            b.between);
    v.table({"conductance", "contact conductance; { value = \"0 W/m^2/K\" }: no heat passes", required}, b.conductance);
    v.expect(!std::holds_alternative<RollingElements>(b.conductance), "conductance",
             "rolling elements conduct in a joint; the parts of a body do not turn against each other",
             "give a `value`, a `resistance` or a law of surfaces, or make the bearing a joint");
}

void describe(Visitor& v, Surface& s)
{
    v.about(
        "A set of exterior faces: all conditions given must hold. A surface may carry one of `film`, `temperature`, "
        "`temperature_formula`, `heat_flux` and `insulated`; without any it only names its faces.");
    v.texts({"parts", "names of parts, `*` stands for any letters; none: every part"}, s.parts);
    choose(v,
           {"select",
            "how faces are selected. `exposed`: faces that nothing touches and no other surface claims; `all`: all "
            "faces; the others need the keys of the same meaning below",
            required},
           s.select);
    choose(v, {"axis", "normal of the plane, axis of the cylinder"}, s.axis);
    v.quantity({"position", "position of the plane along its normal"}, s.position, D::length, any_value);
    v.vector({"normal", "normal of an inclined plane, of any length and sign, instead of `axis`"}, s.normal, D::none);
    const bool inclined = s.normal != Vec3{};
    v.vector({"point", "x, y, z of a point on the plane with that normal", inclined ? required : optional}, s.point,
             D::length);
    v.vector({"centre", across}, s.centre, D::length);
    v.quantity({"diameter", "diameter of the cylinder"}, s.diameter, D::length, positive);
    v.text({"group", "physical group of the part's mesh or STEP file"}, s.group);
    v.table({"within", "only faces in this box: a face that reaches out of it counts by the share of its area inside. "
                       "Prescribed temperatures, supports and corners use the faces whose centre is inside"},
            s.within);
    v.table({"film", "convection coefficient and radiation"}, s.film);
    v.course({"temperature", "prescribed temperature"}, s.temperature, D::temperature, absolute_temperature);
    v.text({"temperature_formula",
            "prescribed temperature [K] in x, y, z [m] and t [s], like \"293.15 + 10*sin(pi*t/40)\"; above 0 K, and "
            "below 150 K with a warning; what lasts shorter than 1 s may be missed"},
           s.temperature_formula);
    v.course({"heat_flux", "heat into the part"}, s.heat_flux, D::heat_flux, any_value);
    v.flag({"insulated", "no heat passes; an `exposed` surface does not contain these faces"}, s.insulated);
    const bool plane = s.select == Surface::Select::plane;
    const bool cylinder = s.select == Surface::Select::cylinder;
    v.expect(!(plane || cylinder) || inclined || s.axis, "select", "the selection needs an `axis`", "add axis = \"z\"");
    v.expect(!plane || inclined || s.position, "select", "a plane needs its `position`", "add position = \"0 mm\"");
    v.expect(!inclined || (plane && !s.axis && !s.position), "normal",
             "a normal belongs to a plane that has neither `axis` nor `position`",
             "keep normal = [0.6, 0.8, 0] with a point, or axis and position");
    v.expect(!cylinder || (s.centre && s.diameter), "select", "a cylinder needs `centre` and `diameter`",
             "add both, like centre = [\"0 mm\", \"0 mm\"], diameter = \"80 mm\"");
    v.expect(s.select != Surface::Select::box || s.within, "select", "a box needs `within`",
             "add within = { x = [\"0 mm\", \"1 mm\"], y = [...], z = [...] }");
    v.expect(s.select != Surface::Select::group || !s.group.empty(), "select", "a group needs its name",
             "add group = \"name\"");
    const int effects = (s.film ? 1 : 0) + (s.temperature ? 1 : 0) + (s.temperature_formula.empty() ? 0 : 1) +
                        (s.heat_flux ? 1 : 0) + (s.insulated ? 1 : 0);
    v.expect(effects < 2, "", "the surface has more than one boundary condition",
             "keep one of `film`, `temperature`, `temperature_formula`, `heat_flux` and `insulated`");
}

void describe(Visitor& v, BoxShape& b)
{
    constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    v.about("A direction that is not given is not limited (1 km to either side).");
    for (std::size_t i = 0; i < 3; ++i) {
        if (b.min[i] == b.max[i]) {
            b.min[i] = -everywhere;
            b.max[i] = everywhere;
        }
        v.extent({names[i], "from and to"}, b.min[i], b.max[i]);
    }
}

void describe(Visitor& v, Segment& s)
{
    v.about("A segment of the operation: run, pause or cool-down.");
    v.text({"name", "name in reports"}, s.name);
    v.quantity({"duration", "duration; `run` needs it"}, s.duration, D::time, non_negative);
    v.quantity({"speed", "speed of the crank; 0 rpm is a pause", required}, s.speed, D::angular_velocity, non_negative);
    v.quantity({"force", "peak of the process (piling, blanking, forming) force"}, s.force, D::force, non_negative);
    v.course({"ambient",
              "temperature of the air, instead of that of the machine; time counts from the start of the segment"},
             s.ambient, D::temperature, absolute_temperature);
}

void describe(Visitor& v, Probe& p)
{
    v.about("A point whose temperature is recorded.");
    v.text({"part", "the part on which it is", required}, p.part);
    v.vector({"position", "x, y, z", required}, p.position, D::length);
    v.text({"note", "for reports"}, p.note);
}

void describe(Visitor& v, Chain& c)
{
    v.about("The dimension chain: the dimensions that add up to the gap between slide and table.");
    v.text({"slide_body", "the body that carries the tool", required}, c.slide_body);
    v.text({"slide_surface", "surface of the slide that faces the table", required}, c.slide_surface);
    v.text({"table_surface", "surface of the table that faces the slide", required}, c.table_surface);
    v.text({"ground_surface", "the feet of the machine", required}, c.ground_surface);
    v.text({"crank_joint", "joint of crankshaft and ground", required}, c.crank_joint);
    v.quantity({"reaction_angle",
                "direction in which the crank is pressed into its bearings at bottom dead point, from the x axis; "
                "without it the direction of the stroke, in which the process presses slide and crank"},
               c.reaction_angle, D::angle, any_value);
    choose(v,
           {"bearing_play",
            "motion of the crank when heat opens or closes its bearings. `limited`: closing ends when the `clearance` "
            "of the crank joint is used up; `none`: no motion, as for bearings under preload; `paper`: the full change "
            "counts for any play (Zheng et al. 2018). Default: `limited` if the joint states a clearance, else `none` "
            "for rolling and `paper` for plain bearings, and the run states the effect on E_SW"},
           c.bearing_play);
    v.quantity({"drift_rate_limit", "the press is warm when its drift stays slower than this; 0 for no such time"},
               c.drift_rate_limit, D::velocity, non_negative);
    v.flag({"corners", "also follows the gap at the four corners of the slide; one solve of the deformation each"},
           c.corners);
    v.flag({"clearances", "also follows the clearances of guides and bearings; one solve of the deformation each"},
           c.clearances);
    v.quantity({"press_stiffness", "stiffness of press and tool in series, measured at the slide of the whole press; a "
                                   "run then states the change of the process force at a fixed die height"},
               c.press_stiffness, D::stiffness, positive);
}

void describe(Visitor& v, Reduce& r)
{
    v.about("Coefficients that are free in a reduced model, each with its range as [least, most], and how accurate the "
            "model is to be. Ranges are factors on the coefficients of the case, except those of temperatures. A range "
            "of no width holds its coefficient, which takes fewer states.");
    const auto range = [&](const Key& key, std::array<double, 2>& value, Dimension dimension, double lowest) {
        v.vector(key, value, dimension);
        v.expect(value[0] <= value[1] && value[0] >= lowest, key.name,
                 "the range is not ascending, or a factor is negative", "write it like [0.5, 2]");
    };
    const double any = std::numeric_limits<double>::lowest();
    range({"film", "convection, of each surface on each part"}, r.film, D::none, 0);
    range({"conductance", "contact conductance of each side of each interface"}, r.conductance, D::none, 0);
    range({"oil", "oil coefficient of each interface; where the case has none, of 500 W/m2/K"}, r.oil, D::none, 0);
    range({"friction", "friction heat of each friction law; where it is wide it covers speed and force too"},
          r.friction, D::none, 0);
    const auto around_case = [&](const Key& key, std::array<double, 2>& value) {
        range(key, value, D::none, 0);
        v.expect(value[0] <= 1 && value[1] >= 1, key.name, "the range does not hold 1, which is the case itself",
                 "write factors on what the case states, like [0.5, 1.2]");
    };
    around_case({"speed", "speed of the whole operation, as the friction laws see it"}, r.speed);
    around_case({"force", "process force of the whole operation, as the friction laws see it"}, r.force);
    range({"oil_temperature", "difference of all oil temperatures"}, r.oil_temperature, D::temperature_difference, any);
    range({"ambient", "difference of all ambient temperatures"}, r.ambient, D::temperature_difference, any);
    v.flag({"together", "one range for each surface and each interface, instead of one for each part and side"},
           r.together);
    v.quantity({"temperature", "wanted error of probes and sides of joints, after the first minute"}, r.temperature,
               D::temperature_difference, positive);
    v.quantity({"gap", "wanted error of the gap"}, r.gap, D::length, positive);
    v.integer({"states", "largest number of states"}, r.states, {10, 2000, false});
}

void describe(Visitor& v, Numerics& n)
{
    v.about("Mesh, time stepping and solvers.");
    v.quantity({"size", "target cell size of parts that state none"}, n.size, D::length, positive);
    v.quantity({"seam_tolerance", "shapes of one part are joined if their distance or overlap is at most this"},
               n.seam_tolerance, D::length, positive);
    v.number({"deformation_size", "cell sizes of the deformation mesh relative to the heat mesh; 1: the same mesh; 0: "
                                  "the same mesh up to 1.5 million unknowns of deformation, a coarser one beyond"},
             n.deformation_size, non_negative);
    v.integer({"deformation_order", "order of the finite elements of the deformation; 0: that of the heat"},
              n.deformation_order, {0, 2, false});
    v.quantity(
        {"time_tolerance",
         "target error of the time steps, at probes and joints, in sumps and enclosed air; it limits the error of each "
         "step. Below 0.02 K the limit falls with its power 3/2, so that the accumulated error of a run stays near it"},
        n.time_tolerance, D::temperature_difference, positive);
    v.quantity({"initial_step", "first time step"}, n.initial_step, D::time, positive);
    v.quantity({"max_step", "largest time step"}, n.max_step, D::time, positive);
    v.number(
        {"solver_tolerance", "allowed root mean square error of a linear solve of the temperature field, in kelvin"},
        n.solver_tolerance, {0, 1, true});
    v.integer({"order", "order of the finite elements"}, n.order, {1, 2, false});
    v.text({"accuracy", "refine parts and time steps until the rises (\"0.1 K\") or the gap (\"0.2 um\") change by "
                        "less than this; only for 'run'"},
           n.accuracy);
    v.integer({"accuracy_rounds", "largest number of meshes for `accuracy`"}, n.accuracy_rounds, {2, 100, false});
    v.integer({"accuracy_cells", "largest number of cells of a mesh for `accuracy`"}, n.accuracy_cells,
              {1, 100000000, false});
    if (const auto parsed = parse_accuracy(n.accuracy); !n.accuracy.empty()) {
        const auto* problem = std::get_if<AccuracyProblem>(&parsed);
        v.expect(problem == nullptr, "accuracy", problem != nullptr ? problem->message : "",
                 problem != nullptr ? problem->help : "");
    }
    v.expect(n.initial_step <= n.max_step, "initial_step", "the first time step is longer than the largest one",
             "make `initial_step` at most `max_step`");
}

void describe(Visitor& v, Output& o)
{
    v.about("Files written besides the summary.");
    v.quantity({"history_interval", "time between rows of history.csv"}, o.history_interval, D::time, positive);
    v.quantities({"field_times", "times at which fields are written, in addition to the end"}, o.field_times, D::time,
                 non_negative);
    v.flag({"fields", "write temperature and displacement fields"}, o.fields);
    v.flag({"causes", "compute the contributions of the heat sources to the gap. A sweep does not compute them"},
           o.causes);
    choose(
        v,
        {"causes_by",
         "`steps`: run backward over all time steps, which takes as long as the time steps; `basis`: the same on some "
         "twenty fields, with each contribution right to about 0.1 %; `size`: `basis` from 100 000 temperatures on. "
         "Where a temperature is prescribed, always `steps`"},
        o.causes_by);
    v.texts({"stress", "bodies or parts (`*` stands for any letters) whose stress is computed at the times of the "
                       "fields: stress in the fields, and the largest of each part in stress.csv"},
            o.stress);
}

void describe(Visitor& v, Reference& r)
{
    v.about("Published or measured values, shown beside the result; the model does not use them.");
    v.text({"source", "where the values are from", required}, r.source);
    v.quantity({"time", "time at which the rises were read", required}, r.time, D::time, positive);
    v.quantities({"rises", "temperature rise by probe"}, r.rises, D::temperature_difference);
    v.texts({"calibrated_on", "keys of the case that were fitted to these values"}, r.calibrated_on);
}

void describe(Visitor& v, Library& library)
{
    v.named({"materials", "solids"}, library.materials, "name");
    v.named({"lubricants", "oils"}, library.lubricants, "name");
}

}  // namespace deadpoint::casefile
