#include "deadpoint/report/loads/loads_files.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/loads/loads_charts.hpp"
#include "deadpoint/report/mesh/view_file.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <tuple>

namespace deadpoint::report {
namespace {

using press::LoadsResult;
using Json = nlohmann::ordered_json;

Json pair(const Vec2& v) { return {v[0], v[1]}; }

// Time means of a history whose samples need not be evenly spaced (trapezoid over the closed turn).
struct Means {
    double mean = 0, rms = 0, peak = 0;
};
Means means(const CycleHistory& history, const std::vector<double>& values)
{
    Means result;
    double total = 0;
    const std::size_t count = values.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double next = i + 1 < count ? history.time[i + 1] : history.time.front() + history.period;
        const double before = i > 0 ? history.time[i - 1] : history.time.back() - history.period;
        const double span = 0.5 * (next - before);
        total += span;
        result.mean += span * values[i];
        result.rms += span * values[i] * values[i];
        result.peak = std::max(result.peak, std::abs(values[i]));
    }
    result.mean /= total;
    result.rms = std::sqrt(result.rms / total);
    return result;
}

Json joint_json(const LoadsResult& loads, std::size_t j)
{
    const auto& joint = loads.linkage.joints[j];
    const auto& cycle = loads.history.joints[j];
    std::vector<double> force, x, y, sliding, work;
    for (std::size_t i = 0; i < cycle.force.size(); ++i) {
        force.push_back(norm(cycle.force[i]));
        x.push_back(cycle.force[i][0]);
        y.push_back(cycle.force[i][1]);
        sliding.push_back(std::abs(cycle.sliding[i]));
        work.push_back(force.back() * sliding.back());
    }
    const auto magnitude = means(loads.history, force);
    const bool slide = joint.kind == LinkageJoint::Kind::slide;
    Json json;
    json["kind"] = slide ? "slide" : "revolute";
    json["body_a"] = loads.linkage.bodies[static_cast<std::size_t>(joint.body_a)];
    json["body_b"] = loads.linkage.bodies[static_cast<std::size_t>(joint.body_b)];
    json["image"] = static_cast<bool>(loads.images[j]);
    json["force_N"] = {{"peak", magnitude.peak},
                       {"mean", magnitude.mean},
                       {"rms", magnitude.rms},
                       {"peak_x", means(loads.history, x).peak},
                       {"peak_y", means(loads.history, y).peak},
                       {"at_bottom_x", x.front()},
                       {"at_bottom_y", y.front()}};
    if (slide)
        json["peak_moment_N_m"] = means(loads.history, cycle.moment).peak;
    json[slide ? "mean_sliding_speed_m_per_s" : "mean_sliding_speed_rad_per_s"] = means(loads.history, sliding).mean;
    json[slide ? "mean_force_times_speed_W" : "mean_force_times_speed_N_rad_per_s"] = means(loads.history, work).mean;
    return json;
}

Json bearing_json(const BearingCycle& b)
{
    return {{"peak_N", b.peak},
            {"peak_x_N", b.peak_x_y[0]},
            {"peak_y_N", b.peak_x_y[1]},
            {"mean_N", pair(b.mean)},
            {"mean_magnitude_N", b.mean_magnitude},
            {"rms_N", b.rms},
            {"mean_F_to_1.33_N1.33", b.mean_rolling_load}};
}

Json bearings_json(const std::vector<BearingCycle>& bearings)
{
    Json json = Json::object();
    for (const auto& b : bearings)
        json[b.name] = bearing_json(b);
    return json;
}

Json modes_json(const std::vector<crankshaft::Mode>& modes)
{
    Json list = Json::array();
    for (const auto& mode : modes)
        list.push_back({{"frequency_Hz", mode.frequency},
                        {"whirl", whirl_name(mode.whirl)},
                        {"damping_ratio_of_bearings", mode.damping_ratio}});
    return list;
}

Json crankshaft_json(const press::CrankshaftLoads& shaft)
{
    Json json;
    json["model"] = shaft.model;
    json["modal_damping"] = shaft.shaft.modal_damping;
    json["belt_force_N"] = shaft.belt_force;
    for (const auto& [name, cycle, seats] :
         {std::tuple{"rigid", &shaft.rigid, &shaft.by_seat.rigid},
          std::tuple{"flexible", shaft.flexible ? &*shaft.flexible : nullptr, &shaft.by_seat.flexible}}) {
        if (!cycle)
            continue;
        json[name]["bearings"] = bearings_json(cycle->bearings);
        json[name]["seats"] = bearings_json(*seats);
        if (cycle == &shaft.cycle() && shaft.flexible)
            json[name]["stiffness_over_given"] = cycle->stiffness_factor;
    }
    for (std::size_t b = 0; b < shaft.sag.bearing_force.size(); ++b)
        json["static"]["bearing_force_N"][shaft.shaft.bearings[b].name] = pair(shaft.sag.bearing_force[b]);
    double sag = 0;
    for (const auto& d : shaft.sag.deflection)
        sag = std::max(sag, norm(d));
    json["static"]["largest_deflection_um"] = micrometre * sag;
    json["static"]["position_mm"] = Json::array();
    json["static"]["deflection_um"] = Json::array();
    for (std::size_t i = 0; i < shaft.sag.nodes.size(); ++i) {
        json["static"]["position_mm"].push_back(1e3 * shaft.sag.nodes[i]);
        json["static"]["deflection_um"].push_back(pair(micrometre * shaft.sag.deflection[i]));
    }
    json["modes_at_speed"] = modes_json(shaft.modes);
    json["critical_speeds"] = Json::array();
    for (const auto& critical : shaft.critical_speeds)
        json["critical_speeds"].push_back({{"speed_rpm", rpm * critical.speed}, {"whirl", whirl_name(critical.whirl)}});
    double unbalance = 0;
    for (std::size_t i = 0; i < shaft.unbalance.x.size(); ++i)
        unbalance = std::max(unbalance, std::hypot(std::abs(shaft.unbalance.x[i]), std::abs(shaft.unbalance.y[i])));
    json["unbalance_response_at_speed"]["largest_deflection_um"] = micrometre * unbalance;
    for (std::size_t b = 0; b < shaft.unbalance.bearing_x.size(); ++b)
        json["unbalance_response_at_speed"]["bearing_force_amplitude_N"][shaft.shaft.bearings[b].name] = {
            std::abs(shaft.unbalance.bearing_x[b]), std::abs(shaft.unbalance.bearing_y[b])};
    return json;
}

Json slide_json(const LoadsResult& loads)
{
    const auto& s = loads.stroke;
    return {{"stroke_mm", 1e3 * s.stroke},
            {"bottom_dead_point_deg", degrees * s.bottom_dead_point},
            {"crank_angle_at_bottom_dead_point_deg", degrees * loads.throw_at_bottom},
            {"top_dead_point_deg", degrees * s.top_dead_point},
            {"dwell_within_10_um_share_of_turn", s.dwell_10um},
            {"dwell_within_100_um_share_of_turn", s.dwell_100um},
            {"largest_speed_m_per_s", s.largest_speed},
            {"largest_acceleration_m_per_s2", s.largest_acceleration}};
}

// Mechanical advantage at a few crank angles before bottom dead point, as presses state it.
Json advantage_json(const LoadsResult& loads)
{
    Json list = Json::array();
    for (const double before : {30.0, 20.0, 10.0, 5.0, 2.0}) {
        const mechanism::ForceRatio* best = nullptr;
        for (const auto& ratio : loads.force_ratios)
            if (!best ||
                std::abs(degrees * ratio.past_bottom + before) < std::abs(degrees * best->past_bottom + before))
                best = &ratio;
        if (best)
            list.push_back({{"past_bottom_dead_point_deg", degrees * best->past_bottom},
                            {"height_mm", 1e3 * best->height},
                            {"slide_force_over_pin_force", best->advantage},
                            {"slide_force_over_torque_1_per_m", best->force_by_torque}});
    }
    return list;
}

Json loads_json(const casefile::Case& input, const LoadsResult& loads, const std::vector<std::string>& warnings)
{
    Json json;
    json["version"] = version;
    json["case"] = {{"name", input.machine.name}, {"hash", casefile::case_hash(input)}};
    json["warnings"] = warnings;
    json["conventions"] = "x right, y up; angles past bottom dead point of the crank, which turns counter-clockwise; a "
                          "joint's force acts on body_a by body_b; a bearing's force acts on the bearing by the shaft; "
                          "pairs are [x, y]";
    json["operation"] = {{"segment", loads.segment},
                         {"speed_rpm", rpm * loads.speed},
                         {"mean_speed_rpm", rpm * 2 * std::numbers::pi / loads.history.period},
                         {"process_force_kind", loads.process_force},
                         {"process_force_peak_N", loads.force}};
    json["slide"] = slide_json(loads);
    json["mechanical_advantage"] = advantage_json(loads);
    json["drive"] = {{"peak_torque_N_m", loads.drive.peak_torque},
                     {"mean_torque_N_m", loads.drive.mean_torque},
                     {"rms_torque_N_m", loads.drive.rms_torque},
                     {"mean_power_W", loads.drive.mean_power}};
    for (std::size_t b = 0; b < loads.masses.size(); ++b)
        if (static_cast<int>(b) != loads.linkage.ground)
            json["bodies"][loads.linkage.bodies[b]] = {{"mass_kg", loads.masses[b].mass},
                                                       {"centre_of_mass_m", pair(loads.masses[b].centre)},
                                                       {"inertia_kg_m2", loads.masses[b].inertia},
                                                       {"from", loads.mass_origins[b]}};
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        json["joints"][loads.linkage.joints[j].name] = joint_json(loads, j);
    for (const auto& guide : loads.guides) {
        auto& entry = json["guides"][loads.linkage.joints[static_cast<std::size_t>(guide.joint)].name];
        entry = {{"preload_per_face_N", guide.faces.preload},
                 {"mean_normal_force_N", guide.mean_normal},
                 {"peak_moment_N_m", guide.peak_moment},
                 {"balanced_by_symmetry", guide.balanced}};
        if (guide.faces.length)
            entry["guide_length_mm"] = 1e3 * *guide.faces.length;
    }
    json["guides_whose_rotation_the_halves_hold"] = loads.freed_guides;
    json["height_by_length"] = Json::array();
    for (const auto& length : loads.lengths)
        json["height_by_length"].push_back({{"body", length.body},
                                            {"from", length.from},
                                            {"to", length.to},
                                            {"length_mm", 1e3 * length.length},
                                            {"slide_height_by_length", length.height_by_length}});
    if (loads.crankshaft)
        json["crankshaft"] = crankshaft_json(*loads.crankshaft);
    for (const auto& [stage, seconds] : loads.timings)
        json["timings_s"][stage] = seconds;
    return json;
}

std::vector<std::string> head(const casefile::Case& input, const LoadsResult& loads,
                              const std::vector<std::string>& warnings)
{
    std::vector<std::string> lines{fmt::format("deadpoint {}", version),
                                   fmt::format("case {}, hash {}", input.machine.name, casefile::case_hash(input)),
                                   fmt::format("segment {}: {:g} rpm, {:g} N ({})", loads.segment, rpm * loads.speed,
                                               loads.force, loads.process_force)};
    for (const auto& warning : warnings)
        lines.push_back("warning: " + warning);
    return lines;
}

std::vector<double> part(const std::vector<Vec2>& values, std::size_t index)
{
    std::vector<double> result;
    for (const auto& v : values)
        result.push_back(v[index]);
    return result;
}

std::vector<double> past_bottom(const std::vector<double>& angle)
{
    std::vector<double> result;
    for (const double a : angle)
        result.push_back(degrees * (a - angle.front()));
    return result;
}

void write_joints(const std::filesystem::path& path, const LoadsResult& loads, const std::vector<std::string>& comments)
{
    const auto& h = loads.history;
    namespace table = schema::joints;
    std::vector<CsvColumn> columns{csv_column(schema::past_bottom, past_bottom(h.angle)),
                                   csv_column(schema::turn_time, h.time),
                                   csv_column(table::speed, h.speed),
                                   csv_column(table::height, h.height),
                                   csv_column(table::slide_speed, h.slide_speed),
                                   csv_column(table::acceleration, h.slide_acceleration),
                                   csv_column(table::process_force, h.process_force),
                                   csv_column(table::torque, h.drive_torque)};
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j) {
        const auto& joint = loads.linkage.joints[j];
        const bool slide = joint.kind == LinkageJoint::Kind::slide;
        columns.push_back(csv_column(table::force_x, part(h.joints[j].force, 0), joint.name));
        columns.push_back(csv_column(table::force_y, part(h.joints[j].force, 1), joint.name));
        if (slide)
            columns.push_back(csv_column(table::moment, h.joints[j].moment, joint.name));
        columns.push_back(csv_column(slide ? table::sliding : table::turning, h.joints[j].sliding, joint.name));
    }
    write_table(path, comments, columns);
}

