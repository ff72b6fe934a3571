#include "deadpoint/report/heat/friction_text.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace deadpoint::report {
namespace {

std::string bearings_line(const press::FrictionSummary& summary)
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

// Watts over the turn; rounding noise counts as zero.
std::string watts(double value) { return fmt::format("{:.1f} W", std::abs(value) < 0.05 ? 0.0 : value); }

std::string power_lines(const press::PowerBalance& balance)
{
    const double percent = 100 * balance.mismatch();
    std::string text =
        fmt::format("  mean power without friction: drive {}, process {} (difference {} % of the mean "
                    "absolute power, {})\n",
                    watts(balance.drive), watts(balance.process),
                    percent < 0.01 ? "below 0.01" : fmt::format("{:.2g}", percent), watts(balance.swing));
    for (const auto& power : balance.at) {
        text += fmt::format("  with all joints at {:.0f} degC: friction {}, {} N m at the crank; motor {} with the "
                            "process",
                            power.temperature - zero_celsius, watts(power.friction), significant(power.torque, 4),
                            watts(power.motor));
        if (power.share_of_motor)
            text += fmt::format(", {} % of its {}", significant(100 * *power.share_of_motor), watts(balance.rated));
        text += "\n";
    }
    return text;
}

nlohmann::ordered_json power_json(const press::PowerBalance& balance)
{
    nlohmann::ordered_json json = {{"drive_mean", balance.drive},
                                   {"process_mean", balance.process},
                                   {"drive_less_process", balance.drive - balance.process},
                                   {"drive_mean_magnitude", balance.swing},
                                   {"mismatch", balance.mismatch()},
                                   {"mismatch_allowed", press::power_tolerance}};
    if (balance.rated > 0)
        json["motor_stated"] = balance.rated;
    for (const auto& power : balance.at) {
        auto& at = json["with_friction"][fmt::format("{:.0f}_degC", power.temperature - zero_celsius)];
        at = {{"friction", power.friction}, {"motor", power.motor}, {"crank_torque_N_m", power.torque}};
        if (power.share_of_motor)
            at["share_of_motor"] = *power.share_of_motor;
    }
    return json;
}

std::string summary_text(const press::FrictionSummary& summary)
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
    if (summary.balance)
        text += power_lines(*summary.balance);
    return text;
}

nlohmann::ordered_json summary_json(const press::FrictionSummary& summary)
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
        json["power_W"] = power_json(*summary.balance);
    return json;
}

}  // namespace

std::string friction_text(const std::vector<press::FrictionSummary>& summaries)
{
    std::string text;
    for (const auto& summary : summaries)
        text += summary_text(summary);
    return text;
}

nlohmann::ordered_json friction_json(const std::vector<press::FrictionSummary>& summaries)
{
    auto list = nlohmann::ordered_json::array();
    for (const auto& summary : summaries)
        list.push_back(summary_json(summary));
    return list;
}

}  // namespace deadpoint::report
