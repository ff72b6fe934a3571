#include "deadpoint/report/run/sensitivities_text.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/press/result/sensitivities.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace deadpoint::report {
namespace {

using press::Sensitivities;
using press::Sensitivity;

template <class Value>
auto column_of(const Sensitivities& sensitivities, const Value& value)
{
    std::vector<std::decay_t<std::invoke_result_t<Value, const Sensitivity&>>> result;
    for (const auto& of : sensitivities.of)
        result.push_back(std::invoke(value, of));
    return result;
}

bool is_degree(const Sensitivity& of) { return of.unit == "degC"; }

/// Effect on the probe that a coefficient changes most.
double largest_effect(const Sensitivity& of)
{
    double result = 0;
    for (const double temperature : of.temperature)
        if (std::abs(of.change * temperature) > std::abs(result))
            result = of.change * temperature;
    return result;
}

}  // namespace

void write_sensitivities(const std::filesystem::path& path, std::span<const std::string> comments,
                         const Sensitivities& sensitivities)
{
    namespace columns = schema::sensitivities;
    std::vector<CsvColumn> table{csv_column(columns::coefficient, column_of(sensitivities, &Sensitivity::coefficient)),
                                 csv_column(columns::value, column_of(sensitivities, &Sensitivity::value)),
                                 csv_column(columns::unit, column_of(sensitivities, &Sensitivity::unit)),
                                 csv_column(columns::change, column_of(sensitivities, &Sensitivity::change))};
    if (sensitivities.has_gap) {
        table.push_back(csv_column(columns::gap_per_unit, column_of(sensitivities, [](const Sensitivity& of) {
                                       return micrometre * of.gap;
                                   })));
        table.push_back(csv_column(columns::gap_effect, column_of(sensitivities, [](const Sensitivity& of) {
                                       return micrometre * of.change * of.gap;
                                   })));
    }
    for (std::size_t p = 0; p < sensitivities.probes.size(); ++p) {
        const auto& name = sensitivities.probes[p];
        table.push_back(csv_column(columns::probe_per_unit,
                                   column_of(sensitivities, [p](const Sensitivity& of) { return of.temperature[p]; }),
                                   name));
        table.push_back(csv_column(
            columns::probe_effect,
            column_of(sensitivities, [p](const Sensitivity& of) { return of.change * of.temperature[p]; }), name));
    }
    write_table(path, comments, table);
}

nlohmann::ordered_json sensitivities_json(const Sensitivities& sensitivities)
{
    constexpr std::size_t shown = 10;
    nlohmann::ordered_json json{{"time_s", sensitivities.time}};
    json["strongest"] = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < std::min(shown, sensitivities.of.size()); ++k) {
        const auto& of = sensitivities.of[k];
        nlohmann::ordered_json row{
            {"coefficient", of.coefficient}, {"value", of.value}, {"unit", of.unit}, {"change", of.change}};
        if (sensitivities.has_gap)
            row["E_SW_um"] = micrometre * of.change * of.gap;
        row["largest_probe_K"] = largest_effect(of);
        json["strongest"].push_back(std::move(row));
    }
    return json;
}

std::string sensitivities_line(const Sensitivities& sensitivities)
{
    constexpr std::size_t shown = 5;
    std::string text =
        sensitivities.has_gap ? "  what moves the gap at the end:" : "  what moves the probes at the end:";
    for (std::size_t k = 0; k < std::min(shown, sensitivities.of.size()); ++k) {
        const auto& of = sensitivities.of[k];
        text += fmt::format("{} {} {} {:+.2f}", k ? "," : "", is_degree(of) ? "+1 K" : "+10 %", of.coefficient,
                            sensitivities.has_gap ? micrometre * of.change * of.gap : largest_effect(of));
    }
    return text + (sensitivities.has_gap ? " um\n" : " K\n");
}

}  // namespace deadpoint::report
