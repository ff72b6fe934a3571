#include "deadpoint/report/friction_text.hpp"

#include "deadpoint/report/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace deadpoint::report {
namespace {

constexpr double rpm = 30 / std::numbers::pi;
constexpr double zero_celsius = 273.15;

std::string bearings_line(const study::FrictionSummary& summary)
{
    std::string text = summary.same_loads ? "  load part of the crankshaft's bearings, rigid over flexible shaft:"
                                          : "  load part of the crankshaft's bearings, rigid shaft over flexible "
                                            "reference (each with its own process force):";
    for (std::size_t i = 0; i < summary.bearings.size(); ++i) {
        const auto& b = summary.bearings[i];
        text += fmt::format("{} {} {:.3f} by mean, {:.3f} by peak", i ? ";" : "", b.bearing, b.by_mean, b.by_peak);
    }
    return text + "\n";
}

}  // namespace

std::string friction_text(const study::FrictionSummary& summary)
{
    TextTable table({"friction heat [W]", "20 degC", "40 degC", "load part", "over reference"});
    double sums[] = {0, 0};
    for (const auto& row : summary.rows) {
        std::vector<std::string> cells{row.row};
        for (std::size_t i = 0; i < std::size(sums); ++i) {
            const double heat = row.heat(friction_temperatures[i]).value;
            sums[i] += heat;
            cells.push_back(fmt::format("{:.1f}", heat));
        }
        cells.push_back(row.load_part ? fmt::format("{:.1f}", *row.load_part) : "");
        cells.push_back(row.load_ratio ? fmt::format("{:.3f}", *row.load_ratio) : "");
        table.add_row(cells);
    }
    table.add_row({"all", fmt::format("{:.1f}", sums[0]), fmt::format("{:.1f}", sums[1]), "", ""});
    std::string text = fmt::format("\n  at {} rpm and {} kN\n{}", significant(rpm * summary.speed, 4),
                                   significant(1e-3 * summary.force, 4), table.text());
    if (!summary.bearings.empty())
        text += bearings_line(summary);
    if (summary.balance) {
        const auto& b = *summary.balance;
        const auto shown = [](double watts) { return std::abs(watts) < 0.05 ? 0.0 : watts; };
        text += fmt::format("  power: drive less process {:+.1f} W ({:.1f} - {:.1f}; the linkage is computed without "
                            "friction), friction of all joints {:.1f} W at {:.0f} degC\n",
                            shown(b.drive - b.process), shown(b.drive), shown(b.process), b.friction,
                            b.temperature - zero_celsius);
    }
    return text;
}

std::string friction_json(const study::FrictionSummary& summary)
{
    nlohmann::ordered_json json;
    json["speed_rpm"] = rpm * summary.speed;
    json["force_N"] = summary.force;
    for (const auto& row : summary.rows) {
        auto& entry = json["rows"][row.row];
        entry["law"] = row.law;
        entry["joints"] = row.joints;
        for (const double temperature : friction_temperatures) {
            const double heat = row.heat(temperature).value;
            auto& at = entry[fmt::format("{:.0f}_degC", temperature - zero_celsius)];
            at["heat_W"] = heat;
            if (row.load_part)
                at["viscous_part_W"] = heat - *row.load_part;
        }
        if (row.load_part)
            entry["load_part_W"] = *row.load_part;
        if (row.load_ratio)
            entry["load_duty_over_reference"] = *row.load_ratio;
    }
    for (const auto& b : summary.bearings)
        json["load_part_rigid_over_flexible"][b.bearing] = {{"by_mean", b.by_mean}, {"by_peak", b.by_peak}};
    if (!summary.bearings.empty())
        json["same_process_force"] = summary.same_loads;
    if (summary.balance)
        json["power_W"] = {{"drive_mean", summary.balance->drive},
                           {"process_mean", summary.balance->process},
                           {"drive_less_process", summary.balance->drive - summary.balance->process},
                           {"friction_at_40_degC", summary.balance->friction}};
    return json.dump();
}

}  // namespace deadpoint::report
