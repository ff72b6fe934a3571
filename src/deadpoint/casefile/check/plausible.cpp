#include "deadpoint/casefile/check/plausible.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/core/units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <tuple>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

constexpr double degree = std::numbers::pi / 180;

/// A value with six digits at most in the unit that the case file prefers.
std::string shown(double value, D dimension)
{
    const std::string unit =
        dimension == D::time && std::abs(value) >= hour ? "h" : std::string(dimension_info(dimension).preferred);
    const double one = parse_quantity("1 " + unit, dimension);
    const double zero = dimension == D::temperature ? parse_quantity("0 " + unit, dimension) : 0;
    return fmt::format("{:.6g} {}", (value - zero) / (one - zero), unit);
}

/// Values between which something lies in practice [SI].
struct Bounds {
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    std::string_view whose;  ///< "solids have"
};

class Values : private Findings {
public:
    explicit Values(const Case& c) : Findings(c) {}

    std::vector<Finding> run()
    {
        for (const auto& [name, material] : c_.materials)
            check_material("materials." + name, material);
        check_temperatures();
        check_drawings();
        for (const auto& [name, joint] : c_.joints)
            check_joint("joints." + name, joint);
        for (const auto& [name, bond] : c_.bonds)
            check_conductance("bonds." + name + ".conductance", bond.conductance);
        for (const auto& [name, surface] : c_.surfaces)
            if (surface.film)
                check_film("surfaces." + name + ".film", *surface.film);
        check_lubricants();
        for (const auto& [name, friction] : c_.friction)
            check_friction("friction." + name, friction);
        check_operation();
        check_process();
        if (c_.chain)
            check_chain(*c_.chain);
        check_output();
        return take();
    }

private:
    void expect(const std::string& path, double value, D dimension, const Bounds& bounds, std::string_view help)
    {
        if (value >= bounds.low && value <= bounds.high)
            return;
        const auto range = std::isinf(bounds.high) ? fmt::format("at least {}", shown(bounds.low, dimension))
                           : bounds.low <= 0 && value > bounds.high
                               ? fmt::format("at most {}", shown(bounds.high, dimension))
                               : fmt::format("{} to {}", shown(bounds.low, dimension), shown(bounds.high, dimension));
        warn("implausible", path, fmt::format("{}, but {} {}", shown(value, dimension), bounds.whose, range),
             std::string(help));
    }
    void expect(const std::string& path, const Table& table, D dimension, const Bounds& bounds, std::string_view help)
    {
        for (const double value : table.y)
            if (value < bounds.low || value > bounds.high)
                return expect(path, value, dimension, bounds, help);
    }
    /// A value that has a default of zero, or its table.
    void expect_either(const std::string& path, double value, const Table& table, D dimension, const Bounds& bounds)
    {
        constexpr std::string_view help = "check the decade and the unit";
        if (!table.y.empty())
            expect(path, table, dimension, bounds, help);
        else if (value != 0)
            expect(path, value, dimension, bounds, help);
    }

    // Solids of machines lie between foam or timber and tungsten; metals, concrete and ceramics are stiff.
    void check_material(const std::string& path, const Material& m)
    {
        const bool stiff = m.youngs_modulus > 3e10;
        expect_either(path + ".density", m.density, {}, D::density, {100, 23000, "solids have"});
        expect_either(path + ".conductivity", m.conductivity, m.conductivity_table, D::conductivity,
                      {0.02, 500, "solids have"});
        expect_either(path + ".specific_heat", m.specific_heat, m.specific_heat_table, D::specific_heat,
                      {100, 5000, "solids have"});
        expect_either(path + ".expansion", m.expansion, m.expansion_table, D::expansion,
                      stiff ? Bounds{-1e-6, 4e-5, "metals and other stiff solids have"}
                            : Bounds{-1e-6, 3e-4, "solids have"});
        if (m.density > 4000)
            expect_either(path + ".youngs_modulus", m.youngs_modulus, {}, D::pressure, {1e10, 1e12, "metals have"});
        if (m.expansion_table.y.empty() && m.expansion > 0)
            expect(path + ".expansion", m.expansion, D::expansion,
                   {2e-7, std::numeric_limits<double>::infinity(), "even invar has"}, "check the decade and the unit");
    }

