#include "deadpoint/casefile/describe/choose.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <initializer_list>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

/// A key belongs to some of the laws; given with another one it is an error.
class LawKeys {
public:
    LawKeys(Visitor& v, const Friction& f) : v_(v), law_(f.law) {}

    void allowed(bool given, std::string_view key, std::initializer_list<std::string_view> laws)
    {
        const bool fits = law_.empty() || std::ranges::find(laws, law_) != laws.end();
        v_.expect(!given || fits, key, fmt::format("law = \"{}\" does not use '{}'", law_, key),
                  "remove it, or take another law");
    }
    void needed(bool given, std::string_view key, std::initializer_list<std::string_view> laws)
    {
        allowed(given, key, laws);
        const bool named = std::ranges::find(laws, law_) != laws.end();
        v_.expect(!named || given, "law", fmt::format("'{}' is missing for law = \"{}\"", key, law_),
                  fmt::format("add `{}`", key));
    }

private:
    Visitor& v_;
    const std::string& law_;
};

void describe_calibrated(Visitor& v, Friction& f)
{
    const Need need = f.law.empty() || f.law == "calibrated" ? Need::required : Need::optional;
    choose(v, {"kind", "`calibrated` only: how the heat changes with speed and load", need}, f.kind,
           {"rolling", "pin", "guide"});
    v.quantity({"load_part", "heat that does not depend on the viscosity"}, f.load_part, D::power, non_negative);
    v.quantity({"viscous_part", "heat at a viscosity of 1 mm^2/s, less the load part"}, f.viscous_part, D::power,
               non_negative);
    v.number({"exponent", "of the viscosity"}, f.exponent, {0, 2, false});
    v.quantity({"reference_speed", "`calibrated` only: crank speed at which the heat was found", need},
               f.reference_speed, D::angular_velocity, positive);
    v.quantity({"reference_force",
                "process force at which the load part was found, with the flexible crankshaft if there is one; with "
                "it the load part follows the joints' loads, without it the speed only"},
               f.reference_force, D::force, non_negative);
    v.quantity({"reference_stiffness",
                "stiffness of each crankshaft bearing at which the load part was found; else that of the case"},
               f.reference_stiffness, D::stiffness, positive);
}

void describe_rolling(Visitor& v, Friction& f)
{
    choose(v,
           {"bearing", "`palmgren`, `skf`: type of each bearing (`skf` knows single angular contact and cylindrical)"},
           f.bearing,
           {"deep_groove_ball", "angular_contact_ball", "angular_contact_ball_pair", "cylindrical_roller",
            "needle_roller", "tapered_roller", "spherical_roller"});
    choose(v, {"oil_supply", "`palmgren`: how the oil gets there"}, f.oil_supply, {"mist", "bath", "jet"});
    v.quantity({"mean_diameter", "`palmgren`: mean of bore and outside"}, f.mean_diameter, D::length, positive);
    v.quantity({"static_rating", "`palmgren`: static load rating C0"}, f.static_rating, D::force, positive);
    v.quantity({"contact_angle", "`palmgren`: of balls or rollers"}, f.contact_angle, D::angle, non_negative);
    v.quantity({"lubrication_factor", "`palmgren`: f0; else by type and oil supply"}, f.lubrication_factor, D::none,
               positive);
    v.quantity({"bore", "`skf`: bore of the bearing"}, f.bore, D::length, positive);
    v.quantity({"outside_diameter", "`skf`: outside diameter of the bearing"}, f.outside_diameter, D::length, positive);
    v.quantity({"axial_preload", "`palmgren`, `skf`: of each bearing"}, f.axial_preload, D::force, non_negative);
    v.integer({"balls", "`palmgren`: of a row; with it spin friction is added"}, f.balls, {0, 1000, false});
    v.quantity({"ball_diameter", "`palmgren`: for spin friction"}, f.ball_diameter, D::length, positive);
    v.number({"osculation", "`palmgren`: groove radius over ball diameter, for spin friction"}, f.osculation,
             {0.5, 1, true});
    v.number({"spin_friction", "`palmgren`: coefficient of sliding between ball and groove"}, f.spin_friction,
             non_negative);
    v.quantity(
        {"ring_expansion",
         "`palmgren`: of rings and balls; with it a temperature difference between the joint's journals and seats "
         "changes the preload of its angular contact bearings, and so their heat"},
        f.ring_expansion, D::expansion, positive);
    choose(v, {"arrangement", "of a pair with `ring_expansion`"}, f.arrangement, {"back_to_back", "face_to_face"});
    v.quantity({"row_distance", "between the ball centres of the two rows of a pair, for `ring_expansion`"},
               f.row_distance, D::length, non_negative);
}

void describe_plain(Visitor& v, Friction& f)
{
    v.quantity({"coefficient", "`pin`, `guide`: Coulomb friction under the load"}, f.coefficient, D::none,
               non_negative);
    v.quantity({"diameter", "`pin`: else that of the joint's elements or of its interface"}, f.diameter, D::length,
               positive);
    v.quantity({"length", "`pin`: of the bush; else the width of the joint's elements"}, f.length, D::length, positive);
    v.quantity({"clearance", "`pin`: radial, for the shear of the oil film; without it there is none"}, f.clearance,
               D::length, positive);
    v.quantity({"film_thickness", "`guide`: of the oil film; without it there is no shear"}, f.film_thickness,
               D::length, positive);
    v.quantity({"film_area", "`guide`: of the film, all faces of the joint together"}, f.film_area, D::area, positive);
}

