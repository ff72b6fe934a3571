#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/crankshaft/cycle.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/loads/loads_charts.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using press::LoadsResult;

std::string in_kilonewtons(double newton) { return newton < 1e-6 ? "0" : significant(newton / 1e3, 4); }

std::string joints_table(const LoadsResult& loads)
{
    TextTable table({"joint", "kind", "peak [kN]", "x", "y"});
    table.align_left(1);
    for (const auto j : joints_by_peak(loads)) {
        const auto& joint = loads.linkage.joints[j];
        Vec2 peak{};
        for (const auto& force : loads.history.joints[j].force)
            for (std::size_t i = 0; i < 2; ++i)
                peak[i] = std::max(peak[i], std::abs(force[i]));
        table.add_row({joint.name, joint.kind == LinkageJoint::Kind::slide ? "slide" : "revolute",
                       in_kilonewtons(peak_force(loads.history.joints[j])), in_kilonewtons(peak[0]),
                       in_kilonewtons(peak[1])});
    }
    return table.text();
}

std::string seats_table(const press::CrankshaftLoads& shaft)
{
    TextTable table({"crankshaft bearing", "model", "peak [kN]", "x", "y", "mean", "rms"});
    table.align_left(1);
    const auto add = [&](const char* model, const std::vector<BearingCycle>& seats) {
        for (const auto& seat : seats)
            table.add_row({seat.name, model, in_kilonewtons(seat.peak), in_kilonewtons(seat.peak_x_y[0]),
                           in_kilonewtons(seat.peak_x_y[1]), in_kilonewtons(seat.mean_magnitude),
                           in_kilonewtons(seat.rms)});
    };
    add("rigid", shaft.by_seat.rigid);
    add("flexible", shaft.by_seat.flexible);
    return table.text();
}

std::string frequencies(const press::CrankshaftLoads& shaft)
{
    std::string text;
    for (std::size_t m = 0; m < std::min<std::size_t>(4, shaft.modes.size()); ++m)
        text += fmt::format("{}{:.1f} ({})", m ? ", " : "", shaft.modes[m].frequency, whirl_name(shaft.modes[m].whirl));
    if (!shaft.critical_speeds.empty())
        text += fmt::format("; first critical speed {:.0f} rpm ({})", rpm * shaft.critical_speeds.front().speed,
                            whirl_name(shaft.critical_speeds.front().whirl));
    return text;
}

}  // namespace

std::string loads_text(const casefile::Case& input, const LoadsResult& loads)
{
    const auto& segment = input.operation[static_cast<std::size_t>(loads.segment)];
    std::string text = fmt::format("\n{}{}{}: {} rpm, {} kN ({})\n\n", input.machine.name,
                                   segment.name.empty() ? "" : ", ", segment.name, significant(rpm * loads.speed, 4),
                                   significant(loads.force / 1e3, 4), loads.process_force);
    text +=
        fmt::format("  stroke {:.3f} mm, bottom dead point with the crank at {:.3f} deg, top dead point {:.3f} deg "
                    "later\n",
                    1e3 * loads.stroke.stroke, degrees * loads.throw_at_bottom + (loads.throw_at_bottom < 0 ? 360 : 0),
                    degrees * (loads.stroke.top_dead_point - loads.stroke.bottom_dead_point));
    text += fmt::format("  slide up to {} m/s and {} m/s2; within 10 um of bottom dead point for {:.2f} % of the turn, "
                        "100 um {:.2f} %\n",
                        significant(loads.stroke.largest_speed), significant(loads.stroke.largest_acceleration),
                        100 * loads.stroke.dwell_10um, 100 * loads.stroke.dwell_100um);
    text += fmt::format("  drive torque {} N m peak, {} N m rms; mean power {} W\n\n",
                        significant(loads.drive.peak_torque, 4), significant(loads.drive.rms_torque, 4),
                        std::abs(loads.drive.mean_power) < 1e-9 * loads.drive.peak_torque * loads.speed
                            ? "0"
                            : significant(loads.drive.mean_power, 4));
    text += joints_table(loads);
    if (loads.crankshaft)
        text += fmt::format("\n{}  natural frequencies [Hz]: {}\n", seats_table(*loads.crankshaft),
                            frequencies(*loads.crankshaft));
    return text;
}

std::string loads_line(const LoadsResult& loads)
{
    const auto order = joints_by_peak(loads);
    std::string text = fmt::format("loads: stroke {:.2f} mm, largest joint force {} kN ({})", 1e3 * loads.stroke.stroke,
                                   significant(peak_force(loads.history.joints[order.front()]) / 1e3),
                                   loads.linkage.joints[order.front()].name);
    if (!loads.crankshaft)
        return text;
    for (const auto& seat : loads.crankshaft->seat_cycles())
        text += fmt::format(", bearing {} {} kN", seat.name, significant(seat.peak / 1e3));
    return text + fmt::format(" ({} crankshaft)", loads.crankshaft->model);
}

std::string linkage_plan_text(const casefile::Case& input)
{
    std::string text = input.machine.name.empty() ? "Plan" : input.machine.name;
    text += ": a linkage without parts; `deadpoint loads` computes its motion and forces\n\nBodies\n";
    TextTable bodies({"body", "mass [kg]", "remarks"});
    bodies.align_left(2);
    for (const auto& [name, body] : input.bodies)
        bodies.add_row({name, body.mass ? significant(*body.mass, 4) : "",
                        body.ground   ? "stands still"
                        : body.mirror ? "exists twice"
                                      : ""});
    text += bodies.text() + "\nJoints\n";
    TextTable joints({"joint", "kind", "between", "and", "x [mm]", "y"});
    for (const std::size_t left : {1, 2, 3})
        joints.align_left(left);
    for (const auto& [name, joint] : input.joints)
        joints.add_row({name, joint.driver ? "revolute, driver" : std::string(casefile::name_of(joint.kind)),
                        joint.bodies.at(0), joint.bodies.at(1), fmt::format("{:.3f}", 1e3 * joint.centre[0]),
                        fmt::format("{:.3f}", 1e3 * joint.centre[1])});
    text += joints.text() + "\nOperation\n";
    TextTable operation({"segment", "speed [rpm]", "force [kN]"});
    for (const auto& segment : input.operation)
        operation.add_row({segment.name, significant(rpm * segment.speed, 4), significant(segment.force / 1e3, 4)});
    return text + operation.text();
}

}  // namespace deadpoint::report
