#include "deadpoint/casefile/describe/choose.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

/// Rules between a law and its parameters.
class LawRules {
public:
    LawRules(Visitor& v, const std::string& law) : v_(v), law_(law) {}

    /// A parameter of the laws listed: needed by all of them, or only allowed there.
    void needed(bool given, std::string_view key, std::initializer_list<std::string_view> laws)
    {
        allowed(given, key, laws);
        const bool missing = named(laws) && !given;
        v_.expect(!missing, "law", fmt::format("'{}' is missing for law = \"{}\"", key, law_),
                  fmt::format("add `{}`", key));
    }
    void allowed(bool given, std::string_view key, std::initializer_list<std::string_view> laws)
    {
        v_.expect(!given || named(laws), key,
                  law_.empty() ? fmt::format("'{}' belongs to a law, and none is named", key)
                               : fmt::format("law = \"{}\" does not use '{}'", law_, key),
                  law_.empty() ? "add `law`, or remove the key" : "remove it, or take another law");
    }

private:
    [[nodiscard]] bool named(std::initializer_list<std::string_view> laws) const
    {
        return std::ranges::find(laws, law_) != laws.end();
    }

    Visitor& v_;
    const std::string& law_;
};

constexpr std::string_view fractal = "fractal";
constexpr std::string_view rough = "cooper_mikic_yovanovich";
constexpr std::string_view oil_film = "oil_film";
constexpr std::string_view rolling = "rolling_elements";

void describe_surfaces_in_contact(Visitor& v, Conductance& c)
{
    v.quantity({"pressure", "of fractal and rough contact; else the joint's mean load over its area"}, c.pressure,
               D::pressure, non_negative);
    v.quantity({"hardness", "of the softer side at its surface"}, c.hardness, D::pressure, positive);
    v.quantity({"fluid_conductivity", "of what fills the gaps; oil about 0.14 W/m/K, air 0.026 W/m/K"},
               c.fluid_conductivity, D::conductivity, positive);
    v.quantity({"gas_jump", "temperature jump of a gas at both walls, as an additional gap; none for oil"}, c.gas_jump,
               D::length, non_negative);
    v.quantity({"fractal_dimension", "D of a profile"}, c.fractal_dimension, D::none, {1, 2, true});
    v.quantity({"fractal_roughness", "G, scaling length of the profile"}, c.fractal_roughness, D::length, positive);
    v.quantity({"sample_length", "side of the fractal domain"}, c.sample_length, D::length, positive);
    v.quantity({"separation", "of the mean planes before loading"}, c.separation, D::length, positive);
    v.quantity({"roughness", "root mean square height of both sides combined"}, c.roughness, D::length, positive);
    v.quantity({"slope", "mean absolute slope of both sides combined; else estimated from the roughness"}, c.slope,
               D::none, positive);
}

void describe_films_and_elements(Visitor& v, Conductance& c)
{
    v.quantity({"thickness", "of an oil film, or of the lubricant in the contacts of rolling elements"}, c.thickness,
               D::length, positive);
    v.quantity({"clearance", "radial, of a journal in its bush"}, c.clearance, D::length, positive);
    v.quantity({"eccentricity", "of the journal, as a share of the clearance"}, c.eccentricity, D::none,
               {0, 0.999, false});
    v.quantity({"loaded_elements", "number of balls or rollers that carry"}, c.loaded_elements, D::none,
               {1, 100000, false});
    v.quantity({"element_diameter", "of a ball or roller"}, c.element_diameter, D::length, positive);
    v.quantity({"pitch_diameter", "of the bearing; without it its elements count as standing still"}, c.pitch_diameter,
               D::length, positive);
    v.vector({"inner_spot", "semi-axes of the contact at the inner ring, across and along the rolling direction"},
             c.inner_spot, D::length);
    v.vector({"outer_spot", "the same at the outer ring"}, c.outer_spot, D::length);
    v.text({"material", "of rings and elements; else that of side a"}, c.material);
}

