#include "deadpoint/report/run/run_files.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_summary.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/heat/friction_text.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "deadpoint/report/mesh/mesh_files.hpp"
#include "deadpoint/report/mesh/view_file.hpp"
#include "deadpoint/report/run/accuracy_text.hpp"
#include "deadpoint/report/run/drift_causes_text.hpp"
#include "deadpoint/report/run/drift_summary_text.hpp"
#include "deadpoint/report/run/frame_files.hpp"
#include "deadpoint/report/run/gaps_files.hpp"
#include "deadpoint/report/run/heat_flows.hpp"
#include "deadpoint/report/run/run_text.hpp"
#include "deadpoint/report/run/sensitivities_text.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/schema/schema.hpp"
#include "deadpoint/report/tables/sampled.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using press::RunResult;

std::vector<std::string> head(const casefile::Case& input, const RunResult& result,
                              const std::vector<std::string>& warnings)
{
    auto lines = file_comments(input, warnings);
    if (result.thermal.interrupted)
        lines.insert(lines.begin() + 2, fmt::format("interrupted at t = {:.1f} s", result.thermal.time.back()));
    return lines;
}

std::vector<CsvColumn> history_columns(const casefile::Case& input, const RunResult& result)
{
    const auto& history = result.thermal;
    const auto times = history_times(input, result);
    std::vector<CsvColumn> columns{csv_column(schema::time, times)};
    for (const auto& [name, course] : result.probes)
        columns.push_back(
            csv_column(schema::history::probe, sampled(history.time, course, times, 1, -zero_celsius), name));
    for (const auto& [name, joint] : result.joints)
        columns.push_back(csv_column(schema::history::joint_temperature,
                                     sampled(history.time, joint.temperature, times, 1, -zero_celsius), name));
    for (const auto& [name, joint] : result.joints)
        columns.push_back(
            csv_column(schema::history::joint_heat, sampled_linear(history.time, joint.heat, times, 1, 0), name));
    columns.push_back(csv_column(schema::history::to_air,
                                 sampled_linear(history.time, history.to_air, times, result.symmetry_factor, 0)));
    columns.push_back(csv_column(schema::history::to_oil,
                                 sampled_linear(history.time, history.to_oil, times, result.symmetry_factor, 0)));
    add_heat_flow_columns(
        columns, result,
        [&](const Series& series, double factor, double offset) {
            return sampled(history.time, series, times, factor, offset);
        },
        [&](const std::vector<double>& values, double factor, double offset) {
            return sampled_linear(history.time, values, times, factor, offset);
        });
    if (result.drift)
        for (const auto& [name, series] : dimensions(*result.drift))
            columns.push_back(
                csv_column(schema::history::dimension, sampled(history.time, *series, times, micrometre, 0), name));
    if (result.frame)
        add_frame_columns(columns, *result.frame, [&](const Series& series, double factor, double offset) {
            return sampled(history.time, series, times, factor, offset);
        });
    return columns;
}

std::vector<CsvColumn> contribution_columns(const casefile::Case& input, const RunResult& result)
{
    const auto times = history_times(input, result);
    std::vector<CsvColumn> columns{csv_column(schema::time, times)};
    columns.push_back(csv_column(schema::gap, sampled(result.drift->time, result.drift->gap, times, micrometre, 0)));
    for (const auto part : strongest_parts(*result.drift))
        columns.push_back(
            csv_column(schema::contributions::part,
                       sampled_linear(result.drift->time, result.drift->by_part[part], times, micrometre, 0),
                       result.parts[part].name));
    return columns;
}

// None where the case has no gaps.
std::vector<CsvColumn> gaps_columns(const casefile::Case& input, const RunResult& result)
{
    const auto times = history_times(input, result);
    auto columns = gap_columns(result.gaps, [&](const Series& series, double factor, double offset) {
        return sampled(result.thermal.time, series, times, factor, offset);
    });
    if (!columns.empty())
        columns.insert(columns.begin(), csv_column(schema::time, times));
    return columns;
}

std::vector<double> in_hours(const std::vector<double>& seconds)
{
    std::vector<double> hours;
    for (const double s : seconds)
        hours.push_back(s / 3600);
    return hours;
}