void check_laws(Visitor& v, Friction& f)
{
    LawKeys keys(v, f);
    keys.allowed(!f.kind.empty(), "kind", {"calibrated"});
    keys.allowed(f.load_part > 0, "load_part", {"calibrated"});
    keys.allowed(f.viscous_part > 0, "viscous_part", {"calibrated"});
    keys.allowed(f.reference_speed > 0, "reference_speed", {"calibrated"});
    keys.allowed(f.reference_force.has_value(), "reference_force", {"calibrated"});
    keys.allowed(f.reference_stiffness.has_value(), "reference_stiffness", {"calibrated"});
    keys.needed(!f.bearing.empty(), "bearing", {"palmgren", "skf"});
    keys.needed(f.mean_diameter.has_value(), "mean_diameter", {"palmgren"});
    keys.needed(f.static_rating.has_value(), "static_rating", {"palmgren"});
    keys.allowed(f.contact_angle.has_value(), "contact_angle", {"palmgren"});
    keys.allowed(f.lubrication_factor.has_value(), "lubrication_factor", {"palmgren"});
    keys.allowed(f.axial_preload > 0, "axial_preload", {"palmgren", "skf"});
    keys.allowed(f.balls > 0, "balls", {"palmgren"});
    keys.allowed(f.ball_diameter.has_value(), "ball_diameter", {"palmgren"});
    keys.allowed(f.ring_expansion.has_value(), "ring_expansion", {"palmgren"});
    const bool angular = f.bearing == "angular_contact_ball" || f.bearing == "angular_contact_ball_pair";
    v.expect(!f.ring_expansion || (f.balls > 0 && angular && f.contact_angle.value_or(0) > 0), "ring_expansion",
             "only angular contact ball bearings of known balls change their preload with the rings' temperatures",
             "give `balls`, `ball_diameter` and `contact_angle`, or remove `ring_expansion`");
    keys.needed(f.bore.has_value(), "bore", {"skf"});
    keys.needed(f.outside_diameter.has_value(), "outside_diameter", {"skf"});
    keys.needed(f.coefficient.has_value(), "coefficient", {"pin", "guide"});
    keys.allowed(f.diameter.has_value(), "diameter", {"pin"});
    keys.allowed(f.length.has_value(), "length", {"pin"});
    keys.allowed(f.clearance.has_value(), "clearance", {"pin"});
    keys.allowed(f.film_thickness.has_value(), "film_thickness", {"guide"});
    keys.allowed(f.film_area.has_value(), "film_area", {"guide"});
    v.expect(f.viscous_part == 0 || !f.lubricant.empty(), "viscous_part", "a viscous part needs a lubricant",
             "name one with `lubricant`");
    const bool rolling = f.law == "palmgren" || f.law == "skf";
    v.expect(!rolling || !f.lubricant.empty(), "law", "a rolling bearing needs a lubricant",
             "name one with `lubricant`");
    v.expect(!(f.clearance || f.film_thickness) || !f.lubricant.empty(), f.clearance ? "clearance" : "film_thickness",
             "an oil film needs a lubricant", "name one with `lubricant`");
    v.expect(f.film_thickness.has_value() == f.film_area.has_value(), f.film_area ? "film_area" : "film_thickness",
             "a film needs both its thickness and its area", "give both");
    v.expect((f.balls > 0) == f.ball_diameter.has_value(), f.ball_diameter ? "ball_diameter" : "balls",
             "spin friction needs both `balls` and `ball_diameter`", "give both");
    v.expect(f.law != "skf" || f.bearing.empty() || f.bearing == "angular_contact_ball" ||
                 f.bearing == "cylindrical_roller",
             "bearing", fmt::format("law = \"skf\" has no constants for '{}'", f.bearing),
             "take \"angular_contact_ball\" or \"cylindrical_roller\", or law = \"palmgren\"");
    v.expect(!f.reference_stiffness || f.reference_force, "reference_stiffness",
             "without `reference_force` the heat does not follow the load", "add `reference_force`");
    v.expect(f.load_measure != "peak" || f.law != "calibrated" || f.reference_force, "load_measure",
             "without `reference_force` the heat does not follow the load", "add `reference_force`");
}

}  // namespace

void describe(Visitor& v, Friction& f)
{
    v.about(
        "A law of friction heat: the total of the whole press, shared by all joints that name the law. `calibrated` is "
        "H(T) = load_part + viscous_part * (viscosity(T) / (1 mm^2/s))^exponent at the reference speed; the others "
        "follow from sizes, oil, and the loads and speeds of the joints over the turn, so the case must say enough of "
        "its linkage for those.");
    choose(v,
           {"law",
            "`calibrated`: the coefficients are given; `palmgren`, `skf`: rolling bearings, one for each bearing of "
            "[crankshaft] or rolling element of the joint; `pin`: Coulomb and Petroff; `guide`: Coulomb and film shear",
            Need::required},
           f.law, {"calibrated", "palmgren", "skf", "pin", "guide"});
    v.text({"lubricant", "the oil whose viscosity counts"}, f.lubricant);
    choose(
        v,
        {"load_measure", "the load that counts: as it goes over the turn, averaged by the law, or its peak throughout"},
        f.load_measure, {"mean", "peak"});
    describe_calibrated(v, f);
    describe_rolling(v, f);
    describe_plain(v, f);
    v.number({"scale", "multiplies the heat"}, f.scale, non_negative);
    v.text({"source", "where the values are from"}, f.source);
    check_laws(v, f);
}

}  // namespace deadpoint::casefile
