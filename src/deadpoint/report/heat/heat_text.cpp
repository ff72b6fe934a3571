#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/report/heat/friction_text.hpp"
#include "deadpoint/report/heat/heat_files.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using press::HeatTables;

/// A mark after values outside the tested range of their law.
std::string marked(const std::string& text, bool in_range) { return in_range ? text : fmt::format("{}*", text); }

std::string joint_heat_table(const HeatTables& tables)
{
    std::vector<std::string> titles{"friction heat [W]"};
    for (const double temperature : tables.temperatures)
        titles.push_back(fmt::format("{:.0f} degC", temperature - zero_celsius));
    TextTable table(titles);
    for (const auto& joint : tables.joints) {
        std::vector<std::string> row{joint.row};
        for (std::size_t i = 0; i < joint.heat.size(); ++i)
            row.push_back(marked(fmt::format("{:.2f}", joint.heat[i]), joint.in_range[i]));
        table.add_row(row);
    }
    std::vector<std::string> sums{"all"};
    for (std::size_t i = 0; i < tables.temperatures.size(); ++i) {
        double sum = 0;
        for (const auto& joint : tables.joints)
            sum += joint.heat[i];
        sums.push_back(fmt::format("{:.2f}", sum));
    }
    table.add_row(sums);
    return table.text();
}

std::string conductance_table(const HeatTables& tables)
{
    TextTable table({"interface", "law", "pressure [MPa]", "R'' [m2 K/W]", "side a [W/m2/K]", "side b"});
    table.align_left(1);
    for (const auto& c : tables.conductances)
        table.add_row({c.joint.empty() ? c.name : fmt::format("{}.{}", c.joint, c.name), c.law,
                       c.pressure ? significant(megapascal * *c.pressure) : "",
                       marked(fmt::format("{:.3g}", c.resistance()), c.in_range), significant(c.film_a),
                       significant(c.film_b)});
    return table.text();
}

std::string film_table(const HeatTables& tables)
{
    TextTable table(
        {"coefficient [W/m2/K] of", "law", "length [mm]", "state", "5 K", "10 K", "20 K", "of it radiation"});
    table.align_left(1);
    table.align_left(3);
    for (const auto& film : tables.films)
        for (const auto* values : {&film.at_rest, &film.running}) {
            if (values->empty())
                continue;
            std::vector<std::string> row{film.surface, film.law, film.length > 0 ? significant(1e3 * film.length) : "",
                                         values == &film.running ? "running" : "at rest"};
            for (const auto& value : *values)
                row.push_back(marked(significant(value.convection + value.radiation), value.in_range));
            row.push_back(significant(values->back().radiation));
            table.add_row(row);
        }
    return table.text();
}

}  // namespace

std::string heat_text(const casefile::Case& input, const HeatTables& tables)
{
    const auto& segment = input.operation[static_cast<std::size_t>(tables.segment)];
    std::string text = fmt::format("\n{}{}{}: {} rpm\n", input.machine.name, segment.name.empty() ? "" : ", ",
                                   segment.name, significant(rpm * tables.speed, 4));
    if (!tables.joints.empty())
        text += fmt::format("\n{}", joint_heat_table(tables));
    text += friction_text(tables.friction);
    if (!tables.conductances.empty())
        text += fmt::format("\n{}", conductance_table(tables));
    if (!tables.films.empty())
        text += fmt::format("\n{}", film_table(tables));
    if (std::ranges::find(text, '*') != text.end())
        text += "\n  * outside the tested range of the law\n";
    return text;
}

}  // namespace deadpoint::report