void add_bearings(std::vector<CsvColumn>& columns, const std::vector<BearingCycle>& bearings, const schema::Column& x,
                  const schema::Column& y)
{
    for (const auto& b : bearings) {
        columns.push_back(csv_column(x, part(b.force, 0), b.name));
        columns.push_back(csv_column(y, part(b.force, 1), b.name));
    }
}

void write_bearings(const std::filesystem::path& path, const LoadsResult& loads,
                    const std::vector<std::string>& comments)
{
    const auto& shaft = *loads.crankshaft;
    std::vector<double> angle;
    for (const double a : throw_angles(shaft))
        angle.push_back(degrees * (a - shaft.loads.throw_angle.front()));
    namespace table = schema::bearings;
    std::vector<CsvColumn> columns{csv_column(schema::past_bottom, angle),
                                   csv_column(schema::turn_time, shaft.cycle().time)};
    add_bearings(columns, shaft.rigid.bearings, table::rigid_x, table::rigid_y);
    if (shaft.flexible)
        add_bearings(columns, shaft.flexible->bearings, table::flexible_x, table::flexible_y);
    columns.push_back(csv_column(table::pin_x, part(shaft.cycle().pin_deflection, 0)));
    columns.push_back(csv_column(table::pin_y, part(shaft.cycle().pin_deflection, 1)));
    write_table(path, comments, columns);
}