Chart temperature_chart(const casefile::Case& input, const RunResult& result)
{
    Chart chart;
    chart.title = input.machine.name + ": temperature rise of the probes";
    chart.subtitle = input.machine.description;
    chart.x_label = "time [h]";
    chart.y_label = "rise [K]";
    const auto times = history_times(input, result);
    for (const auto& [name, course] : result.probes) {
        ChartSeries series;
        series.name = name;
        series.x = in_hours(times);
        series.y = sampled(result.thermal.time, course, times, 1, -input.machine.initial_temperature);
        if (input.reference) {
            const auto found = input.reference->rises.find(name);
            if (found != input.reference->rises.end() && input.reference->time <= times.back() * 1.0001)
                series.markers.push_back({input.reference->time / 3600, found->second});
        }
        chart.series.push_back(std::move(series));
    }
    if (input.reference)
        chart.marker_note = input.reference->source;
    return chart;
}

Chart drift_chart(const casefile::Case& input, const RunResult& result)
{
    Chart chart;
    chart.title = input.machine.name + ": dimension chain at bottom dead point";
    chart.subtitle = "E_SW is the gap between slide and table; above zero it opens";
    chart.x_label = "time [h]";
    chart.y_label = "change [um]";
    const auto times = history_times(input, result);
    for (const auto& [name, data] : dimensions(*result.drift)) {
        ChartSeries series;
        series.name = name;
        series.x = in_hours(times);
        series.y = sampled(result.drift->time, *data, times, micrometre, 0);
        series.emphasised = data == &result.drift->gap;
        chart.series.push_back(std::move(series));
    }
    return chart;
}

Chart contribution_chart(const casefile::Case& input, const RunResult& result)
{
    constexpr std::size_t shown = 6;
    Chart chart;
    chart.title = input.machine.name + ": which part moves the gap";
    chart.subtitle = "shares of E_SW by the part that warms; the shares of all parts sum to E_SW";
    chart.x_label = "time [h]";
    chart.y_label = "share of E_SW [um]";
    const auto times = history_times(input, result);
    const auto order = strongest_parts(*result.drift);
    std::vector<double> rest(times.size(), 0.0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto y = sampled_linear(result.drift->time, result.drift->by_part[order[i]], times, micrometre, 0);
        if (i < shown) {
            ChartSeries series;
            series.name = result.parts[order[i]].name;
            series.x = in_hours(times);
            series.y = y;
            chart.series.push_back(std::move(series));
        } else {
            for (std::size_t k = 0; k < y.size(); ++k)
                rest[k] += y[k];
        }
    }
    if (order.size() > shown) {
        ChartSeries series;
        series.name = "all others";
        series.x = in_hours(times);
        series.y = rest;
        series.dashed = true;
        chart.series.push_back(std::move(series));
    }
    return chart;
}

nlohmann::ordered_json rises_json(const casefile::Case& input, const RunResult& result)
{
    nlohmann::ordered_json json;
    const double end = result.thermal.time.back();
    std::vector<std::pair<std::string, double>> times;
    for (const double elapsed : {0.5, 1.0, 2.0, 3.0})
        if (elapsed * hour < end * (1 - 1e-9))
            times.emplace_back(fmt::format("{} h", elapsed), elapsed * hour);
    times.emplace_back("end", end);
    for (std::size_t i = 0; i < result.probes.size(); ++i)
        for (const auto& [name, time] : times)
            json[result.probes[i].name][name] = press::rise_at(input, result, i, time);
    return json;
}

nlohmann::ordered_json model_json(const casefile::Case& input, const Machine& machine, const RunResult& result)
{
    return {{"cells", result.cells},
            {"heat_unknowns", result.heat_unknowns},
            {"deformation_cells", result.deformation_cells},
            {"deformation_unknowns", result.deformation_unknowns},
            {"element_order", input.numerics.order},
            {"second_order_parts", std::ranges::count(press::describe_orders(input, machine), 2)},
            {"half_model", machine.half_model},
            {"ranks", result.ranks}};
}

nlohmann::ordered_json energy_json(const casefile::Case& input, const RunResult& result)
{
    const auto& energy = result.thermal.energy;
    const double factor = result.symmetry_factor;
    nlohmann::ordered_json json{
        {"generated", factor * energy.generated}, {"from_surfaces", factor * energy.from_surfaces},
        {"to_air", factor * energy.to_air},       {"to_oil", factor * energy.to_oil},
        {"stored", factor * energy.stored},       {"relative_mismatch", energy.mismatch()}};
    if (nothing_happens(result.thermal, input.numerics.time_tolerance))
        json["relative_mismatch"] = nullptr;
    return json;
}

