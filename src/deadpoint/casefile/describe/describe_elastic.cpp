#include "deadpoint/casefile/describe/choose.hpp"

namespace deadpoint::casefile {
namespace {

using D = Dimension;
constexpr auto required = Need::required;

}  // namespace

void describe(Visitor& v, Foundation& f)
{
    v.about("How the feet stand. Without this table they slide freely in their plane, which looks along x, y or z, and "
            "do not "
            "leave it.");
    choose(v,
           {"kind",
            "`free`: the feet stay in their plane and slide; `clamped`: they do not move; `elastic`: they stand on "
            "pads that give way in proportion"},
           f.kind);
    v.text({"surface", "the feet; else the `ground_surface` of [chain]"}, f.surface);
    v.quantity({"vertical_stiffness", "of the pads across the feet's plane, per area; `elastic` only"},
               f.vertical_stiffness, D::bedding, positive);
    v.quantity({"horizontal_stiffness", "of the pads along the feet's plane, per area; without it they slide"},
               f.horizontal_stiffness, D::bedding, non_negative);
    v.quantity({"gravity",
                "acceleration of gravity on what stands on the feet, along `gravity_direction` of [machine], for "
                "stress and preload; the drift does not depend on it"},
               f.gravity, D::acceleration, non_negative);
    const bool elastic = f.kind == Foundation::Kind::elastic;
    v.expect(!elastic || f.vertical_stiffness, "kind", "nothing says how far the pads give way",
             "add vertical_stiffness = \"0.5 N/mm^3\" (force per travel and area)");
    v.expect(elastic || !(f.vertical_stiffness || f.horizontal_stiffness),
             f.vertical_stiffness ? "vertical_stiffness" : "horizontal_stiffness",
             "only an elastic foundation has pads", "remove it, or add kind = \"elastic\"");
}

void describe(Visitor& v, Preload& p)
{
    v.about(
        "Rods or bolts that are stretched at assembly and press parts together. Every part named is one rod, bonded "
        "to the machine at its two ends. The run reports how warming changes their forces.");
    v.texts({"parts", "the rods: names of parts, `*` stands for any letters", required}, p.parts);
    choose(v, {"axis", "along the rods; y unless stated"}, p.axis);
    v.quantity({"force", "in each rod at the start", required}, p.force, D::force, positive);
    v.number({"process_share", "share of the process force that each rod has to hold; a rod that falls below it is "
                               "warned about"},
             p.process_share, fraction);
    v.texts({"closes", "pairs \"part|part\" (`*` stands for any letters) that nothing but the preload holds together, "
                       "neither glue nor weld: one that would open is warned about"},
            p.closes);
    v.expect(!p.parts.empty(), "parts", "no rod is named", "name the parts that are the rods");
}

}  // namespace deadpoint::casefile
