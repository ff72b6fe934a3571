#include "deadpoint/report/run/drift_causes_text.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

struct CauseRow {
    std::string kind;
    std::string name;
    double value = 0;  ///< [um]
};

std::vector<CauseRow> rows_of(const DriftCauses& causes)
{
    std::vector<CauseRow> rows;
    const auto add = [&](const char* kind, const std::vector<std::pair<std::string, double>>& values) {
        for (const auto& [name, value] : values)
            rows.push_back({kind, name, micrometre * value});
    };
    add("friction", causes.joints);
    add("heat source", causes.heat_sources);
    add("surface", causes.surfaces);
    for (const auto& [kind, value] :
         {std::pair{"oil", causes.oil}, {"air", causes.air}, {"start", causes.start}, {"remainder", causes.remainder}})
        rows.push_back({kind, {}, micrometre * value});
    return rows;
}

/// How the causes were computed, if not in all unknowns.
std::string basis_note(const DriftCauses& causes)
{
    return causes.fields == 0 ? ""
                              : fmt::format("computed on {} fields of temperature; the last four changed no share "
                                            "by more than {:.1g} um",
                                            causes.fields, micrometre * causes.change);
}

const std::string& shown_name(const CauseRow& row) { return row.name.empty() ? row.kind : row.name; }

}  // namespace

void write_drift_causes(const std::filesystem::path& path, std::span<const std::string> comments,
                        const std::vector<DriftCauses>& causes)
{
    std::vector<std::string> kinds, names;
    for (const auto& row : rows_of(causes.front())) {
        kinds.push_back(row.kind);
        names.push_back(row.name);
    }
    std::vector<std::string> lines(comments.begin(), comments.end());
    for (const auto& at : causes)
        if (at.fields > 0)
            lines.push_back(fmt::format("shares after {:.0f} s: {}", at.time, basis_note(at)));
    std::vector<CsvColumn> columns{csv_column(schema::causes::cause, kinds), csv_column(schema::causes::name, names)};
    for (const auto& at : causes) {
        std::vector<double> values;
        for (const auto& row : rows_of(at))
            values.push_back(row.value);
        columns.push_back(csv_column(schema::causes::share, std::move(values), fmt::format("{:.0f}", at.time)));
    }
    write_table(path, lines, columns);
}

nlohmann::ordered_json drift_causes_json(const std::vector<DriftCauses>& causes)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& at : causes) {
        nlohmann::ordered_json json{{"time_s", at.time},
                                    {"E_SW", micrometre * at.gap},
                                    {"fields", at.fields},
                                    {"change", micrometre * at.change}};
        for (const auto& row : rows_of(at)) {
            if (row.name.empty())
                json[row.kind] = row.value;
            else
                json[row.kind][row.name] = row.value;
        }
        list.push_back(std::move(json));
    }
    return list;
}

std::string drift_causes_line(const std::vector<DriftCauses>& causes)
{
    if (causes.empty())
        return {};
    auto rows = rows_of(causes.back());
    std::ranges::stable_sort(rows, std::ranges::greater{}, [](const CauseRow& row) { return std::abs(row.value); });
    constexpr std::size_t shown = 6;
    std::string text = "  by cause at the end:";
    for (std::size_t i = 0; i < std::min(shown, rows.size()); ++i)
        if (std::abs(rows[i].value) >= 0.05)
            text += fmt::format("{} {} {:+.1f}", i ? "," : "", shown_name(rows[i]), rows[i].value);
    text += " um\n";
    if (causes.back().fields > 0)
        text += "    (" + basis_note(causes.back()) + ")\n";
    return text;
}

}  // namespace deadpoint::report
