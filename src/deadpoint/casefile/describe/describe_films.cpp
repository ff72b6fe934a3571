#include "deadpoint/casefile/describe/choose.hpp"
#include "deadpoint/casefile/describe/laws.hpp"

#include <cmath>
#include <optional>
#include <string>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

const LawTable<Conductance>& conductance_laws()
{
    static const LawTable<Conductance> table{{"fractal", FractalContact{}},
                                             {"cooper_mikic_yovanovich", RoughContact{}},
                                             {"oil_film", OilFilm{}},
                                             {"rolling_elements", RollingElements{}}};
    return table;
}

const LawTable<FilmLaw>& film_laws()
{
    using Facing = PlateFilm::Facing;
    using Form = RoundFilm::Form;
    static const LawTable<FilmLaw> table{{"vertical", PlateFilm{Facing::sideways, false, {}}},
                                         {"horizontal_up", PlateFilm{Facing::up, false, {}}},
                                         {"horizontal_down", PlateFilm{Facing::down, false, {}}},
                                         {"cylinder", RoundFilm{Form::cylinder, false, {}}},
                                         {"rotating_cylinder", RoundFilm{Form::rotating_cylinder, false, {}}},
                                         {"rotating_disk", RoundFilm{Form::rotating_disk, false, {}}},
                                         {"moving", MovingFilm{}},
                                         {"enclosed", EnclosedFilm{}},
                                         {"paper", PaperFilm{}},
                                         {"paper_vertical", PlateFilm{Facing::sideways, true, {}}},
                                         {"paper_horizontal_up", PlateFilm{Facing::up, true, {}}},
                                         {"paper_horizontal_down", PlateFilm{Facing::down, true, {}}},
                                         {"paper_rotating_cylinder", RoundFilm{Form::rotating_cylinder, true, {}}}};
    return table;
}

// Keys of more than one law.

template <class Value>
void describe_conductivity(Visitor& v, Value& value, Need need)
{
    v.quantity(
        {"fluid_conductivity", "conductivity of the fluid in the gaps; oil about 0.14 W/m/K, air 0.026 W/m/K", need},
        value, D::conductivity, positive);
}

void describe_gas_jump(Visitor& v, std::optional<double>& jump)
{
    v.quantity({"gas_jump", "temperature jump of a gas at both walls, as an additional gap; none for oil"}, jump,
               D::length, non_negative);
}

void describe_thickness(Visitor& v, std::optional<double>& thickness)
{
    v.quantity({"thickness", "thickness of an oil film, or of the lubricant in the contacts of rolling elements"},
               thickness, D::length, positive);
}

void describe_surfaces(Visitor& v, PressedSurfaces& s)
{
    v.quantity(
        {"pressure", "pressure of a fractal or rough contact; else the mean load of the joint divided by its area"},
        s.pressure, D::pressure, non_negative);
    v.quantity({"hardness", "hardness of the softer side at its surface", of_law}, s.hardness, D::pressure, positive);
    describe_conductivity(v, s.fluid_conductivity, of_law);
    describe_gas_jump(v, s.gas_jump);
}

void describe_length(Visitor& v, std::optional<double>& length)
{
    v.quantity({"length", "height of a wall; area divided by perimeter of a horizontal plate; length of a moving "
                          "surface along its motion; else from the geometry"},
               length, D::length, positive);
}

/// Conductances that are known.
struct Known {
    std::optional<double> value;
    double resistance = 0;
    double side_a = 0;
    double side_b = 0;
};

Known known_of(const Conductance& c)
{
    if (const auto* sides = std::get_if<SideFilms>(&c)) {
        return {{}, 0, sides->a, sides->b};
    }
    if (const auto* value = std::get_if<WholeConductance>(&c)) {
        return {value->value, 0, 0, 0};
    }
    const auto* whole = std::get_if<ContactResistance>(&c);
    return {{}, whole != nullptr ? whole->value : 0, 0, 0};
}

void check_known(Visitor& v, const Known& known, bool law)
{
    const bool whole = known.resistance > 0;
    const bool sides = known.side_a > 0 || known.side_b > 0;
    const bool value = known.value.has_value();
    v.expect(value || whole || sides || law, "", "the conductance is not given",
             "give `value`, `resistance`, both `side_a` and `side_b`, or a `law`");
    v.expect(!(value && (whole || sides || law)), "value", "the conductance is given twice",
             "keep one of `value`, `resistance`, the two sides and `law`");
    v.expect(!(whole && sides), "resistance", "the conductance is given twice",
             "keep either `resistance` or `side_a` and `side_b`");
    v.expect(!(law && (whole || sides)), "law", "the conductance is given twice",
             "keep either the law or the known value");
    v.expect(!sides || (known.side_a > 0 && known.side_b > 0), known.side_a > 0 ? "side_a" : "side_b",
             "the conductance is given for one side only", "give both `side_a` and `side_b`");
}

}  // namespace

