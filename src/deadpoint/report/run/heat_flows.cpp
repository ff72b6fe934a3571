#include "deadpoint/report/run/heat_flows.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/schema/columns.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
void add_heat_flow_columns(std::vector<CsvColumn>& columns, const press::RunResult& result,
                           const SeriesSampler& sample_series, const Sampler& sample)
{
    namespace history = schema::history;
    for (const auto& [name, heat] : result.body_heat)
        columns.push_back(csv_column(history::source, sample(heat, result.symmetry_factor, 0), name));
    for (const auto& [name, heat] : result.bonds)
        columns.push_back(csv_column(history::bond_heat, sample(heat, result.symmetry_factor, 0), name));
    for (const auto& [name, circuit] : result.oil) {
        columns.push_back(csv_column(history::oil_inlet, sample_series(circuit.inlet, 1, -zero_celsius), name));
        columns.push_back(csv_column(history::oil_outlet, sample_series(circuit.outlet, 1, -zero_celsius), name));
        columns.push_back(csv_column(history::oil_sump, sample_series(circuit.sump, 1, -zero_celsius), name));
        columns.push_back(csv_column(history::oil_heat, sample(circuit.heat, result.symmetry_factor, 0), name));
        columns.push_back(csv_column(history::oil_cooler, sample(circuit.cooler, result.symmetry_factor, 0), name));
    }
    for (const auto& [name, air] : result.enclosures) {
        columns.push_back(csv_column(history::air, sample_series(air.temperature, 1, -zero_celsius), name));
        columns.push_back(
            csv_column(history::air_from_surfaces, sample(air.from_surfaces, result.symmetry_factor, 0), name));
        columns.push_back(csv_column(history::air_power, sample(air.power, result.symmetry_factor, 0), name));
        columns.push_back(csv_column(history::air_to_room, sample(air.to_room, result.symmetry_factor, 0), name));
    }
}

nlohmann::ordered_json heat_flows_json(const press::RunResult& result)
{
    nlohmann::ordered_json json;
    for (const auto& [source, heat] : result.body_heat)
        json["sources_W"][source] = result.symmetry_factor * heat.back();
    for (const auto& [bond, heat] : result.bonds)
        json["bonds_W"][bond] = result.symmetry_factor * heat.back();
    for (const auto& [oil, circuit] : result.oil) {
        json["oil"][oil] = {{"inlet_degC", circuit.inlet.value.back() - zero_celsius},
                            {"outlet_degC", circuit.outlet.value.back() - zero_celsius},
                            {"sump_degC", circuit.sump.value.back() - zero_celsius},
                            {"heat_W", result.symmetry_factor * circuit.heat.back()},
                            {"cooler_W", result.symmetry_factor * circuit.cooler.back()}};
    }
    for (const auto& [enclosure, air] : result.enclosures) {
        json["enclosures"][enclosure] = {{"temperature_degC", air.temperature.value.back() - zero_celsius},
                                         {"from_surfaces_W", result.symmetry_factor * air.from_surfaces.back()},
                                         {"power_W", result.symmetry_factor * air.power.back()},
                                         {"to_room_W", result.symmetry_factor * air.to_room.back()}};
    }
    return json;
}

std::string heat_flows_text(const press::RunResult& result)
{
    std::string text;
    for (const auto& [source, heat] : result.body_heat)
        text += fmt::format("  {}: {:.0f} W at the end\n", source, result.symmetry_factor * heat.back());
    for (const auto& [bond, heat] : result.bonds)
        text += fmt::format("  bond {}: {:+.0f} W from the first to the second at the end\n", bond,
                            result.symmetry_factor * heat.back());
    for (const auto& [oil, circuit] : result.oil) {
        text += fmt::format("  oil {}: {:.1f} degC at the first joint, {:.1f} after the last one, takes {:.0f} W", oil,
                            circuit.inlet.value.back() - zero_celsius, circuit.outlet.value.back() - zero_celsius,
                            result.symmetry_factor * circuit.heat.back());
        if (circuit.cooler.back() != 0)
            text += fmt::format("; the {} {:.0f} W", circuit.cooler.back() > 0 ? "cooler takes" : "heater gives",
                                result.symmetry_factor * std::abs(circuit.cooler.back()));
        text += "\n";
    }
    for (const auto& [enclosure, air] : result.enclosures) {
        text +=
            fmt::format("  air in {}: {:.1f} degC, {:.0f} W from its surfaces", enclosure,
                        air.temperature.value.back() - zero_celsius, result.symmetry_factor * air.from_surfaces.back());
        if (air.power.back() != 0)
            text += fmt::format(" and {:.0f} W of its own", result.symmetry_factor * air.power.back());
        text += fmt::format(", {:.0f} W to the room\n", result.symmetry_factor * air.to_room.back());
    }
    return text;
}

}  // namespace deadpoint::report
