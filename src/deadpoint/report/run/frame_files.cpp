#include "deadpoint/report/run/frame_files.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/stress.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

constexpr double millimetre = 1e3;

using nlohmann::ordered_json;
using press::FrameResult;

ordered_json in_millimetres(const Vec3& x) { return {millimetre * x[0], millimetre * x[1], millimetre * x[2]}; }

std::string place_text(const Vec3& x)
{
    return fmt::format("{:.0f}, {:.0f}, {:.0f}", millimetre * x[0], millimetre * x[1], millimetre * x[2]);
}

ordered_json rod_json(const press::RodForce& rod, const std::vector<double>& times)
{
    const auto& change = rod.change.value;
    const auto least = std::ranges::min_element(change);
    return {{"preload", rod.preload},
            {"start_kN", kilonewton * rod.start},
            {"change_at_end_kN", kilonewton * change.back()},
            {"change_at_end_percent", 100 * change.back() / rod.start},
            {"least_kN", kilonewton * (rod.start + *least)},
            {"time_of_least_s", times[static_cast<std::size_t>(least - change.begin())]}};
}

ordered_json bond_json(const press::ClosedBond& bond)
{
    ordered_json json{{"preload", bond.preload},
                      {"start_kN", kilonewton * bond.start},
                      {"change_at_end_kN", kilonewton * bond.change.value.back()}};
    for (const auto& opening : bond.openings)
        json["openings"].push_back({{"time_s", opening.time},
                                    {"largest_tension_MPa", megapascal * opening.largest},
                                    {"place_mm", in_millimetres(opening.place)},
                                    {"share_under_tension", opening.share}});
    return json;
}

ordered_json peak_json(const press::StressPeak& peak)
{
    ordered_json main;
    for (const double value : peak.principal)
        main.push_back(megapascal * value);
    return {{"part", peak.part},
            {"time_s", peak.time},
            {"von_mises_MPa", megapascal * peak.von_mises},
            {"place_mm", in_millimetres(peak.place)},
            {"principal_there_MPa", main},
            {"highest_principal_MPa", megapascal * peak.highest_principal},
            {"lowest_principal_MPa", megapascal * peak.lowest_principal}};
}

std::string rods_text(const FrameResult& frame)
{
    TextTable table({"rod", "at the start [kN]", "least [kN]", "at the end [kN]", "change [kN]", "change [%]"});
    for (const auto& rod : frame.rods) {
        const double change = rod.change.value.back();
        table.add_row({rod.part, fmt::format("{:.1f}", kilonewton * rod.start),
                       fmt::format("{:.1f}", kilonewton * (rod.start + *std::ranges::min_element(rod.change.value))),
                       fmt::format("{:.1f}", kilonewton * (rod.start + change)),
                       fmt::format("{:+.2f}", kilonewton * change), fmt::format("{:+.2f}", 100 * change / rod.start)});
    }
    return table.empty() ? "" : "\n" + table.text();
}

std::string bonds_text(const FrameResult& frame)
{
    TextTable table({"held closed", "pressed at the start [kN]", "at the end [kN]", "area pulled apart [%]"});
    for (const auto& bond : frame.bonds) {
        double share = 0;
        for (const auto& opening : bond.openings)
            share = std::max(share, opening.share);
        table.add_row({bond.name, fmt::format("{:.1f}", -kilonewton * bond.start),
                       fmt::format("{:.1f}", -kilonewton * (bond.start + bond.change.value.back())),
                       fmt::format("{:.0f}", 100 * share)});
    }
    return table.empty() ? "" : "\n" + table.text();
}

std::string stress_text(const FrameResult& frame)
{
    TextTable table(
        {"largest stress at the end", "von Mises [MPa]", "principal, highest and lowest", "at x, y, z [mm]"});
    for (const auto& peak : frame.stress)
        if (peak.time == frame.stress.back().time)
            table.add_row({peak.part, fmt::format("{:.2f}", megapascal * peak.von_mises),
                           fmt::format("{:+.2f} {:+.2f}", megapascal * peak.highest_principal,
                                       megapascal * peak.lowest_principal),
                           place_text(peak.place)});
    return table.empty() ? "" : "\n" + table.text();
}

}  // namespace

void add_frame_columns(std::vector<CsvColumn>& columns, const FrameResult& frame, const SeriesSampler& sample)
{
    for (const auto& rod : frame.rods)
        columns.push_back(
            csv_column(schema::history::rod_force, sample(rod.change, kilonewton, kilonewton * rod.start), rod.part));
    for (const auto& bond : frame.bonds)
        columns.push_back(csv_column(schema::history::bond_force,
                                     sample(bond.change, kilonewton, kilonewton * bond.start), bond.name));
}

void write_stress(const std::filesystem::path& path, const FrameResult& frame, const std::vector<std::string>& comments)
{
    std::vector<std::string> parts;
    std::vector<std::vector<double>> numbers(10);
    for (const auto& peak : frame.stress) {
        parts.push_back(peak.part);
        std::size_t column = 0;
        numbers[column++].push_back(peak.time);
        numbers[column++].push_back(megapascal * peak.von_mises);
        for (const double value : peak.principal)
            numbers[column++].push_back(megapascal * value);
        for (const double value : peak.place)
            numbers[column++].push_back(millimetre * value);
        numbers[column++].push_back(megapascal * peak.highest_principal);
        numbers[column++].push_back(megapascal * peak.lowest_principal);
    }
    namespace stress = schema::stress;
    std::vector<CsvColumn> columns{csv_column(schema::time, numbers[0]), csv_column(stress::part, parts)};
    std::size_t next = 1;
    for (const auto* column : {&stress::von_mises, &stress::first, &stress::second, &stress::third, &stress::x,
                               &stress::y, &stress::z, &stress::highest, &stress::lowest})
        columns.push_back(csv_column(*column, numbers[next++]));
    write_table(path, comments, columns);
}

ordered_json frame_json(const FrameResult& frame, const std::vector<double>& times)
{
    ordered_json json = ordered_json::object();
    if (frame.support_force)
        json["support_force_kN"] = kilonewton * *frame.support_force;
    for (const auto& rod : frame.rods)
        json["rods"][rod.part] = rod_json(rod, times);
    for (const auto& bond : frame.bonds)
        json["closed"][bond.name] = bond_json(bond);
    for (const auto& peak : frame.stress)
        json["stress"].push_back(peak_json(peak));
    return json;
}

std::string frame_text(const FrameResult& frame) { return rods_text(frame) + bonds_text(frame) + stress_text(frame); }

}  // namespace deadpoint::report