std::string_view law_name(const Conductance& conductance) { return name_in(conductance_laws(), conductance); }

bool is_open(const Conductance& conductance)
{
    const auto* known = std::get_if<WholeConductance>(&conductance);
    return known != nullptr && known->value == 0;
}

std::string_view law_name(const Film& film) { return name_in(film_laws(), film.law); }

void describe(Visitor& v, FractalContact& c)
{
    describe_surfaces(v, c.surfaces);
    v.quantity({"fractal_dimension", "D of a profile", of_law}, c.fractal_dimension, D::none, {1, 2, true});
    v.quantity({"fractal_roughness", "G, scaling length of the profile", of_law}, c.fractal_roughness, D::length,
               positive);
    v.quantity({"sample_length", "side of the fractal domain", of_law}, c.sample_length, D::length, positive);
    v.quantity({"separation", "separation of the mean planes before loading", of_law}, c.separation, D::length,
               positive);
}

void describe(Visitor& v, RoughContact& c)
{
    describe_surfaces(v, c.surfaces);
    v.quantity({"roughness", "root mean square height of both sides combined", of_law}, c.roughness, D::length,
               positive);
    v.quantity({"slope", "mean absolute slope of both sides combined; else estimated from the roughness"}, c.slope,
               D::none, positive);
}

void describe(Visitor& v, OilFilm& f)
{
    describe_conductivity(v, f.fluid_conductivity, of_law);
    describe_gas_jump(v, f.gas_jump);
    describe_thickness(v, f.thickness);
    v.quantity({"clearance", "radial clearance of a journal in its bush"}, f.clearance, D::length, positive);
    v.quantity({"eccentricity", "eccentricity of the journal, as a share of the clearance"}, f.eccentricity, D::none,
               {0, 0.999, false});
    v.expect(f.thickness.has_value() != f.clearance.has_value(), "law",
             "an oil film needs either its `thickness` or the `clearance` of a journal", "give one of the two");
    v.expect(!f.eccentricity || f.clearance, "eccentricity", "only a journal with a `clearance` is eccentric",
             "add `clearance`, or remove `eccentricity`");
}

void describe(Visitor& v, RollingElements& e)
{
    describe_conductivity(v, e.fluid_conductivity, Need::optional);
    describe_thickness(v, e.thickness);
    v.quantity({"loaded_elements", "number of balls or rollers that carry load", of_law}, e.loaded_elements, D::none,
               {1, 100000, false});
    v.quantity({"element_diameter", "diameter of a ball or roller", of_law}, e.element_diameter, D::length, positive);
    v.quantity({"pitch_diameter", "pitch diameter of the bearing; without it the elements count as standing still"},
               e.pitch_diameter, D::length, positive);
    v.vector(
        {"inner_spot", "semi-axes of the contact at the inner ring, across and along the rolling direction", of_law},
        e.inner_spot, D::length);
    v.vector({"outer_spot", "the same at the outer ring", of_law}, e.outer_spot, D::length);
    v.text({"material", "material of rings and elements; else that of side a"}, e.material);
    v.expect(e.fluid_conductivity.has_value() == e.thickness.has_value(),
             e.thickness ? "thickness" : "fluid_conductivity",
             "a lubricant in the contacts needs its thickness and its conductivity",
             "give both `thickness` and `fluid_conductivity`, or neither");
    v.expect(e.loaded_elements == std::floor(e.loaded_elements), "loaded_elements",
             "the number of elements is not a whole one", "round it");
}

void describe(Visitor& v, Conductance& c)
{
    v.about("The contact conductance: the conductance or the resistance of the whole contact, the conductance to each "
            "side, or a `law` that computes it. Laws use conductivity and elasticity of the materials of the two "
            "parts; their result is "
            "split equally between the sides.");
    Known known = known_of(c);
    v.quantity({"value", "conductance of the whole contact, split equally between the sides; 0: no heat passes"},
               known.value, D::heat_transfer_coefficient, non_negative);
    v.quantity({"resistance", "resistance of the whole contact, split equally between the sides"}, known.resistance,
               D::thermal_resistance, non_negative);
    v.quantity({"side_a", "conductance to side a"}, known.side_a, D::heat_transfer_coefficient, non_negative);
    v.quantity({"side_b", "conductance to side b"}, known.side_b, D::heat_transfer_coefficient, non_negative);
    std::string law(law_name(c));
    v.choice({"law",
              "`fractal`: two fractal rough surfaces; `cooper_mikic_yovanovich`: two rough surfaces by roughness "
              "and slope; `oil_film`: by `thickness`, or by `clearance` and `eccentricity` of a journal; "
              "`rolling_elements`: ring to ring through balls or rollers"},
             law, names_in(conductance_laws()));
    v.laws("law", law, laws_of(conductance_laws(), c));
    check_known(v, known, !law.empty());
    if (law.empty() && known.value) {
        c = WholeConductance{*known.value};
    } else if (law.empty() && known.resistance > 0) {
        c = ContactResistance{known.resistance};
    } else if (law.empty()) {
        c = SideFilms{known.side_a, known.side_b};
    }
}