void require_parameters(Visitor& v, const Conductance& c)
{
    LawRules rules(v, c.law);
    rules.allowed(c.pressure.has_value(), "pressure", {fractal, rough});
    rules.needed(c.hardness.has_value(), "hardness", {fractal, rough});
    if (c.law == rolling)
        v.expect(c.fluid_conductivity.has_value() == c.thickness.has_value(),
                 c.thickness ? "thickness" : "fluid_conductivity",
                 "a lubricant in the contacts needs its thickness and its conductivity",
                 "give both `thickness` and `fluid_conductivity`, or neither");
    else
        rules.needed(c.fluid_conductivity.has_value(), "fluid_conductivity", {fractal, rough, oil_film});
    rules.allowed(c.gas_jump.has_value(), "gas_jump", {fractal, rough, oil_film});
    rules.needed(c.fractal_dimension.has_value(), "fractal_dimension", {fractal});
    rules.needed(c.fractal_roughness.has_value(), "fractal_roughness", {fractal});
    rules.needed(c.sample_length.has_value(), "sample_length", {fractal});
    rules.needed(c.separation.has_value(), "separation", {fractal});
    rules.needed(c.roughness.has_value(), "roughness", {rough});
    rules.allowed(c.slope.has_value(), "slope", {rough});
    rules.allowed(c.thickness.has_value(), "thickness", {oil_film, rolling});
    rules.allowed(c.clearance.has_value(), "clearance", {oil_film});
    rules.allowed(c.eccentricity.has_value(), "eccentricity", {oil_film});
    if (c.law == oil_film) {
        v.expect(c.thickness.has_value() != c.clearance.has_value(), "law",
                 "an oil film needs either its `thickness` or the `clearance` of a journal", "give one of the two");
        v.expect(!c.eccentricity || c.clearance, "eccentricity", "only a journal with a `clearance` is eccentric",
                 "add `clearance`, or remove `eccentricity`");
    }
    rules.needed(c.loaded_elements.has_value(), "loaded_elements", {rolling});
    v.expect(!c.loaded_elements || *c.loaded_elements == std::floor(*c.loaded_elements), "loaded_elements",
             "the number of elements is not a whole one", "round it");
    rules.needed(c.element_diameter.has_value(), "element_diameter", {rolling});
    rules.allowed(c.pitch_diameter.has_value(), "pitch_diameter", {rolling});
    rules.needed(c.inner_spot.has_value(), "inner_spot", {rolling});
    rules.needed(c.outer_spot.has_value(), "outer_spot", {rolling});
    rules.allowed(!c.material.empty(), "material", {rolling});
}

}  // namespace

void describe(Visitor& v, Conductance& c)
{
    v.about("The resistance of the whole contact, a film to each side, or a `law` that computes it. Laws take "
            "conductivity and elasticity from the materials of the two parts; their result is shared evenly by both "
            "sides.");
    v.quantity({"resistance", "of the whole contact, shared evenly by both sides"}, c.resistance, D::thermal_resistance,
               non_negative);
    v.quantity({"side_a", "film to side a"}, c.side_a, D::heat_transfer_coefficient, non_negative);
    v.quantity({"side_b", "film to side b"}, c.side_b, D::heat_transfer_coefficient, non_negative);
    choose(v,
           {"law", "`fractal`: two fractal rough surfaces; `cooper_mikic_yovanovich`: two rough surfaces by roughness "
                   "and slope; `oil_film`: by `thickness`, or by `clearance` and `eccentricity` of a journal; "
                   "`rolling_elements`: ring to ring through balls or rollers"},
           c.law, {fractal, rough, oil_film, rolling});
    describe_surfaces_in_contact(v, c);
    describe_films_and_elements(v, c);
    const bool whole = c.resistance > 0;
    const bool sides = c.side_a > 0 || c.side_b > 0;
    const bool law = !c.law.empty();
    v.expect(whole || sides || law, "", "the conductance is not given",
             "give `resistance`, both `side_a` and `side_b`, or a `law`");
    v.expect(!(whole && sides), "resistance", "the conductance is given twice",
             "keep either `resistance` or the two films");
    v.expect(!(law && (whole || sides)), "law", "the conductance is given twice",
             "keep either the law or the known value");
    v.expect(!sides || (c.side_a > 0 && c.side_b > 0), c.side_a > 0 ? "side_a" : "side_b",
             "a film is given to one side only", "give both `side_a` and `side_b`");
    require_parameters(v, c);
}

