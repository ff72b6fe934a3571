#include "deadpoint/crankshaft/cycle.hpp"

#include "deadpoint/crankshaft/response/load_channels.hpp"
#include "deadpoint/crankshaft/response/periodic.hpp"
#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/shaft/check.hpp"
#include "deadpoint/crankshaft/shaft/shaft_loads.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/laws/friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::crankshaft {
namespace {

constexpr double smallest_load = 0.01;  ///< of the reference load, for stiffness that depends on load
constexpr double settled = 1e-10;
constexpr int most_rounds = 100;

Vec2 mean_of(const std::vector<Vec2>& values)
{
    Vec2 sum{};
    for (const Vec2& value : values)
        sum = sum + value;
    return (1.0 / static_cast<double>(values.size())) * sum;
}

void check_on_shaft(const Shaft& shaft, const ShaftLoads& loads)
{
    const double end = shaft_end(shaft);
    const double tolerance = 1e-6 * (end - shaft.start);
    for (const double position : load_positions(loads))
        if (!(position >= shaft.start - tolerance && position <= end + tolerance))
            throw InputError(
                fmt::format("crankshaft loads: a load at {:g} mm is not on the shaft, which runs from {:g} "
                            "to {:g} mm",
                            1e3 * position, 1e3 * shaft.start, 1e3 * end));
}

/// A force at a place along the shaft.
struct PlacedForce {
    double position;
    Vec2 force;
};

/// Weight and steady forces.
std::vector<PlacedForce> constant_forces(const Shaft& shaft, const ShaftLoads& loads)
{
    std::vector<PlacedForce> forces;
    double begin = shaft.start;
    for (const Section& section : shaft.sections) {
        forces.push_back({begin + 0.5 * section.length, section_mass(section) * loads.gravity});
        begin += section.length;
    }
    for (const Disk& disk : shaft.disks)
        forces.push_back({disk.position, disk.mass * loads.gravity});
    for (const SteadyForce& steady : loads.steady)
        forces.push_back({steady.position, steady.force});
    return forces;
}

/// The pin if bearings lie on both sides of it, else the middle of the widest gap between bearings.
double dividing_position(const Shaft& shaft, double pin)
{
    std::vector<double> positions;
    for (const Bearing& bearing : shaft.bearings)
        positions.push_back(bearing.position);
    std::sort(positions.begin(), positions.end());
    if (positions.front() <= pin && pin < positions.back())
        return pin;
    std::size_t widest = 1;
    for (std::size_t i = 1; i < positions.size(); ++i)
        if (positions[i] - positions[i - 1] > positions[widest] - positions[widest - 1])
            widest = i;
    return 0.5 * (positions[widest - 1] + positions[widest]);
}

/// The two seats of a rigid shaft.
struct Seats {
    std::vector<int> of_bearing;
    std::array<double, 2> at{};  ///< mean positions
    std::array<int, 2> count{};

