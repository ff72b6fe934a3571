
#include "deadpoint/press/problem/heat_tables.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_friction.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/laws/film.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/courses.hpp"
#include "deadpoint/surroundings/radiation.hpp"

#include <array>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

constexpr std::array<double, 3> rises{5, 10, 20};

const casefile::Segment& segment_at(const casefile::Case& input, int segment)
{
    if (segment < 0 || segment >= static_cast<int>(input.operation.size()))
        throw mistake("operation",
                      fmt::format("there is no segment {} in [[operation]]; it has {}, counted from 0", segment,
                                  input.operation.size()),
                      fmt::format("give --segment 0{}",
                                  input.operation.size() > 1 ? fmt::format(" to {}", input.operation.size() - 1) : ""));
    return input.operation[static_cast<std::size_t>(segment)];
}

JointHeat joint_heat(const casefile::Case& input, const std::string& row, const casefile::Friction& friction,
                     const HeatLaw& law, const std::vector<double>& temperatures)
{
    JointHeat result{row, std::string(casefile::law_name(friction)), friction.lubricant, {}, {}, {}};
    for (const auto& [name, joint] : input.joints)
        if (joint.friction == row)
            result.joints.push_back(name);
    for (const double temperature : temperatures) {
        const LawValue value = law(temperature);
        result.heat.push_back(value.value);
        result.in_range.push_back(value.in_range);
    }
    return result;
}

std::vector<FilmValue> film_values(const SurfaceFilm& film, double emissivity, double ambient, double crank_speed)
{
    const auto law = film.law_at(crank_speed)(ambient);
    std::vector<FilmValue> values;
    for (const double rise : rises) {
        const LawValue convection = law(ambient + rise);
        const LawValue radiation = surroundings::radiation_coefficient(emissivity, ambient + rise, ambient);
        values.push_back({film.speed_at(crank_speed), rise, convection.value, radiation.value, convection.in_range});
    }
    return values;
}

FilmTable film_table(const casefile::Case& input, const Machine& machine, const std::string& name,
                     const LoadsResult* loads, int segment, double start)
{
    const auto& given = *input.surfaces.at(name).film;
    const auto film = surface_film(given, machine, name, loads);
    const auto& operation = segment_at(input, segment);
    FilmTable table;
    table.surface = name;
    table.law = film.law;
    table.area = film.area;
    table.length = film.constant ? 0 : film.air.natural_length;
    table.ambient =
        given.ambient ? time_course(*given.ambient, 0)(start) : segment_ambient(input, operation, start)(start);
    table.at_rest = film_values(film, given.emissivity, table.ambient, 0);
    if (film.speed_at(operation.speed) > 0)
        table.running = film_values(film, given.emissivity, table.ambient, operation.speed);
    return table;
}

void warn_of_ranges(HeatTables& tables)
{
    for (const auto& c : tables.conductances)
        if (!c.in_range)
            tables.warnings.push_back(out_of_range_text(c));
    for (const auto& film : tables.films) {
        bool in_range = true;
        for (const auto* values : {&film.at_rest, &film.running})
            for (const auto& value : *values)
                in_range = in_range && value.in_range;
        if (!in_range)
            tables.warnings.push_back(fmt::format("surfaces.{}: the film law '{}' is outside its tested range at some "
                                                  "of the temperatures shown",
                                                  film.surface, film.law));
    }
}

}  // namespace

HeatTables heat_tables(const casefile::Case& input, const Machine* machine, const LoadsResult* loads, int segment)
{
    HeatTables tables;
    tables.segment = segment;
    tables.speed = segment_at(input, segment).speed;
    for (int celsius = 20; celsius <= 70; celsius += 10)
        tables.temperatures.push_back(zero_celsius + celsius);
    FrictionLaws laws(input, machine, loads);
    Mistakes mistakes;
    for (const auto& [name, friction] : input.friction)
        mistakes.attempt("friction." + name, [&, &name = name, &friction = friction] {
            const auto law = laws.heat(name, segment_at(input, segment)).heat;
            tables.joints.push_back(joint_heat(input, name, friction, law, tables.temperatures));
        });
    mistakes.raise();
    if (!input.friction.empty())
        tables.friction = laws.summaries();
    tables.warnings = laws.warnings(tables.friction);
    if (!machine)
        return tables;
    double start = 0;
    for (int i = 0; i < segment; ++i)
        start += input.operation[static_cast<std::size_t>(i)].duration;
    mistakes.attempt("joints", [&] {
        tables.conductances =
            interface_conductances(input, *machine, loads, tables.speed > 0 ? tables.speed : conductance_speed(input));
    });
    for (const auto& [name, surface] : input.surfaces)
        if (surface.film)
            mistakes.attempt("surfaces." + name, [&, &name = name] {
                tables.films.push_back(film_table(input, *machine, name, loads, segment, start));
            });
    mistakes.raise();
    warn_of_ranges(tables);
    return tables;
}

}  // namespace deadpoint::press
