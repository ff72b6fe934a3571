#include "deadpoint/press/drift/frame_courses.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/frame_result.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

// Recovered stress at the rim of a bond is no better than that.
constexpr double least_share = 0.02;

std::string clock(double seconds) { return fmt::format("{:.2f} h", seconds / 3600); }

double process_force(const casefile::Case& input, double time)
{
    double end = 0;
    for (const auto& segment : input.operation) {
        end += segment.duration;
        if (time <= end)
            return segment.force;
    }
    return 0;
}

void warn_about_rod(const casefile::Case& input, const std::vector<double>& times, const RodForce& rod,
                    Observer& observer)
{
    double worst = 0, at = 0, left = 0, needed = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double force = rod.start + rod.change.value[i];
        const double must = rod.held_share * process_force(input, times[i]);
        if (force - must < worst) {
            worst = force - must;
            at = times[i];
            left = force;
            needed = must;
        }
    }
    if (worst >= 0)
        return;
    observer.warn(needed > 0
                      ? fmt::format("preload.{}: rod '{}' has {:.1f} kN left at {}, less than the {:.1f} kN that "
                                    "it has to hold of the process force; it needs more preload",
                                    rod.preload, rod.part, 1e-3 * left, clock(at), 1e-3 * needed)
                      : fmt::format("preload.{}: rod '{}' comes loose: {:.1f} kN at {}; it needs more preload",
                                    rod.preload, rod.part, 1e-3 * left, clock(at)));
}

void warn_about_bond(const std::vector<double>& times, const ClosedBond& bond, Observer& observer)
{
    const auto highest = std::ranges::max_element(bond.change.value);
    const double resultant = bond.start + *highest;
    if (resultant > 0)
        observer.warn(fmt::format(
            "preload.{}: '{}' would open: {:.1f} kN pull its sides apart at {}; the computation keeps it closed",
            bond.preload, bond.name, 1e-3 * resultant,
            clock(times[static_cast<std::size_t>(highest - bond.change.value.begin())])));
    const auto worst = std::ranges::max_element(
        bond.openings, {}, [](const Opening& o) { return o.share > least_share ? o.largest : -1e300; });
    if (worst == bond.openings.end() || worst->share <= least_share)
        return;
    const auto& x = worst->place;
    observer.warn(fmt::format("preload.{}: '{}' would part over {:.0f} % of its area at {}, most at x = {:.0f}, y = "
                              "{:.0f}, z = {:.0f} mm ({:.2g} MPa of tension); the computation keeps it closed",
                              bond.preload, bond.name, 100 * worst->share, clock(worst->time), 1e3 * x[0], 1e3 * x[1],
                              1e3 * x[2], 1e-6 * worst->largest));
}

}  // namespace

void read_courses(const ThermalHistory& history, std::size_t first, FrameResult& result)
{
    for (auto& rod : result.rods)
        rod.change = history.functionals[first++];
    for (auto& bond : result.bonds)
        bond.change = history.functionals[first++];
}

void warn_about_frame(const casefile::Case& input, const ThermalHistory& history, const FrameResult& result,
                      Observer& observer)
{
    for (const auto& rod : result.rods)
        warn_about_rod(input, history.time, rod, observer);
    for (const auto& bond : result.bonds)
        warn_about_bond(history.time, bond, observer);
}

}  // namespace deadpoint::press
