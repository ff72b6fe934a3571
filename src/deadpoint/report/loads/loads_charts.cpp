#include "deadpoint/report/loads/loads_charts.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/crankshaft/cycle.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/loads/linkage_drawing.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::report {
namespace {

using press::LoadsResult;

constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t joints_shown = 6;
constexpr const char* angle_label = "crank angle past bottom dead point [deg]";

// A series over one turn with bottom dead point in the middle, its last point that of the first.
ChartSeries over_turn(std::string name, const std::vector<double>& angle, const std::vector<double>& values,
                      double factor)
{
    ChartSeries series;
    series.name = std::move(name);
    const std::size_t count = angle.size();
    if (count == 0)
        return series;
    std::size_t start = 0;
    while (start < count && angle[start] - angle.front() < std::numbers::pi - 1e-9)
        ++start;
    for (std::size_t k = 0; k <= count; ++k) {
        const std::size_t i = (start + k) % count;
        const double turns = start + k < count ? 1.0 : start + k < 2 * count ? 0.0 : -1.0;
        series.x.push_back((angle[i] - angle.front()) / degree - 360 * turns);
        series.y.push_back(factor * values[i]);
    }
    if (start == count)
        for (double& x : series.x)
            x -= 360;
    return series;
}

Chart chart_of(std::string title, std::string subtitle, std::string y_label, double height = 480)
{
    Chart chart;
    chart.title = std::move(title);
    chart.subtitle = std::move(subtitle);
    chart.x_label = angle_label;
    chart.y_label = std::move(y_label);
    chart.height = height;
    chart.x_step = 45;
    return chart;
}

// Charts one above the other in one document.
std::string stacked(std::vector<Chart> charts)
{
    double width = 0, height = 0;
    std::string inside;
    std::size_t letters = 0;
    for (const auto& chart : charts)
        for (const auto& series : chart.series)
            letters = std::max(letters, display_width(series.name));
    for (auto& chart : charts) {
        chart.name_letters = static_cast<int>(letters);
        std::string svg = svg_chart(chart);
        svg.replace(0, 4, fmt::format("<svg x=\"0\" y=\"{:g}\"", height));
        inside += svg;
        width = std::max(width, chart.width);
        height += chart.height;
    }
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} "
                       "{1:g}\">\n{2}</svg>\n",
                       width, height, inside);
}

std::string operation_text(const LoadsResult& loads)
{
    std::string text = fmt::format("{} rpm", significant(loads.speed * 30 / std::numbers::pi, 4));
    return loads.force > 0 ? text + fmt::format(", {} kN ({})", significant(loads.force / 1e3, 4), loads.process_force)
                           : text + ", no load";
}

const press::CrankshaftLoads& crankshaft_of(const LoadsResult& loads)
{
    if (!loads.crankshaft)
        throw InputError("the case has no [crankshaft]: there are no bearing loads to draw");
    return *loads.crankshaft;
}

std::vector<double> component(const BearingCycle& bearing, std::size_t index)
{
    std::vector<double> values;
    for (const auto& force : bearing.force)
        values.push_back(force[index]);
    return values;
}

Chart seat_chart(const LoadsResult& loads, std::size_t component_index, std::string title, std::string subtitle)
{
    const auto& shaft = crankshaft_of(loads);
    const auto angles = throw_angles(shaft);
    auto chart = chart_of(std::move(title), std::move(subtitle), "force on the bearing [kN]", 400);
    const int seats = static_cast<int>(shaft.seats.size());
    for (int s = 0; shaft.flexible && s < seats; ++s) {
        const auto& seat = shaft.by_seat.rigid[static_cast<std::size_t>(s)];
        auto series = over_turn(seat.name + ", rigid", angles, component(seat, component_index), 1e-3);
        series.dashed = true;
        series.colour = seats + s;
        chart.series.push_back(std::move(series));
    }
    for (int s = 0; s < seats; ++s) {
        const auto& seat = shaft.seat_cycles()[static_cast<std::size_t>(s)];
        chart.series.push_back(over_turn(seat.name, angles, component(seat, component_index), 1e-3));
        chart.series.back().colour = s;
    }
    return chart;
}

std::size_t index_at(const CycleHistory& history, double past)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < history.angle.size(); ++i)
        if (std::abs(history.angle[i] - history.angle.front() - past) <
            std::abs(history.angle[best] - history.angle.front() - past))
            best = i;
    return best;
}

}  // namespace

std::vector<double> throw_angles(const press::CrankshaftLoads& shaft)
{
    std::vector<double> result;
    const auto& given = shaft.loads;
    std::size_t k = 0;
    for (const double time : shaft.cycle().time) {
        while (k + 1 < given.time.size() && given.time[k + 1] <= time)
            ++k;
        const bool last = k + 1 == given.time.size();
        const double end = last ? given.period + given.time.front() : given.time[k + 1];
        const double angle_end = last ? given.throw_angle.front() + 2 * std::numbers::pi : given.throw_angle[k + 1];
        result.push_back(given.throw_angle[k] +
                         (angle_end - given.throw_angle[k]) * (time - given.time[k]) / (end - given.time[k]));
    }
    return result;
}