    // What a drawing is meshed with, and whether a solid is there twice.
    void check_drawings()
    {
        std::map<std::tuple<std::string, std::string, Vec3>, std::string> first;
        for (const auto& [name, part] : c_.parts) {
            if (part.step.empty())
                continue;
            const auto path = "parts." + name;
            const double size = part.size.value_or(c_.numerics.size);
            const auto length = [](double value) { return shown(value, D::length); };
            if (part.omit && *part.omit > 2 * size)
                warn("implausible", path + ".omit",
                     fmt::format("holes and roundings up to {} are left out, but its cells have {}", length(*part.omit),
                                 length(size)),
                     "check the unit; some tenths of `size` are enough");
            if (part.smallest_cell && *part.smallest_cell > size)
                warn("unused", path + ".smallest_cell",
                     fmt::format("{} is larger than the cells of the part, {}", length(*part.smallest_cell),
                                 length(size)),
                     "state less than `size`, or leave it out");
            const auto [known, is_new] = first.try_emplace({part.step, part.solid, part.position}, name);
            if (!is_new)
                warn("twice", path + ".solid",
                     fmt::format("parts '{}' and '{}' are the same solid at the same place", known->second, name),
                     "name another solid, state `position`, or remove one of the parts");
        }
    }

    void expect_temperature(const std::string& path, double value, const Bounds& bounds)
    {
        expect(path, value, D::temperature, bounds, "20 degC are 293.15 K and 68 degF: check the unit");
    }
    void expect_course(const std::string& path, const Course& course, const Bounds& bounds)
    {
        if (course.table) {
            const auto [low, high] = std::ranges::minmax(course.table->y);
            expect_temperature(path, low < bounds.low ? low : high, bounds);
        } else {
            expect_temperature(path, course.daily ? course.daily->mean : course.constant, bounds);
        }
    }

    // Presses stand in halls; parts may start warm, oil is at most as warm as it bears.
    void check_temperatures()
    {
        constexpr Bounds hall{zero_celsius - 40, zero_celsius + 60, "halls have"};
        constexpr Bounds start{zero_celsius - 40, zero_celsius + 200, "parts of presses have"};
        constexpr Bounds oil{zero_celsius - 40, zero_celsius + 150, "oil in presses has"};
        expect_temperature("machine.initial_temperature", c_.machine.initial_temperature, hall);
        expect_temperature("machine.ambient", c_.machine.ambient, hall);
        for (const auto& [name, body] : c_.bodies)
            if (body.initial_temperature)
                expect_temperature("bodies." + name + ".initial_temperature", *body.initial_temperature, start);
        for (const auto& [name, part] : c_.parts)
            if (part.initial_temperature)
                expect_temperature("parts." + name + ".initial_temperature", *part.initial_temperature, start);
        for (const auto& [name, circuit] : c_.oil_circuits)
            if (circuit.inlet_temperature)
                expect_temperature("oil_circuits." + name + ".inlet_temperature", *circuit.inlet_temperature, oil);
        for (std::size_t i = 0; i < c_.operation.size(); ++i)
            if (c_.operation[i].ambient)
                expect_course(fmt::format("operation.{}.ambient", i), *c_.operation[i].ambient, hall);
    }