void write_campbell(const std::filesystem::path& path, const press::CrankshaftLoads& shaft,
                    const std::vector<std::string>& comments)
{
    std::vector<double> speed, number, frequency, damping;
    std::vector<std::string> whirl;
    for (std::size_t i = 0; i < shaft.campbell_speeds.size(); ++i)
        for (std::size_t m = 0; m < shaft.campbell[i].size(); ++m) {
            const auto& mode = shaft.campbell[i][m];
            speed.push_back(rpm * shaft.campbell_speeds[i]);
            number.push_back(static_cast<double>(m + 1));
            frequency.push_back(mode.frequency);
            damping.push_back(mode.damping_ratio);
            whirl.emplace_back(whirl_name(mode.whirl));
        }
    namespace table = schema::campbell;
    const std::vector<CsvColumn> columns{csv_column(table::speed, speed), csv_column(table::mode, number),
                                         csv_column(table::frequency, frequency), csv_column(table::whirl, whirl),
                                         csv_column(table::damping, damping)};
    write_table(path, comments, columns);
}

void write_svg(const std::filesystem::path& path, const std::string& svg, const std::vector<std::string>& comments)
{
    write_file(path, svg_comments(comments) + svg);
}

}  // namespace

void write_loads_files(const std::filesystem::path& folder, const casefile::Case& input, const LoadsResult& loads,
                       const std::vector<std::string>& warnings)
{
    const auto comments = head(input, loads, warnings);
    const auto& name = input.machine.name;
    write_json(folder / "loads.json", loads_json(input, loads, warnings));
    write_json(folder / "motion.json", motion_json(loads));
    write_joints(folder / "joints.csv", loads, comments);
    write_svg(folder / "slide.svg", slide_motion_svg(name, loads), comments);
    write_svg(folder / "joints.svg", joint_forces_svg(name, loads), comments);
    write_svg(folder / "linkage.svg", linkage_svg(name, loads), comments);
    if (!loads.crankshaft)
        return;
    write_bearings(folder / "bearings.csv", loads, comments);
    write_campbell(folder / "campbell.csv", *loads.crankshaft, comments);
    write_svg(folder / "bearings.svg", bearing_loads_svg(name, loads), comments);
    write_svg(folder / "campbell.svg", campbell_svg(name, loads), comments);
}

}  // namespace deadpoint::report
