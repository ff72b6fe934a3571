#include "deadpoint/report/heat_flows.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

constexpr double celsius = -273.15;

}  // namespace

void add_heat_flow_columns(std::vector<CsvColumn>& columns, const study::RunResult& result, const Sampler& sample)
{
    for (std::size_t i = 0; i < result.body_heat.size(); ++i)
        columns.push_back({result.body_heat[i] + " heat", "W", sample(result.thermal.body_heat[i], result.whole, 0)});
    for (std::size_t i = 0; i < result.oil.size(); ++i) {
        const auto& circuit = result.thermal.oil[i];
        const std::string name = "oil " + result.oil[i] + " ";
        columns.push_back({name + "inlet", "degC", sample(circuit.inlet, 1, celsius)});
        columns.push_back({name + "outlet", "degC", sample(circuit.outlet, 1, celsius)});
        columns.push_back({name + "sump", "degC", sample(circuit.sump, 1, celsius)});
        columns.push_back({name + "heat", "W", sample(circuit.heat, result.whole, 0)});
        columns.push_back({name + "cooler", "W", sample(circuit.cooler, result.whole, 0)});
    }
}

nlohmann::ordered_json heat_flows_json(const study::RunResult& result)
{
    nlohmann::ordered_json json;
    for (std::size_t i = 0; i < result.body_heat.size(); ++i)
        json["sources_W"][result.body_heat[i]] = result.whole * result.thermal.body_heat[i].back();
    for (std::size_t i = 0; i < result.oil.size(); ++i) {
        const auto& circuit = result.thermal.oil[i];
        json["oil"][result.oil[i]] = {{"inlet_degC", circuit.inlet.back() + celsius},
                                      {"outlet_degC", circuit.outlet.back() + celsius},
                                      {"sump_degC", circuit.sump.back() + celsius},
                                      {"heat_W", result.whole * circuit.heat.back()},
                                      {"cooler_W", result.whole * circuit.cooler.back()}};
    }
    return json;
}

std::string heat_flows_text(const study::RunResult& result)
{
    std::string text;
    for (std::size_t i = 0; i < result.body_heat.size(); ++i)
        text += fmt::format("  {}: {:.0f} W at the end\n", result.body_heat[i],
                            result.whole * result.thermal.body_heat[i].back());
    for (std::size_t i = 0; i < result.oil.size(); ++i) {
        const auto& circuit = result.thermal.oil[i];
        text += fmt::format("  oil {}: {:.1f} degC at the first joint, {:.1f} after the last one, takes {:.0f} W",
                            result.oil[i], circuit.inlet.back() + celsius, circuit.outlet.back() + celsius,
                            result.whole * circuit.heat.back());
        if (circuit.cooler.back() != 0)
            text += fmt::format("; the {} {:.0f} W", circuit.cooler.back() > 0 ? "cooler takes" : "heater gives",
                                result.whole * std::abs(circuit.cooler.back()));
        text += "\n";
    }
    return text;
}

}  // namespace deadpoint::report