void describe(Visitor& v, Film& f)
{
    v.about("A `coefficient`, or a `law` of convection in air whose coefficient follows the temperatures of surface "
            "and ambient. A length that is not given is taken from the geometry where that is clear.");
    v.quantity({"coefficient", "heat transfer coefficient"}, f.coefficient, D::heat_transfer_coefficient, non_negative);
    choose(v,
           {"law",
            "`vertical`: a wall; `horizontal_up`, `horizontal_down`: a plate by the side it faces; `cylinder`: a "
            "horizontal one at rest; `rotating_cylinder`, `rotating_disk`: turns with the crank; `moving`: by the "
            "body's root mean square speed; `enclosed`: around air that exchanges little with the room; `paper`: the "
            "constants of Zheng et al. (2018), `paper_...`: its correlations with its Table 7 as printed, errors "
            "included"},
           f.law,
           {"vertical", "horizontal_up", "horizontal_down", "cylinder", "rotating_cylinder", "rotating_disk", "moving",
            "enclosed", "paper", "paper_vertical", "paper_horizontal_up", "paper_horizontal_down",
            "paper_rotating_cylinder"});
    v.quantity({"length",
                "height of a wall; area over perimeter of a horizontal plate; along its motion of what moves; "
                "else from the geometry"},
               f.length, D::length, positive);
    v.quantity({"diameter", "of a cylinder or disk; else from the geometry"}, f.diameter, D::length, positive);
    v.quantity({"speed", "root mean square, of what moves, while the press runs; else from the loads"}, f.speed,
               D::velocity, non_negative);
    v.quantity({"exchange", "of enclosed air with the room, by openings and walls; for the whole press"}, f.exchange,
               D::thermal_conductance, non_negative);
    choose(v, {"constant", "of the paper: 5 W/m2/K for the frame, 9.7 W/m2/K for crankshaft and linkage"}, f.constant,
           {"frame", "crankshaft"});
    v.number(
        {"emissivity",
         "for radiation to surroundings at ambient temperature; of a surface of an enclosure, to its other surfaces"},
        f.emissivity, fraction);
    v.course({"ambient", "temperature of the air there; else that of the operation"}, f.ambient, D::temperature,
             positive);
    v.expect(f.coefficient || !f.law.empty(), "", "the film is not given", "give its `coefficient`, or a `law`");
    v.expect(!(f.coefficient && !f.law.empty()), "law", "the film is given twice",
             "keep either `coefficient` or `law`");
    LawRules rules(v, f.law);
    rules.allowed(f.length.has_value(), "length",
                  {"vertical", "horizontal_up", "horizontal_down", "moving", "enclosed", "paper_vertical",
                   "paper_horizontal_up", "paper_horizontal_down"});
    rules.allowed(f.diameter.has_value(), "diameter",
                  {"cylinder", "rotating_cylinder", "rotating_disk", "paper_rotating_cylinder"});
    rules.allowed(f.speed.has_value(), "speed", {"moving"});
    rules.needed(f.exchange.has_value(), "exchange", {"enclosed"});
    rules.needed(!f.constant.empty(), "constant", {"paper"});
    v.expect(f.law != "enclosed" || f.emissivity == 0, "emissivity", "enclosed surfaces see each other, not the room",
             "remove `emissivity`, or name the surfaces in [enclosures]");
}

}  // namespace deadpoint::casefile