nlohmann::ordered_json drift_json(const RunResult& result, const press::RunSummary& summary)
{
    nlohmann::ordered_json json{{"largest_E_SW", micrometre * summary.largest_gap},
                                {"time_of_largest_s", summary.largest_gap_time},
                                {"final_E_SW", micrometre * summary.final_gap}};
    for (const auto& [name, series] : dimensions(*result.drift))
        json["final"][name] = micrometre * series->value.back();
    for (const auto part : strongest_parts(*result.drift))
        json["final_by_part"][result.parts[part].name] = micrometre * result.drift->by_part[part].back();
    if (!result.causes.empty())
        json["by_cause"] = drift_causes_json(result.causes);
    return json;
}

nlohmann::ordered_json reference_json(const casefile::Reference& reference, const press::RunSummary& summary)
{
    nlohmann::ordered_json json;
    for (const auto& row : summary.comparison)
        json["rises_K"][row.probe] = {{"computed", row.rise}, {"reference", row.reference}};
    json["time_s"] = reference.time;
    json["source"] = reference.source;
    json["rms_residual_K"] = summary.rms_residual;
    json["rms_null_K"] = summary.rms_null;
    json["calibrated_on"] = reference.calibrated_on;
    return json;
}

nlohmann::ordered_json error_json(const press::StatedError& error)
{
    return {{"of", error.of}, {"temperature_K", error.temperature}, {"E_SW_um", micrometre * error.gap}};
}

nlohmann::ordered_json certified_json(const press::Certified& certified)
{
    nlohmann::ordered_json json;
    if (!certified.refused.empty())
        json["refused"] = certified.refused;
    if (certified.gap)
        json["E_SW_um"] = micrometre * *certified.gap;
    for (const auto& [name, bound] : certified.probes)
        json["probes_K"][name] = bound;
    return json;
}

nlohmann::ordered_json reduced_json(const press::ReducedResult& reduced)
{
    nlohmann::ordered_json json{{"model", reduced.file}, {"states", reduced.states}};
    if (reduced.estimate)
        json["estimate"] = error_json(*reduced.estimate);
    if (reduced.full_run)
        json["full_run"] = error_json(*reduced.full_run);
    if (reduced.certified)
        json["certified"] = certified_json(*reduced.certified);
    for (const auto& error : reduced.errors)
        json["errors"].push_back(error_json(error));
    if (!reduced.outside.empty())
        json["outside"] = reduced.outside;
    return json;
}

/// How the run was computed, and its time and memory.
void add_solution(const casefile::Case& input, const Machine& machine, const RunResult& result,
                  nlohmann::ordered_json& json)
{
    const auto& history = result.thermal;
    json["model"] = model_json(input, machine, result);
    json["solution"] = {{"steps", history.time.size() - 1},
                        {"rejected_steps", history.rejected_steps},
                        {"heat_solves", history.linear_solves},
                        {"heat_iterations", history.linear_iterations},
                        {"deformation_iterations", result.elastic_iterations}};
    for (const auto& [stage, seconds] : result.timings)
        json["timings_s"][stage] = seconds;
    json["peak_memory_bytes"] = result.peak_memory;
    if (result.accuracy)
        json["accuracy"] = accuracy_json(*result.accuracy);
    if (result.reduced)
        json["reduced"] = reduced_json(*result.reduced);
    if (result.sensitivities)
        json["sensitivities"] = sensitivities_json(*result.sensitivities);
}

/// Dimension chain, friction, frame and the check of the adjoints, as far as the case has them.
void add_machine(const casefile::Case& input, const RunResult& result, const press::RunSummary& summary,
                 nlohmann::ordered_json& json)
{
    if (result.drift) {
        json["drift_um"] = drift_json(result, summary);
        if (const auto gaps = gaps_json(result.gaps, result.thermal.time); !gaps.is_null())
            json["gaps"] = gaps;
        if (result.compliance)
            json["static_opening"] = compliance_json(input, *result.compliance);
        json["warm_up_s"] = summary.warm_up_time ? nlohmann::ordered_json(*summary.warm_up_time) : nullptr;
    }
    json["drift_summary"] = drift_summary_json(press::names_of(result.probes), summary);
    if (!result.friction.empty())
        json["friction"] = friction_json(result.friction);
    if (result.frame)
        json["frame"] = frame_json(*result.frame, result.thermal.time);
    if (const auto& check = result.adjoint_check)
        json["adjoint_check"] = {{"time_s", check->time},
                                 {"E_SW_um_by_adjoint", micrometre * check->by_adjoint},
                                 {"E_SW_um_by_deformation", micrometre * check->by_deformation},
                                 {"largest_joint_opening_um", micrometre * check->joint_opening}};
}

