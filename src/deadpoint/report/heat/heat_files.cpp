#include "deadpoint/report/heat/heat_files.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/heat/friction_text.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <fmt/format.h>
#include <limits>

namespace deadpoint::report {
namespace {

using press::HeatTables;
using Json = nlohmann::ordered_json;
using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string yes_no(bool value) { return value ? "yes" : "no"; }

std::string joined(const Texts& texts, const char* between)
{
    std::string result;
    for (const auto& text : texts)
        result += (result.empty() ? "" : between) + text;
    return result;
}

Json joints_json(const HeatTables& tables)
{
    Json json = Json::object();
    for (const auto& joint : tables.joints) {
        Json values = Json::array();
        for (std::size_t i = 0; i < joint.heat.size(); ++i)
            values.push_back({{"temperature_degC", tables.temperatures[i] - zero_celsius},
                              {"heat_W", joint.heat[i]},
                              {"in_range", static_cast<bool>(joint.in_range[i])}});
        json[joint.row] = {
            {"law", joint.law}, {"lubricant", joint.lubricant}, {"joints", joint.joints}, {"heat", values}};
    }
    return json;
}

Json conductances_json(const HeatTables& tables)
{
    Json list = Json::array();
    for (const auto& c : tables.conductances) {
        Json entry = {{"joint", c.joint}, {"interface", c.name}, {"law", c.law}, {"area_m2", c.area}};
        if (c.pressure) {
            entry["pressure_Pa"] = *c.pressure;
            entry["pressure_from"] = c.pressure_from_loads ? "loads" : "case";
        }
        entry["resistance_m2_K_per_W"] = c.resistance();
        entry["side_a_W_per_m2_K"] = c.film_a;
        entry["side_b_W_per_m2_K"] = c.film_b;
        entry["in_range"] = c.in_range;
        entry["notes"] = c.notes;
        list.push_back(entry);
    }
    return list;
}

Json film_json(const std::vector<press::FilmValue>& values)
{
    Json list = Json::array();
    for (const auto& value : values)
        list.push_back({{"rise_K", value.rise},
                        {"speed", value.speed},
                        {"convection_W_per_m2_K", value.convection},
                        {"radiation_W_per_m2_K", value.radiation},
                        {"in_range", value.in_range}});
    return list;
}

Json heat_json(const casefile::Case& input, const HeatTables& tables, const Texts& warnings)
{
    Json json;
    json["version"] = version;
    json["case"] = {{"name", input.machine.name}, {"hash", casefile::case_hash(input)}};
    json["warnings"] = warnings;
    json["conventions"] =
        "friction heat is that of the whole press, areas are those of the modelled half; speeds of films "
        "are in rad/s where the surface turns, in m/s where it moves";
    json["operation"] = {{"segment", tables.segment}, {"speed_rpm", rpm * tables.speed}};
    json["friction"] = joints_json(tables);
    json["operating_points"] = friction_json(tables.friction);
    json["conductances"] = conductances_json(tables);
    json["films"] = Json::object();
    for (const auto& film : tables.films)
        json["films"][film.surface] = {{"law", film.law},
                                       {"area_m2", film.area},
                                       {"length_m", film.length > 0 ? Json(film.length) : Json()},
                                       {"ambient_degC", film.ambient - zero_celsius},
                                       {"at_rest", film_json(film.at_rest)},
                                       {"running", film_json(film.running)}};
    return json;
}

void write_joint_heat(const std::filesystem::path& path, const HeatTables& tables, const Texts& comments)
{
    Numbers celsius;
    for (const double temperature : tables.temperatures)
        celsius.push_back(temperature - zero_celsius);
    std::vector<CsvColumn> columns{csv_column(schema::joint_heat::temperature, celsius)};
    for (const auto& joint : tables.joints)
        columns.push_back(csv_column(schema::joint_heat::heat, joint.heat, joint.row));
    write_table(path, comments, columns);
}

void write_conductances(const std::filesystem::path& path, const HeatTables& tables, const Texts& comments)
{
    Texts joint, name, law, source, range, notes;
    Numbers area, pressure, resistance, a, b;
    for (const auto& c : tables.conductances) {
        joint.push_back(c.joint);
        name.push_back(c.name);
        law.push_back(c.law);
        area.push_back(c.area);
        pressure.push_back(c.pressure.value_or(none));
        source.emplace_back(!c.pressure ? "" : c.pressure_from_loads ? "loads" : "case");
        resistance.push_back(c.resistance());
        a.push_back(c.film_a);
        b.push_back(c.film_b);
        range.push_back(yes_no(c.in_range));
        notes.push_back(joined(c.notes, "; "));
    }
    namespace table = schema::conductances;
    const std::vector<CsvColumn> columns{csv_column(table::joint, joint),
                                         csv_column(table::interface, name),
                                         csv_column(table::law, law),
                                         csv_column(table::area, area),
                                         csv_column(table::pressure, pressure),
                                         csv_column(table::pressure_from, source),
                                         csv_column(table::resistance, resistance),
                                         csv_column(table::side_a, a),
                                         csv_column(table::side_b, b),
                                         csv_column(table::in_range, range),
                                         csv_column(table::notes, notes)};
    write_table(path, comments, columns);
}

void write_films(const std::filesystem::path& path, const HeatTables& tables, const Texts& comments)
{
    Texts surface, law, state, range;
    Numbers length, ambient, rise, speed, convection, radiation, total;
    for (const auto& film : tables.films)
        for (const auto* values : {&film.at_rest, &film.running})
            for (const auto& value : *values) {
                surface.push_back(film.surface);
                law.push_back(film.law);
                state.emplace_back(values == &film.running ? "running" : "at rest");
                length.push_back(film.length > 0 ? film.length : none);
                ambient.push_back(film.ambient - zero_celsius);
                rise.push_back(value.rise);
                speed.push_back(value.speed);
                convection.push_back(value.convection);
                radiation.push_back(value.radiation);
                total.push_back(value.convection + value.radiation);
                range.push_back(yes_no(value.in_range));
            }
    namespace table = schema::films;
    const std::vector<CsvColumn> columns{
        csv_column(table::surface, surface),     csv_column(table::law, law),
        csv_column(table::state, state),         csv_column(table::length, length),
        csv_column(table::ambient, ambient),     csv_column(table::rise, rise),
        csv_column(table::speed, speed),         csv_column(table::convection, convection),
        csv_column(table::radiation, radiation), csv_column(table::total, total),
        csv_column(table::in_range, range)};
    write_table(path, comments, columns);
}

}  // namespace

void write_heat_files(const std::filesystem::path& folder, const casefile::Case& input, const HeatTables& tables,
                      const std::vector<std::string>& warnings)
{
    Texts comments{fmt::format("deadpoint {}", version),
                   fmt::format("case {}, hash {}", input.machine.name, casefile::case_hash(input)),
                   fmt::format("segment {}: {:g} rpm", tables.segment, rpm * tables.speed)};
    for (const auto& warning : warnings)
        comments.push_back("warning: " + warning);
    write_json(folder / "heat.json", heat_json(input, tables, warnings));
    write_joint_heat(folder / "joint_heat.csv", tables, comments);
    write_conductances(folder / "conductances.csv", tables, comments);
    write_films(folder / "films.csv", tables, comments);
}

}  // namespace deadpoint::report