    void check_joint(const std::string& path, const Joint& joint)
    {
        expect_temperature(path + ".oil_temperature", joint.oil_temperature,
                           {zero_celsius - 40, zero_celsius + 150, "oil in presses has"});
        if (joint.clearance)
            check_clearance(path + ".clearance", *joint.clearance, largest_diameter(joint));
        for (std::size_t i = 0; i < joint.interfaces.size(); ++i)
            check_conductance(fmt::format("{}.interfaces.{}.conductance", path, i), joint.interfaces[i].conductance);
    }
    static double largest_diameter(const Joint& joint)
    {
        double diameter = 0;
        for (const auto& interface : joint.interfaces)
            diameter = std::max(diameter, interface.diameter.value_or(0));
        for (const auto& element : joint.elements)
            diameter = std::max(diameter, element.diameter);
        return diameter;
    }
    // Bearings and guides have clearances of one or two thousandths of their size, and of a few micrometres at least.
    void check_clearance(const std::string& path, double clearance, double diameter)
    {
        const double high = diameter > 0 ? std::min(1e-3, 0.01 * diameter) : 1e-3;
        expect(path, clearance, D::length, {1e-6, high, "bearings and guides of this size have a clearance of"},
               "a running clearance is about a thousandth of the diameter: check the unit, um or mm");
    }
    // From surfaces soldered together to plates a millimetre of air apart, 0.04 m2 K/W.
    void check_conductance(const std::string& path, const Conductance& conductance)
    {
        constexpr std::string_view help = "check the decade and the unit; 0 stands for no conduction";
        if (const auto* known = std::get_if<ContactResistance>(&conductance); known != nullptr && known->value != 0)
            expect(path + ".resistance", known->value, D::thermal_resistance, {1e-8, 0.2, "contacts have"}, help);
        if (const auto* whole = std::get_if<WholeConductance>(&conductance); whole != nullptr && whole->value != 0)
            expect(path + ".value", whole->value, D::heat_transfer_coefficient, {5, 1e8, "contacts have"}, help);
        if (const auto* films = std::get_if<SideFilms>(&conductance))
            for (const auto& [key, value] : {std::pair{"a", films->a}, std::pair{"b", films->b}})
                if (value != 0)
                    expect(fmt::format("{}.side_{}", path, key), value, D::heat_transfer_coefficient,
                           {1, 1e8, "sides of contacts have"}, help);
        if (const auto* rough = std::get_if<RoughContact>(&conductance))
            check_rough(path, *rough);
        if (const auto* rolling = std::get_if<RollingElements>(&conductance))
            check_elements(path, *rolling);
    }
    // From lapped to flame-cut faces; from lead to hard metal; bolts press with some MPa.
    void check_rough(const std::string& path, const RoughContact& rough)
    {
        expect(path + ".roughness", rough.roughness, D::length, {1e-8, 2e-4, "machined faces have"},
               "check the unit, um or mm");
        expect(path + ".hardness", rough.surfaces.hardness, D::pressure, {2e7, 3e10, "metals have"},
               "check the unit: HB times 9.81 MPa");
        if (rough.surfaces.pressure)
            expect(path + ".pressure", *rough.surfaces.pressure, D::pressure, {1e3, 1e9, "bolted faces bear"},
                   "check the unit, Pa or MPa");
    }
    // Elements that carry load stand side by side on their pitch circle.
    void check_elements(const std::string& path, const RollingElements& rolling)
    {
        const double around = std::numbers::pi * rolling.pitch_diameter.value_or(0);
        if (around > 0 && rolling.loaded_elements * rolling.element_diameter > around)
            warn("implausible", path + ".element_diameter",
                 fmt::format("{:.0f} loaded elements of {} do not fit around a pitch circle of {}",
                             rolling.loaded_elements, shown(rolling.element_diameter, D::length),
                             shown(*rolling.pitch_diameter, D::length)),
                 "check `element_diameter`, `loaded_elements` and `pitch_diameter`");
    }