const char* whirl_name(crankshaft::Whirl whirl)
{
    switch (whirl) {
    case crankshaft::Whirl::forward:
        return "forward";
    case crankshaft::Whirl::backward:
        return "backward";
    default:
        return "planar";
    }
}

double peak_force(const JointCycle& joint)
{
    double peak = 0;
    for (const auto& force : joint.force)
        peak = std::max(peak, norm(force));
    return peak;
}

std::vector<std::size_t> joints_by_peak(const LoadsResult& loads)
{
    std::vector<std::size_t> order;
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (!loads.images[j])
            order.push_back(j);
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t j) { return peak_force(loads.history.joints[j]); });
    return order;
}

std::string slide_motion_svg(const std::string& machine, const LoadsResult& loads)
{
    const auto& history = loads.history;
    auto height = chart_of(machine + ": motion of the slide", operation_text(loads), "height [mm]", 330);
    height.series.push_back(over_turn("height", history.angle, history.height, 1e3));
    auto speed = chart_of("", "", "speed [m/s]", 260);
    speed.series.push_back(over_turn("speed", history.angle, history.slide_speed, 1));
    auto acceleration = chart_of("", "", "acceleration [m/s2]", 260);
    acceleration.series.push_back(over_turn("acceleration", history.angle, history.slide_acceleration, 1));
    return stacked({height, speed, acceleration});
}

std::string joint_forces_svg(const std::string& machine, const LoadsResult& loads)
{
    const auto& history = loads.history;
    auto chart = chart_of(machine + ": joint forces", operation_text(loads) + "; the largest by peak, magnitudes",
                          "force [kN]", 460);
    const auto order = joints_by_peak(loads);
    for (std::size_t k = 0; k < std::min(joints_shown, order.size()); ++k) {
        std::vector<double> values;
        for (const auto& force : history.joints[order[k]].force)
            values.push_back(norm(force));
        chart.series.push_back(over_turn(loads.linkage.joints[order[k]].name, history.angle, values, 1e-3));
    }
    auto torque = chart_of("", "", "drive torque [N m]", 270);
    torque.series.push_back(over_turn("drive torque", history.angle, history.drive_torque, 1));
    return stacked({chart, torque});
}

std::string bearing_loads_svg(const std::string& machine, const LoadsResult& loads)
{
    const auto& shaft = crankshaft_of(loads);
    const std::string subtitle =
        operation_text(loads) + (shaft.flexible ? "; flexible crankshaft, the rigid one dashed" : "; rigid crankshaft");
    return stacked({seat_chart(loads, 0, machine + ": crankshaft bearings, x", subtitle),
                    seat_chart(loads, 1, machine + ": crankshaft bearings, y", subtitle)});
}

std::string campbell_svg(const std::string& machine, const LoadsResult& loads)
{
    const auto& shaft = crankshaft_of(loads);
    Chart chart;
    chart.title = machine + ": natural frequencies of the turning crankshaft";
    chart.subtitle =
        fmt::format("runs at {} rpm; 1x: once per turn", significant(loads.speed * 30 / std::numbers::pi, 4));
    chart.x_label = "speed [rpm]";
    chart.y_label = "frequency [Hz]";
    std::vector<double> rpm;
    for (const double speed : shaft.campbell_speeds)
        rpm.push_back(speed * 30 / std::numbers::pi);
    const double limit = 4 * std::max(shaft.campbell.front().front().frequency, rpm.back() / 60 / 4);
    for (std::size_t m = 0; m < shaft.campbell.front().size(); ++m) {
        if (shaft.campbell.front()[m].frequency > limit)
            break;
        ChartSeries series;
        series.name = fmt::format("{} {}", m + 1, whirl_name(shaft.campbell.back().at(m).whirl));
        series.dashed = shaft.campbell.back()[m].whirl == crankshaft::Whirl::backward;
        for (std::size_t i = 0; i < rpm.size(); ++i)
            if (m < shaft.campbell[i].size()) {
                series.x.push_back(rpm[i]);
                series.y.push_back(shaft.campbell[i][m].frequency);
            }
        chart.series.push_back(std::move(series));
    }
    ChartSeries once;
    once.name = "1x";
    once.emphasised = true;
    once.colour = 6;
    once.x = {0, rpm.back()};
    once.y = {0, rpm.back() / 60};
    for (const auto& critical : shaft.critical_speeds)
        if (critical.speed <= shaft.campbell_speeds.back())
            once.markers.push_back({critical.speed * 30 / std::numbers::pi, critical.speed / (2 * std::numbers::pi)});
    if (!once.markers.empty())
        chart.marker_note = "critical speeds";
    chart.series.push_back(std::move(once));
    return svg_chart(chart);
}

std::string linkage_svg(const std::string& machine, const LoadsResult& loads)
{
    std::vector<std::size_t> positions;
    for (const double degrees : {0.0, 60.0, 120.0, 180.0, 270.0})
        positions.push_back(index_at(loads.history, degrees * degree));
    return linkage_drawing(machine + ": linkage", loads.linkage, loads.history, positions);
}

}  // namespace deadpoint::report
