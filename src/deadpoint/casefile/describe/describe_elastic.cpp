#include "deadpoint/casefile/describe/choose.hpp"

namespace deadpoint::casefile {
namespace {

using D = Dimension;

}  // namespace

void describe(Visitor& v, Foundation& f)
{
    v.about("The supports of the feet. Without this table the feet slide freely in their plane, whose normal is along "
            "x, y or z, and do not leave it.");
    choose(v,
           {"kind", "`free`: the feet stay in their plane and slide; `clamped`: they do not move; `elastic`: they "
                    "stand on linear elastic pads"},
           f.kind);
    v.text({"surface", "the feet; else the `ground_surface` of [chain]"}, f.surface);
    v.quantity(
        {"vertical_stiffness", "stiffness of the pads normal to the plane of the feet, per area; `elastic` only"},
        f.vertical_stiffness, D::bedding, positive);
    v.quantity(
        {"horizontal_stiffness", "stiffness of the pads in the plane of the feet, per area; without it the feet slide"},
        f.horizontal_stiffness, D::bedding, non_negative);
    v.quantity(
        {"gravity",
         "acceleration of gravity on the parts that stand on the feet, along `gravity_direction` of [machine], for "
         "stress and preload; the drift does not depend on it"},
        f.gravity, D::acceleration, non_negative);
    const bool elastic = f.kind == Foundation::Kind::elastic;
    v.expect(!elastic || f.vertical_stiffness, "kind", "the stiffness of the pads is not given",
             "add vertical_stiffness = \"0.5 N/mm^3\" (force per travel and area)");
    v.expect(elastic || !(f.vertical_stiffness || f.horizontal_stiffness),
             f.vertical_stiffness ? "vertical_stiffness" : "horizontal_stiffness",
             "only an elastic foundation has pads", "remove it, or add kind = \"elastic\"");
}

void describe(Visitor& v, Preload& p)
{
    v.about("Rods or bolts that are stretched at assembly and press parts together. Each named part is one rod, bonded "
            "to the machine at its two ends. The run reports how warming changes the forces of the rods.");
    v.texts({"parts", "the rods: names of parts, `*` stands for any letters", required}, p.parts);
    choose(v, {"axis", "direction of the rods; y unless stated"}, p.axis);
    v.quantity({"force", "force in each rod at the start", required}, p.force, D::force, positive);
    v.number({"process_share",
              "share of the process force that each rod has to hold; the run warns if a rod falls below it"},
             p.process_share, fraction);
    v.texts({"closes", "pairs \"part|part\" (`*` stands for any letters) that only the preload holds together, without "
                       "glue or weld: the run warns if one would open"},
            p.closes);
    v.expect(!p.parts.empty(), "parts", "no rod is named", "name the parts that are the rods");
}

}  // namespace deadpoint::casefile
