#include "deadpoint/crankshaft/response/load_channels.hpp"

#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/crankshaft/shaft/shaft_loads.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

constexpr double turn = 2 * std::numbers::pi;

void require(bool holds, const std::string& message)
{
    if (!holds)
        throw InputError("crankshaft loads: " + message);
}

bool finite(const Vec2& v) { return std::isfinite(v[0]) && std::isfinite(v[1]); }

void check(const ShaftLoads& loads)
{
    const std::size_t count = loads.time.size();
    require(count >= 3, fmt::format("{} times over the turn are too few\n  help: give at least 3", count));
    require(loads.throw_angle.size() == count && loads.pin_force.size() == count,
            fmt::format("{} times, but {} angles and {} pin forces\n  help: give one of each per time", count,
                        loads.throw_angle.size(), loads.pin_force.size()));
    require(loads.samples >= 3, fmt::format("{} samples over the turn are too few", loads.samples));
    require(loads.period > 0 && std::isfinite(loads.period),
            fmt::format("the period must be positive, not {:g} s", loads.period));
    require(loads.pin_width >= 0 && std::isfinite(loads.pin_width) && std::isfinite(loads.pin_position),
            fmt::format("the crank pin at {:g} m has the width {:g} m", loads.pin_position, loads.pin_width));
    require(finite(loads.gravity), "gravity is not finite");
    for (const SteadyForce& steady : loads.steady)
        require(finite(steady.force) && std::isfinite(steady.position), "a steady force is not finite");
    const double sense = loads.throw_angle.back() > loads.throw_angle.front() ? 1 : -1;
    for (std::size_t i = 0; i < count; ++i) {
        require(finite(loads.pin_force[i]) && std::isfinite(loads.time[i]) && std::isfinite(loads.throw_angle[i]),
                fmt::format("entry {} over the turn is not finite", i + 1));
        require(i == 0 || loads.time[i] > loads.time[i - 1], fmt::format("time does not ascend at entry {}", i + 1));
        require(i == 0 || sense * (loads.throw_angle[i] - loads.throw_angle[i - 1]) > 0,
                fmt::format("the crank turns back at entry {}\n  help: the angle must run on without jumps", i + 1));
    }
    require(loads.time.back() - loads.time.front() < loads.period,
            "the times span a whole period or more\n  help: leave out the last, which is the first of the next turn");
    require(std::abs(loads.throw_angle.back() - loads.throw_angle.front()) < turn,
            "the crank turns further than once in a period");
}

/// Series continued beyond both ends by one entry, as it repeats.
struct Continued {
    std::vector<double> time;
    std::vector<double> angle;
    std::vector<Vec2> pin_force;

    Continued(const ShaftLoads& loads, double sense)
        : time(loads.time), angle(loads.throw_angle), pin_force(loads.pin_force)
    {
        time.insert(time.begin(), loads.time.back() - loads.period);
        time.push_back(loads.time.front() + loads.period);
        angle.insert(angle.begin(), loads.throw_angle.back() - sense * turn);
        angle.push_back(loads.throw_angle.front() + sense * turn);
        pin_force.insert(pin_force.begin(), loads.pin_force.back());
        pin_force.push_back(loads.pin_force.front());
    }
};

struct Rate {
    double speed = 0;
    double acceleration = 0;
};

/// Slope and curvature of the parabola through an entry and its neighbours.
Rate rate_at(const Continued& series, std::size_t i)
{
    const double before = series.time[i] - series.time[i - 1];
    const double after = series.time[i + 1] - series.time[i];
    const double slope_before = (series.angle[i] - series.angle[i - 1]) / before;
    const double slope_after = (series.angle[i + 1] - series.angle[i]) / after;
    return {(after * slope_before + before * slope_after) / (before + after),
            2 * (slope_after - slope_before) / (before + after)};
}

}  // namespace

std::vector<double> load_positions(const ShaftLoads& loads)
{
    std::vector<double> positions{loads.pin_position};
    if (loads.pin_width > 0) {
        positions.push_back(loads.pin_position - 0.5 * loads.pin_width);
        positions.push_back(loads.pin_position + 0.5 * loads.pin_width);
    }
    for (const SteadyForce& steady : loads.steady)
        positions.push_back(steady.position);
    return positions;
}

TurnLoads resample(const ShaftLoads& loads)
{
    check(loads);
    const double sense = loads.throw_angle.back() > loads.throw_angle.front() ? 1 : -1;
    const Continued series(loads, sense);
    std::vector<Rate> rates(series.time.size());
    for (std::size_t i = 1; i + 1 < rates.size(); ++i)
        rates[i] = rate_at(series, i);
    rates.front() = rates[rates.size() - 2];
    rates.back() = rates[1];

    TurnLoads result;
    result.speed = sense * turn / loads.period;
    std::size_t i = 1;  // the interval i .. i+1 holds the time
    for (int n = 0; n < loads.samples; ++n) {
        const double time = loads.time.front() + loads.period * n / loads.samples;
        while (i + 2 < series.time.size() && series.time[i + 1] <= time)
            ++i;
        const double part = (time - series.time[i]) / (series.time[i + 1] - series.time[i]);
        const auto between = [part](double a, double b) { return a + part * (b - a); };
        const double angle = between(series.angle[i], series.angle[i + 1]);
        const double speed = between(rates[i].speed, rates[i + 1].speed);
        const double acceleration = between(rates[i].acceleration, rates[i + 1].acceleration);
        const Vec2 outward{std::cos(angle), std::sin(angle)};
        const Vec2 along{-outward[1], outward[0]};
        result.time.push_back(time);
        result.pin_force.push_back(series.pin_force[i] + part * (series.pin_force[i + 1] - series.pin_force[i]));
        result.unbalance.push_back(speed * speed * outward - acceleration * along);
    }
    return result;
}

std::vector<Unbalance> unbalances_of(const Shaft& shaft)
{
    std::vector<Unbalance> all = shaft.unbalances;
    for (const Disk& disk : shaft.disks)
        all.push_back({disk.position, disk.unbalance, disk.unbalance_angle});
    return all;
}

Vec2 force_of(const Unbalance& unbalance, const Vec2& at_throw)
{
    const double c = unbalance.magnitude * std::cos(unbalance.angle);
    const double s = unbalance.magnitude * std::sin(unbalance.angle);
    return {c * at_throw[0] - s * at_throw[1], s * at_throw[0] + c * at_throw[1]};
}

}  // namespace deadpoint::crankshaft