nlohmann::ordered_json summary_json(const casefile::Case& input, const Machine& machine, const RunResult& result,
                                    const std::vector<std::string>& warnings)
{
    const auto summary = press::summarise(input, result);
    nlohmann::ordered_json json;
    json["version"] = version;
    json["case"] = {{"name", input.machine.name}, {"hash", casefile::case_hash(input)}};
    json["interrupted"] = result.thermal.interrupted;
    json["initial_temperature_degC"] = input.machine.initial_temperature - zero_celsius;
    json["warnings"] = warnings;
    add_solution(input, machine, result, json);
    json["energy_J"] = energy_json(input, result);
    if (const auto flows = heat_flows_json(result); !flows.is_null())
        json["heat_flows_at_end"] = flows;
    json["probe_rises_K"] = rises_json(input, result);
    for (std::size_t i = 0; i < result.probes.size(); ++i)
        json["time_to_95_percent_s"][result.probes[i].name] = summary.time_to_95[i];
    add_machine(input, result, summary, json);
    if (input.reference)
        json["reference"] = reference_json(*input.reference, summary);
    json["left_out"] = {"oil-film thinning in plain bearings", "inertial stretch of the links",
                        "elastic moduli that depend on temperature"};
    return json;
}

}  // namespace

std::vector<std::string> file_comments(const casefile::Case& input, const std::vector<std::string>& warnings)
{
    std::vector<std::string> lines{fmt::format("deadpoint {}", version),
                                   fmt::format("case {}, hash {}", input.machine.name, casefile::case_hash(input))};
    for (const auto& warning : warnings)
        lines.push_back("warning: " + warning);
    return lines;
}

std::vector<RunTable> course_tables(const casefile::Case& input, const RunResult& result)
{
    std::vector<RunTable> tables{{"history.csv", history_columns(input, result)}};
    if (!result.drift)
        return tables;
    tables.push_back({"contributions.csv", contribution_columns(input, result)});
    if (auto gaps = gaps_columns(input, result); !gaps.empty())
        tables.push_back({"gaps.csv", std::move(gaps)});
    return tables;
}

std::string summary_text(const casefile::Case& input, const Machine& machine, const RunResult& result,
                         const std::vector<std::string>& warnings)
{
    return summary_json(input, machine, result, warnings).dump();
}

void write_run_files(const std::filesystem::path& folder, const casefile::Case& input, const Machine& machine,
                     const RunResult& result, const std::vector<std::string>& warnings)
{
    const auto comments = head(input, result, warnings);
    std::string resolved;
    for (const auto& line : comments)
        resolved += "# " + one_line(line) + "\n";
    resolved += casefile::write_case(input);
    write_file(folder / "case.toml", [&](std::ostream& out) { out << resolved; });
    for (const auto& table : course_tables(input, result))
        write_table(folder / table.file, comments, table.columns);
    if (result.loads)
        write_loads_files(folder, input, *result.loads, warnings);
    write_json(folder / "summary.json", summary_json(input, machine, result, warnings));
    if (result.frame && !result.frame->stress.empty())
        write_stress(folder / "stress.csv", *result.frame, comments);
    if (result.sensitivities)
        write_sensitivities(folder / "sensitivities.csv", comments, *result.sensitivities);
    if (result.accuracy)
        write_accuracy_files(folder, *result.accuracy, comments);
    if (result.view)
        write_json(folder / "view.json", view_json(input, machine, *result.view));
    write_svg_chart(folder / "temperatures.svg", temperature_chart(input, result), comments);
    if (result.drift) {
        if (!result.causes.empty())
            write_drift_causes(folder / "causes.csv", comments, result.causes);
        write_svg_chart(folder / "drift.svg", drift_chart(input, result), comments);
        write_svg_chart(folder / "contributions.svg", contribution_chart(input, result), comments);
    }
}

}  // namespace deadpoint::report