    Seats(const Shaft& shaft, double pin) : of_bearing(seats_of(shaft, pin))
    {
        for (std::size_t b = 0; b < of_bearing.size(); ++b) {
            const auto seat = static_cast<std::size_t>(of_bearing[b]);
            at[seat] += shaft.bearings[b].position;
            ++count[seat];
        }
        for (std::size_t seat = 0; seat < 2; ++seat)
            at[seat] /= count[seat];
    }
};

/// Constant channel, pin x and y, unbalance at the throw's angle x and y.
PeriodicLoad channels(const Shaft& shaft, const ShaftLoads& loads, const TurnLoads& turn, const ShaftSystem& system)
{
    PeriodicLoad load{loads.period, Matrix(system.size(), 5), Matrix(loads.samples, 5)};
    const std::vector<double> weight = weight_pattern(system, loads.gravity);
    const Matrix pin = force_pattern(system, loads.pin_position, loads.pin_width);
    for (int i = 0; i < system.size(); ++i) {
        load.patterns(i, 0) = weight[static_cast<std::size_t>(i)];
        load.patterns(i, 1) = pin(i, 0);
        load.patterns(i, 2) = pin(i, 1);
    }
    for (const SteadyForce& steady : loads.steady) {
        const int first = first_unknown(node_at(system, steady.position));
        load.patterns(first, 0) += steady.force[0];
        load.patterns(first + 1, 0) += steady.force[1];
    }
    for (const Unbalance& unbalance : unbalances_of(shaft)) {
        const int first = first_unknown(node_at(system, unbalance.position));
        for (int channel = 0; channel < 2; ++channel) {
            const Vec2 force = force_of(unbalance, channel == 0 ? Vec2{1, 0} : Vec2{0, 1});
            load.patterns(first, 3 + channel) += force[0];
            load.patterns(first + 1, 3 + channel) += force[1];
        }
    }
    for (int n = 0; n < loads.samples; ++n) {
        const auto at = static_cast<std::size_t>(n);
        load.histories(n, 0) = 1;
        load.histories(n, 1) = turn.pin_force[at][0];
        load.histories(n, 2) = turn.pin_force[at][1];
        load.histories(n, 3) = turn.unbalance[at][0];
        load.histories(n, 4) = turn.unbalance[at][1];
    }
    return load;
}

std::vector<double> mean_load(const PeriodicLoad& load)
{
    std::vector<double> mean(static_cast<std::size_t>(load.patterns.rows));
    for (int channel = 0; channel < load.histories.cols; ++channel) {
        double sum = 0;
        for (int n = 0; n < load.histories.rows; ++n)
            sum += load.histories(n, channel);
        for (int i = 0; i < load.patterns.rows; ++i)
            mean[static_cast<std::size_t>(i)] += load.patterns(i, channel) * sum / load.histories.rows;
    }
    return mean;
}

/// Force on every bearing by the shaft (x, y), then the displacement of the pin's centre (x, y).
Readings readings_of(const ShaftSystem& system, double pin_position)
{
    const int bearings = static_cast<int>(system.bearings.size());
    Readings readings{Matrix(2 * bearings + 2, system.size()), Matrix(2 * bearings + 2, system.size())};
    for (int b = 0; b < bearings; ++b) {
        const BearingSeat& seat = system.bearings[static_cast<std::size_t>(b)];
        const int first = first_unknown(seat.node);
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j) {
                const double k = seat.stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
                const double c = seat.damping[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
                readings.displacement(2 * b + i, first + j) = k;
                readings.velocity(2 * b + i, first + j) = c;
                if (seat.housing >= 0) {
                    readings.displacement(2 * b + i, seat.housing + j) = -k;
                    readings.velocity(2 * b + i, seat.housing + j) = -c;
                }
            }
    }
    const int pin = first_unknown(node_at(system, pin_position));
    readings.displacement(2 * bearings, pin) = 1;
    readings.displacement(2 * bearings + 1, pin + 1) = 1;
    return readings;
}

Matrix2 scaled(const Matrix2& m, double factor)
{
    return {{{factor * m[0][0], factor * m[0][1]}, {factor * m[1][0], factor * m[1][1]}}};
}

Shaft with_factors(Shaft shaft, const std::vector<double>& factors)
{
    for (std::size_t b = 0; b < shaft.bearings.size(); ++b)
        shaft.bearings[b].stiffness = scaled(shaft.bearings[b].stiffness, factors[b]);
    return shaft;
}

/// The assembled shaft with every bearing's stiffness at its mean load.
struct Settled {
    ShaftSystem system;
    PeriodicLoad load;
    std::vector<double> factors;
    std::vector<double> displacement;  ///< under the mean load
    std::vector<Warning> warnings;
};

/// Tangent stiffness factors for forces; dF/dd = n K^(1/n) F^((n-1)/n) of F = K d^n.
std::vector<double> factors_at(const Shaft& shaft, const std::vector<Vec2>& forces)
{
    std::vector<double> factors;
    for (std::size_t b = 0; b < shaft.bearings.size(); ++b) {
        const Bearing& bearing = shaft.bearings[b];
        const double n = bearing.hertz_exponent;
        const double share = n == 1 ? 1.0 : std::max(norm(forces[b]) / bearing.reference_load, smallest_load);
        factors.push_back(std::pow(share, (n - 1) / n));
    }
    return factors;
}

void warn_of_small_loads(Settled& state, const Shaft& shaft)
{
    const std::vector<Vec2> forces = bearing_forces(state.system, state.displacement);
    for (std::size_t b = 0; b < shaft.bearings.size(); ++b) {
        const Bearing& bearing = shaft.bearings[b];
        if (bearing.hertz_exponent != 1 && norm(forces[b]) < smallest_load * bearing.reference_load)
            state.warnings.push_back(
                {"stiffness of bearing " + bearing.name,
                 fmt::format(
                     "crankshaft: bearing '{}' carries {:.3g} N on average, less than 1 % of the load at which its "
                     "stiffness was given; the stiffness at 1 % is used",
                     bearing.name, norm(forces[b]))});
    }
}

Settled settle(const Shaft& shaft, const ShaftLoads& loads, const TurnLoads& turn)
{
    const std::vector<double> positions = load_positions(loads);
    Settled state;
    state.factors.assign(shaft.bearings.size(), 1.0);
    double change = 0;
    for (int round = 0; round < most_rounds; ++round) {
        state.system = assemble(with_factors(shaft, state.factors), positions);
        if (round == 0)
            state.load = channels(shaft, loads, turn, state.system);
        state.displacement = static_displacement(state.system, mean_load(state.load));
        const std::vector<double> next = factors_at(shaft, bearing_forces(state.system, state.displacement));
        change = 0;
        for (std::size_t b = 0; b < next.size(); ++b)
            change = std::max(change, std::abs(next[b] / state.factors[b] - 1));
        if (change <= settled) {
            warn_of_small_loads(state, shaft);
            return state;
        }
        state.factors = next;
    }
    throw ConvergenceError(
        fmt::format("crankshaft: the stiffness of its bearings at their mean load still changes by "
                    "{:.3g} after {} rounds\n  help: give the stiffness at a load nearer to the mean",
                    change, most_rounds));
}

}  // namespace