    // Air at rest takes 2 to 10 W/m2/K, blown air some hundred; water in a cooled plate some thousand.
    void check_film(const std::string& path, const Film& film)
    {
        if (film.ambient)
            expect_course(path + ".ambient", *film.ambient, {zero_celsius - 40, zero_celsius + 150, "media have"});
        const auto* known = std::get_if<FilmCoefficient>(&film.law);
        if (known != nullptr && known->value.value_or(0) != 0)
            expect(path + ".coefficient", *known->value, D::heat_transfer_coefficient,
                   {0.1, 2e4, "surfaces in air have 2 to 200 W/m^2/K, in coolants"}, "check the decade and the unit");
        if (known != nullptr && known->value.value_or(0) > 1000 && *known->value <= 2e4 && film.emissivity > 0)
            warn("implausible", path + ".coefficient",
                 fmt::format("{} to a coolant, but the surface also radiates",
                             shown(*known->value, D::heat_transfer_coefficient)),
                 "in air a surface has 2 to 200 W/m^2/K: check the unit, or remove `emissivity`");
    }

    // Oils for presses have 1 to 1e5 mm2/s between hot and cold.
    void check_lubricants()
    {
        for (const auto& [name, lubricant] : c_.lubricants) {
            const std::string path = "lubricants." + name;
            expect(path + ".viscosity", lubricant.viscosity, D::kinematic_viscosity, {1e-7, 0.3, "oils have"},
                   "the unit is mm^2/s, the same as cSt");
            if (lubricant.density != 0)
                expect(path + ".density", lubricant.density, D::density, {500, 2000, "oils have"},
                       "an oil has about 870 kg/m^3");
        }
    }

    void check_friction(const std::string& path, const Friction& friction)
    {
        constexpr std::string_view length = "check the unit, um or mm";
        constexpr std::string_view coefficient = "boundary-lubricated metals have 0.05 to 0.2, dry ones up to 0.8";
        constexpr Bounds film{1e-7, 1e-3, "oil films have"};
        const auto check_coefficient = [&](double value) {
            if (value > 1)
                warn("implausible", path + ".coefficient",
                     fmt::format("a coefficient of friction of {:.4g} is above 1", value), std::string(coefficient));
        };
        if (const auto* bearing = std::get_if<PalmgrenFriction>(&friction.law))
            check_rating(path + ".static_rating", bearing->static_rating, bearing->mean_diameter);
        if (const auto* pin = std::get_if<PinFriction>(&friction.law)) {
            check_coefficient(pin->coefficient);
            if (pin->clearance)
                expect(path + ".clearance", *pin->clearance, D::length, film, length);
        }
        if (const auto* guide = std::get_if<GuideFriction>(&friction.law)) {
            check_coefficient(guide->coefficient);
            if (guide->film_thickness)
                expect(path + ".film_thickness", *guide->film_thickness, D::length, film, length);
        }
    }

    // C0 / dm^2 of catalogues lies between 1 MPa (thin section) and 40 MPa (full complement of rollers).
    void check_rating(const std::string& path, double rating, double diameter)
    {
        if (rating > 0 && diameter > 0)
            expect(path, rating, D::force,
                   {2e5 * diameter * diameter, 2e8 * diameter * diameter, "bearings of this diameter have"},
                   "check the unit of C0, N or kN, and `mean_diameter`");
    }

