#include "deadpoint/casefile/describe/choose.hpp"
#include "deadpoint/casefile/describe/laws.hpp"

#include <fmt/format.h>
#include <string>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

const LawTable<FrictionLaw>& friction_laws()
{
    static const LawTable<FrictionLaw> table{{"calibrated", CalibratedFriction{}},
                                             {"palmgren", PalmgrenFriction{}},
                                             {"skf", SkfFriction{}},
                                             {"pin", PinFriction{}},
                                             {"guide", GuideFriction{}}};
    return table;
}

// Keys of more than one law.

void describe_bearing(Visitor& v, BearingType& type)
{
    choose(v,
           {"bearing", "`palmgren`, `skf`: type of each bearing (`skf` knows single angular contact and cylindrical)",
            of_law},
           type);
}

void describe_axial_preload(Visitor& v, double& preload)
{
    v.quantity({"axial_preload", "`palmgren`, `skf`: axial preload of each bearing"}, preload, D::force, non_negative);
}

void describe_coefficient(Visitor& v, double& coefficient)
{
    v.quantity({"coefficient", "`pin`, `guide`: coefficient of Coulomb friction", of_law}, coefficient, D::none,
               non_negative);
}

void describe_spin(Visitor& v, PalmgrenFriction& f)
{
    v.integer({"balls", "`palmgren`: number of balls in a row; with it spin friction is added"}, f.balls,
              {0, 1000, false});
    v.quantity({"ball_diameter", "`palmgren`: diameter of a ball, for spin friction"}, f.ball_diameter, D::length,
               positive);
    v.number({"osculation", "`palmgren`: groove radius divided by ball diameter, for spin friction"}, f.osculation,
             {0.5, 1, true});
    v.number({"spin_friction", "`palmgren`: coefficient of sliding between ball and groove"}, f.spin_friction,
             non_negative);
    v.expect((f.balls > 0) == f.ball_diameter.has_value(), f.ball_diameter ? "ball_diameter" : "balls",
             "spin friction needs both `balls` and `ball_diameter`", "give both");
}

void describe_rings(Visitor& v, PalmgrenFriction& f)
{
    v.quantity(
        {"ring_expansion",
         "`palmgren`: thermal expansion of rings and balls; with it a temperature difference between the joint's "
         "journals and seats changes the preload of its angular contact bearings, and therefore their heat"},
        f.ring_expansion, D::expansion, positive);
    choose(v, {"arrangement", "arrangement of a pair with `ring_expansion`"}, f.arrangement);
    v.quantity({"row_distance", "distance between the ball centres of the two rows of a pair, for `ring_expansion`"},
               f.row_distance, D::length, non_negative);
    const bool angular =
        f.bearing == BearingType::angular_contact_ball || f.bearing == BearingType::angular_contact_ball_pair;
    v.expect(
        !f.ring_expansion || (f.balls > 0 && angular && f.contact_angle.value_or(0) > 0), "ring_expansion",
        "only angular contact ball bearings with stated balls change their preload with the temperatures of the rings",
        "give `balls`, `ball_diameter` and `contact_angle`, or remove `ring_expansion`");
}

constexpr std::string_view name_lubricant =
    "add lubricant = \"oil\", with a section [lubricants.oil] such as library = \"ISO-VG-68\"";

// What a law asks of the keys that all laws share.

void check_shared(Visitor& v, const Friction& f)
{
    const auto* calibrated = std::get_if<CalibratedFriction>(&f.law);
    const auto* pin = std::get_if<PinFriction>(&f.law);
    const auto* guide = std::get_if<GuideFriction>(&f.law);
    const bool oiled = !f.lubricant.empty();
    v.expect(oiled || calibrated == nullptr || calibrated->viscous_part == 0, "viscous_part",
             "a viscous part needs a lubricant", name_lubricant);
    v.expect(oiled || calibrated != nullptr || pin != nullptr || guide != nullptr, "law",
             "a rolling bearing needs a lubricant", name_lubricant);
    v.expect(oiled || pin == nullptr || !pin->clearance, "clearance", "an oil film needs a lubricant", name_lubricant);
    v.expect(oiled || guide == nullptr || !guide->film_thickness, "film_thickness", "an oil film needs a lubricant",
             name_lubricant);
    v.expect(f.load_measure != LoadMeasure::peak || calibrated == nullptr || calibrated->reference_force,
             "load_measure", "without `reference_force` the heat does not follow the load", "add `reference_force`");
}

}  // namespace

std::string_view law_name(const Friction& friction) { return name_in(friction_laws(), friction.law); }