BearingCycle summarise(std::string name, std::vector<Vec2> force)
{
    if (force.empty())
        throw DomainError(fmt::format("bearing '{}' has no force to summarise", name));
    BearingCycle cycle;
    for (const Vec2& f : force) {
        const double magnitude = norm(f);
        if (!std::isfinite(magnitude))
            throw DomainError(fmt::format("the force on bearing '{}' is not finite", name));
        cycle.peak = std::max(cycle.peak, magnitude);
        for (std::size_t i = 0; i < 2; ++i)
            cycle.peak_x_y[i] = std::max(cycle.peak_x_y[i], std::abs(f[i]));
        cycle.mean_magnitude += magnitude;
        cycle.rms += magnitude * magnitude;
        cycle.mean_rolling_load += std::pow(magnitude, rolling_load_exponent);
    }
    const double count = static_cast<double>(force.size());
    cycle.mean = mean_of(force);
    cycle.mean_magnitude /= count;
    cycle.rms = std::sqrt(cycle.rms / count);
    cycle.mean_rolling_load /= count;
    cycle.name = std::move(name);
    cycle.force = std::move(force);
    return cycle;
}

std::vector<int> seats_of(const Shaft& shaft, double pin_position)
{
    check_shaft(shaft);
    const double divide = dividing_position(shaft, pin_position);
    std::vector<int> seats;
    for (const Bearing& bearing : shaft.bearings)
        seats.push_back(bearing.position > divide ? 1 : 0);
    return seats;
}

std::array<BearingCycle, 2> seat_cycles(const ShaftCycle& cycle, const std::vector<int>& seats)
{
    if (seats.size() != cycle.bearings.size())
        throw InputError(
            fmt::format("crankshaft: {} seats are given for {} bearings", seats.size(), cycle.bearings.size()));
    std::array<std::vector<Vec2>, 2> forces;
    std::array<std::string, 2> names;
    forces.fill(std::vector<Vec2>(cycle.time.size()));
    for (std::size_t b = 0; b < seats.size(); ++b) {
        const auto seat = static_cast<std::size_t>(seats[b] == 0 ? 0 : 1);
        names[seat] += (names[seat].empty() ? "" : " + ") + cycle.bearings[b].name;
        for (std::size_t n = 0; n < cycle.time.size(); ++n)
            forces[seat][n] = forces[seat][n] + cycle.bearings[b].force[n];
    }
    return {summarise(names[0], std::move(forces[0])), summarise(names[1], std::move(forces[1]))};
}