    void check_operation()
    {
        for (std::size_t i = 0; i < c_.operation.size(); ++i)
            check_segment(fmt::format("operation.{}", i), c_.operation[i]);
        const double end = length_of_run();
        // The shortest warm-up takes minutes, the longest campaign weeks.
        if (!c_.parts.empty() && end > 0)
            expect("operation.0.duration", end, D::time, {1, 100 * 24 * hour, "runs of presses last"},
                   "check the unit: s, min, h or d");
    }
    // Mechanical presses run at up to 2500 strokes a minute and press with up to 165 MN.
    void check_segment(const std::string& path, const Segment& segment)
    {
        expect(path + ".speed", segment.speed, D::angular_velocity, {0, 4000 / rpm, "cranks of presses turn with"},
               "check the unit: rpm or rad/s");
        expect(path + ".force", segment.force, D::force, {0, 2e8, "the largest presses have"}, "check the unit");
        if (segment.speed == 0 && segment.force > 0)
            warn("unused", path + ".force",
                 "the press stands still in this segment: its process force does no work and loads nothing",
                 "state the speed, or remove the force");
        if (segment.speed > 0)
            check_extrapolation(path + ".speed", segment.speed);
    }
    // Friction fitted at one speed tells little about another decade.
    void check_extrapolation(const std::string& path, double speed)
    {
        constexpr double far = 5;
        std::vector<std::string> laws;
        double reference = 0;
        for (const auto& [name, friction] : c_.friction) {
            const auto* fitted = std::get_if<CalibratedFriction>(&friction.law);
            if (fitted == nullptr || fitted->reference_speed <= 0 ||
                (speed < far * fitted->reference_speed && far * speed > fitted->reference_speed))
                continue;
            laws.push_back(name);
            reference = fitted->reference_speed;
        }
        if (!laws.empty())
            warn("implausible", path,
                 fmt::format("{:.6g} rpm is {:.3g} times the speed at which friction.{} was fitted, {:.6g} rpm: the "
                             "heat of {} is extrapolated",
                             speed * rpm, speed / reference, laws.back(), reference * rpm, fmt::join(laws, ", ")),
                 "check the unit (60 rpm are 6.28 rad/s), or state the heat at this speed");
    }
    [[nodiscard]] double length_of_run() const
    {
        double end = 0;
        for (const auto& segment : c_.operation)
            end += segment.duration;
        return end;
    }

    // A mechanical press works over tens of degrees of its crank; 0.5 rad taken for degrees are half a degree.
    void check_process()
    {
        if (!c_.process_force)
            return;
        const auto& process = *c_.process_force;
        if (process.from && process.to && std::abs(*process.to - *process.from) < 2 * degree)
            warn("implausible", "process_force.to",
                 fmt::format("the process force acts over {:.3g} deg of the crank only",
                             (*process.to - *process.from) / degree),
                 "check the unit: deg or rad");
        for (const auto& [key, angle] : {std::pair{"from", process.from}, std::pair{"to", process.to}})
            check_angle(fmt::format("process_force.{}", key), angle);
        expect("process_force.stiffness", process.stiffness, D::stiffness, {1e6, 1e12, "presses with their die have"},
               "a press has about 1 MN/mm, that is 1e9 N/m");
    }
    void check_angle(const std::string& path, const std::optional<double>& angle)
    {
        if (angle && std::abs(*angle) > 4 * std::numbers::pi)
            warn("implausible", path, fmt::format("{:.4g} deg are more than two turns of the crank", *angle / degree),
                 "check the unit: deg or rad");
    }

    void check_chain(const Chain& chain)
    {
        if (chain.press_stiffness)
            expect("chain.press_stiffness", *chain.press_stiffness, D::stiffness, {1e7, 1e12, "presses have"},
                   "a press has about 1 MN/mm, that is 1e9 N/m");
        if (chain.drift_rate_limit > 1e-3 / hour)
            warn("implausible", "chain.drift_rate_limit",
                 fmt::format("{:.4g} um/h: no press drifts that fast, and each counts as warm from the start",
                             chain.drift_rate_limit * 1e6 * hour),
                 "state it per hour, like \"1 um/h\"");
    }
    void check_output()
    {
        const double end = length_of_run();
        if (c_.parts.empty() || end <= 0)
            return;
        for (const double time : c_.output.field_times)
            if (time > end * (1 + 1e-9)) {
                warn("unused", "output.field_times",
                     fmt::format("{} is after the end of the run, {}", shown(time, D::time), shown(end, D::time)),
                     "name times within the run, or make it longer; its end is always written");
                break;
            }
        if (c_.output.history_interval > end)
            warn("unused", "output.history_interval",
                 fmt::format("{}, longer than the run of {}: history.csv gets its start and end only",
                             shown(c_.output.history_interval, D::time), shown(end, D::time)),
                 "state an interval like \"60 s\"");
    }
};

}  // namespace

std::vector<Finding> check_values(const Case& c) { return Values(c).run(); }

}  // namespace deadpoint::casefile