void describe(Visitor& v, SpeedGrowth& g)
{
    v.about("How a stated coefficient h changes with the speed n of the crank: h (s + (1 - s) (n / n_r)^e), with the "
            "exponent e, the reference speed n_r and the share s that stays at rest.");
    v.number({"exponent", "e; 0.5 to 0.8 for oil or air that the machine itself moves", Need::required}, g.exponent,
             {0, 3, false});
    v.quantity({"reference_speed", "n_r, the crank speed at which the coefficient holds", Need::required},
               g.reference_speed, D::angular_velocity, positive);
    v.number({"at_rest", "s, the share of the coefficient that stays while the press stands"}, g.at_rest, fraction);
}

void describe(Visitor& v, PlateFilm& f) { describe_length(v, f.length); }

void describe(Visitor& v, RoundFilm& f)
{
    v.quantity({"diameter", "diameter of a cylinder or disk; else from the geometry"}, f.diameter, D::length, positive);
}

void describe(Visitor& v, MovingFilm& f)
{
    describe_length(v, f.length);
    v.quantity({"speed", "root mean square speed of a moving surface while the press runs; else from the loads"},
               f.speed, D::velocity, non_negative);
}

void describe(Visitor& v, EnclosedFilm& f)
{
    describe_length(v, f.length);
    v.quantity({"exchange",
                "heat exchange of enclosed air with the room through openings and walls, for the whole press", of_law},
               f.exchange, D::thermal_conductance, non_negative);
}

void describe(Visitor& v, PaperFilm& f)
{
    choose(v,
           {"constant", "constant of the paper: 5 W/m2/K for the frame, 9.7 W/m2/K for crankshaft and linkage", of_law},
           f.of);
}

void describe(Visitor& v, Film& f)
{
    v.about("The convection coefficient: a constant `coefficient`, or a `law` of convection in air that depends on the "
            "temperatures of surface and ambient. Lengths that are not given follow from the geometry if it is "
            "unambiguous.");
    std::optional<double> coefficient;
    if (const auto* known = std::get_if<FilmCoefficient>(&f.law)) {
        coefficient = known->value;
    }
    v.quantity({"coefficient", "convection coefficient"}, coefficient, D::heat_transfer_coefficient, non_negative);
    std::string law(law_name(f));
    v.choice({"law",
              "`vertical`: a wall; `horizontal_up`, `horizontal_down`: a plate that faces up or down; `cylinder`: a "
              "horizontal cylinder at rest; `rotating_cylinder`, `rotating_disk`: rotates with the crank; `moving`: "
              "forced convection at the root mean square speed of the body; `enclosed`: faces air that exchanges "
              "little heat with the room; `paper`: the "
              "constants of Zheng et al. (2018), `paper_...`: its correlations with its Table 7 as printed, errors "
              "included"},
             law, names_in(film_laws()));
    v.laws("law", law, laws_of(film_laws(), f.law));
    v.table({"with_speed", "how `coefficient` changes with the speed of the crank"}, f.with_speed);
    v.number({"emissivity", "emissivity for radiation to surroundings at ambient temperature; for a surface of an "
                            "enclosure, to the other surfaces of that enclosure"},
             f.emissivity, fraction);
    v.course({"ambient", "temperature of the air at this surface; else that of the operation"}, f.ambient,
             D::temperature, positive);
    v.expect(coefficient || !law.empty(), "", "the convection coefficient is not given",
             "give its `coefficient`, or a `law`");
    v.expect(!(coefficient && !law.empty()), "law", "the convection coefficient is given twice",
             "keep either `coefficient` or `law`");
    v.expect(!f.with_speed || law.empty(), "with_speed", "only a stated `coefficient` changes by an exponent",
             "remove `with_speed`: laws of convection follow the speed by themselves");
    v.expect(law != "enclosed" || f.emissivity == 0, "emissivity", "an `enclosed` surface does not radiate to the room",
             "remove `emissivity`, or name the surfaces in [enclosures]");
    if (law.empty()) {
        f.law = FilmCoefficient{coefficient};
    }
}

}  // namespace deadpoint::casefile