ShaftCycle rigid_cycle(const Shaft& shaft, const ShaftLoads& loads)
{
    check_shaft(shaft);
    const TurnLoads turn = resample(loads);
    check_on_shaft(shaft, loads);
    const Seats seats(shaft, loads.pin_position);
    const std::vector<PlacedForce> constant = constant_forces(shaft, loads);
    const std::vector<Unbalance> unbalances = unbalances_of(shaft);
    std::vector<std::vector<Vec2>> forces(shaft.bearings.size());
    for (std::size_t n = 0; n < turn.time.size(); ++n) {
        std::vector<PlacedForce> acting = constant;
        acting.push_back({loads.pin_position, turn.pin_force[n]});
        for (const Unbalance& unbalance : unbalances)
            acting.push_back({unbalance.position, force_of(unbalance, turn.unbalance[n])});
        Vec2 total{};
        Vec2 second{};
        for (const PlacedForce& placed : acting) {
            total = total + placed.force;
            second = second + ((placed.position - seats.at[0]) / (seats.at[1] - seats.at[0])) * placed.force;
        }
        for (std::size_t b = 0; b < forces.size(); ++b)
            forces[b].push_back(seats.of_bearing[b] == 1 ? (1.0 / seats.count[1]) * second
                                                         : (1.0 / seats.count[0]) * (total - second));
    }
    ShaftCycle cycle;
    cycle.speed = turn.speed;
    cycle.time = turn.time;
    for (std::size_t b = 0; b < forces.size(); ++b)
        cycle.bearings.push_back(summarise(shaft.bearings[b].name, std::move(forces[b])));
    cycle.pin_deflection.assign(turn.time.size(), Vec2{});
    cycle.stiffness_factor.assign(shaft.bearings.size(), 1.0);
    return cycle;
}

ShaftCycle flexible_cycle(const Shaft& shaft, const ShaftLoads& loads, const PeriodicSettings& settings)
{
    check_shaft(shaft);
    const TurnLoads turn = resample(loads);
    check_on_shaft(shaft, loads);
    Settled state = settle(shaft, loads, turn);
    const Matrix read = periodic_response(state.system, turn.speed, state.load,
                                          readings_of(state.system, loads.pin_position), settings);
    const auto column = [&read](int first) {
        std::vector<Vec2> values;
        for (int n = 0; n < read.rows; ++n)
            values.push_back({read(n, first), read(n, first + 1)});
        return values;
    };
    ShaftCycle cycle;
    cycle.speed = turn.speed;
    cycle.time = turn.time;
    const int bearings = static_cast<int>(shaft.bearings.size());
    for (int b = 0; b < bearings; ++b)
        cycle.bearings.push_back(summarise(shaft.bearings[static_cast<std::size_t>(b)].name, column(2 * b)));
    cycle.pin_deflection = column(2 * bearings);
    cycle.stiffness_factor = std::move(state.factors);
    cycle.warnings = std::move(state.warnings);
    return cycle;
}

StaticState static_state(const Shaft& shaft, const ShaftLoads& loads)
{
    check_shaft(shaft);
    const TurnLoads turn = resample(loads);
    check_on_shaft(shaft, loads);
    const Settled state = settle(shaft, loads, turn);
    StaticState result{state.system.nodes, {}, bearing_forces(state.system, state.displacement)};
    for (std::size_t node = 0; node < state.system.nodes.size(); ++node) {
        const auto first = static_cast<std::size_t>(first_unknown(static_cast<int>(node)));
        result.deflection.push_back({state.displacement[first], state.displacement[first + 1]});
    }
    return result;
}

Shaft with_stiffness(Shaft shaft, const ShaftCycle& cycle)
{
    if (cycle.stiffness_factor.size() != shaft.bearings.size())
        throw InputError(fmt::format("crankshaft: the cycle is of a shaft with {} bearings, this one has {}",
                                     cycle.stiffness_factor.size(), shaft.bearings.size()));
    shaft = with_factors(std::move(shaft), cycle.stiffness_factor);
    for (Bearing& bearing : shaft.bearings)
        bearing.hertz_exponent = 1;
    return shaft;
}

}  // namespace deadpoint::crankshaft