void describe(Visitor& v, CalibratedFriction& f)
{
    choose(v, {"kind", "`calibrated` only: how the heat changes with speed and load", required}, f.kind);
    v.quantity({"load_part", "heat that does not depend on the viscosity"}, f.load_part, D::power, non_negative);
    v.quantity({"viscous_part", "heat at a viscosity of 1 mm^2/s, less the load part"}, f.viscous_part, D::power,
               non_negative);
    v.number({"exponent", "exponent of the viscosity"}, f.exponent, {0, 2, false});
    v.quantity({"reference_speed", "`calibrated` only: crank speed at which the heat was determined", required},
               f.reference_speed, D::angular_velocity, positive);
    v.quantity(
        {"reference_force",
         "process force at which the load part was determined, with the flexible crankshaft if there is one; with it "
         "the load part is proportional to the duty of the joints, without it the load part depends on the speed only"},
        f.reference_force, D::force, non_negative);
    v.quantity({"reference_stiffness",
                "stiffness of each crankshaft bearing at which the load part was determined; else that of the case"},
               f.reference_stiffness, D::stiffness, positive);
    v.expect(!f.reference_stiffness || f.reference_force, "reference_stiffness",
             "without `reference_force` the heat does not follow the load", "add `reference_force`");
}

void describe(Visitor& v, PalmgrenFriction& f)
{
    describe_bearing(v, f.bearing);
    choose(v, {"oil_supply", "`palmgren`: type of oil supply"}, f.oil_supply);
    v.quantity({"mean_diameter", "`palmgren`: mean of bore and outside diameter", of_law}, f.mean_diameter, D::length,
               positive);
    v.quantity({"static_rating", "`palmgren`: static load rating C0", of_law}, f.static_rating, D::force, positive);
    v.quantity({"contact_angle", "`palmgren`: contact angle of balls or rollers"}, f.contact_angle, D::angle,
               non_negative);
    v.quantity({"lubrication_factor", "`palmgren`: f0; else by type and oil supply"}, f.lubrication_factor, D::none,
               positive);
    describe_axial_preload(v, f.axial_preload);
    describe_spin(v, f);
    describe_rings(v, f);
}

void describe(Visitor& v, SkfFriction& f)
{
    describe_bearing(v, f.bearing);
    v.quantity({"bore", "`skf`: bore of the bearing", of_law}, f.bore, D::length, positive);
    v.quantity({"outside_diameter", "`skf`: outside diameter of the bearing", of_law}, f.outside_diameter, D::length,
               positive);
    describe_axial_preload(v, f.axial_preload);
    v.expect(f.bearing == BearingType::angular_contact_ball || f.bearing == BearingType::cylindrical_roller, "bearing",
             fmt::format("law = \"skf\" has no constants for '{}'", name_of(f.bearing)),
             "take \"angular_contact_ball\" or \"cylindrical_roller\", or law = \"palmgren\"");
}

void describe(Visitor& v, PinFriction& f)
{
    describe_coefficient(v, f.coefficient);
    v.quantity({"diameter", "`pin`: diameter; else that of the joint's elements or of its interface"}, f.diameter,
               D::length, positive);
    v.quantity({"length", "`pin`: length of the bush; else the width of the joint's elements"}, f.length, D::length,
               positive);
    v.quantity({"clearance", "`pin`: radial clearance, for the shear of the oil film; without it the law has no shear"},
               f.clearance, D::length, positive);
}

void describe(Visitor& v, GuideFriction& f)
{
    describe_coefficient(v, f.coefficient);
    v.quantity({"film_thickness", "`guide`: thickness of the oil film; without it the law has no shear"},
               f.film_thickness, D::length, positive);
    v.quantity({"film_area", "`guide`: area of the oil film, all faces of the joint together"}, f.film_area, D::area,
               positive);
    v.expect(f.film_thickness.has_value() == f.film_area.has_value(), f.film_area ? "film_area" : "film_thickness",
             "an oil film needs both its thickness and its area", "give both");
}

void describe(Visitor& v, Friction& f)
{
    v.about("A law of friction heat. It gives the total heat of the whole press, shared by all joints that name the "
            "law. `calibrated` is H(T) = load_part + viscous_part * (viscosity(T) / (1 mm^2/s))^exponent at the "
            "reference speed. The other laws compute the heat from sizes, oil, and the loads and speeds of the joints "
            "over the turn; they need a complete linkage in the case.");
    std::string law(law_name(f));
    v.choice({"law",
              "`calibrated`: the coefficients are given; `palmgren`, `skf`: rolling bearings, one for each bearing of "
              "[crankshaft] or rolling element of the joint; `pin`: Coulomb and Petroff; `guide`: Coulomb and film "
              "shear",
              required},
             law, names_in(friction_laws()));
    v.text({"lubricant", "the oil whose viscosity the law uses"}, f.lubricant);
    choose(v,
           {"load_measure", "load that the law uses: `mean` averages over the course of the load, `peak` uses the peak "
                            "during the whole turn"},
           f.load_measure);
    v.laws("law", law, laws_of(friction_laws(), f.law));
    v.number({"scale", "multiplies the heat"}, f.scale, non_negative);
    v.text({"source", "where the values are from"}, f.source);
    check_shared(v, f);
}

}  // namespace deadpoint::casefile
