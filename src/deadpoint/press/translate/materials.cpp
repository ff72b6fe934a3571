#include "deadpoint/press/translate/materials.hpp"

#include "deadpoint/core/linear_curve.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::press {
namespace {

LinearCurve curve_of(const casefile::Table& table)
{
    return table.x.empty() ? LinearCurve() : LinearCurve(table.x, table.y);
}

Material translate(const casefile::Material& given, double initial)
{
    const auto m = at_temperature(given, initial);
    Material result{m.density, m.conductivity, m.specific_heat, m.expansion, m.youngs_modulus, m.poissons_ratio};
    result.conductivity_table = curve_of(m.conductivity_table);
    result.specific_heat_table = curve_of(m.specific_heat_table);
    result.expansion_table = curve_of(m.expansion_table);
    result.expansion_is_mean = m.expansion_kind == casefile::Material::Expansion::mean;
    result.expansion_reference = m.expansion_reference.value_or(initial);
    return result;
}

}  // namespace

casefile::Material at_temperature(casefile::Material m, double temperature)
{
    const auto take = [&](double& constant, const casefile::Table& table) {
        if (!table.x.empty())
            constant = interpolate_linear(table.x, table.y, temperature).value;
    };
    take(m.conductivity, m.conductivity_table);
    take(m.specific_heat, m.specific_heat_table);
    take(m.expansion, m.expansion_table);
    return m;
}

std::vector<Material> describe_materials(const casefile::Case& input, const Machine& machine)
{
    std::vector<Material> materials;
    for (const auto& part : machine.parts)
        materials.push_back(
            translate(input.materials.at(input.parts.at(part.name).material), input.machine.initial_temperature));
    return materials;
}

std::vector<std::string> material_warnings(const casefile::Case& input, const Machine& machine,
                                           const ThermalHistory& history)
{
    constexpr double rounding = 1e-6;  // [K]
    std::vector<std::string> warnings;
    for (const auto& [name, material] : input.materials) {
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (std::size_t p = 0; p < machine.parts.size(); ++p)
            if (input.parts.at(machine.parts[p].name).material == name) {
                lowest = std::min(lowest, history.part_lowest[p]);
                highest = std::max(highest, history.part_highest[p]);
            }
        const auto check = [&, &name = name](const char* key, const casefile::Table& table) {
            if (!table.x.empty() && (lowest < table.x.front() - rounding || highest > table.x.back() + rounding))
                warnings.push_back(fmt::format(
                    "materials.{}.{} was used from {:.1f} to {:.1f} degC, but its table holds from {:.1f} to {:.1f} "
                    "degC; beyond it the value at the end was used; extend the table",
                    name, key, lowest - zero_celsius, highest - zero_celsius, table.x.front() - zero_celsius,
                    table.x.back() - zero_celsius));
        };
        check("conductivity", material.conductivity_table);
        check("specific_heat", material.specific_heat_table);
        check("expansion", material.expansion_table);
    }
    return warnings;
}

}  // namespace deadpoint::press
