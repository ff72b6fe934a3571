#include "deadpoint/tribology/friction/duty.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/tribology/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::tribology {
namespace {

double power(double base, double exponent) { return exponent == 0 ? 1 : std::pow(base, exponent); }

void check_lengths(const CycleHistory& turn, const JointCycle& joint)
{
    const std::size_t count = turn.time.size();
    if (joint.force.size() != count || joint.sliding.size() != count)
        throw InputError(fmt::format("duty of a joint: {} times, {} forces and {} sliding speeds; give as many of each",
                                     count, joint.force.size(), joint.sliding.size()));
}

std::vector<double> magnitudes(const std::vector<double>& values)
{
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](double value) { return std::abs(value); });
    return result;
}

std::vector<double> magnitudes(const std::vector<Vec2>& values)
{
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](const Vec2& value) { return norm(value); });
    return result;
}

}  // namespace

std::vector<double> turn_weights(const std::vector<double>& time, double period)
{
    require_positive("period of the turn [s]", period);
    const std::size_t count = time.size();
    if (count == 0)
        throw InputError("duty over the turn: there are no samples");
    std::vector<double> weight(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double next = i + 1 < count ? time[i + 1] : time.front() + period;
        const double gap = next - time[i];
        if (!(gap > 0) || !std::isfinite(gap))
            throw InputError(
                fmt::format("duty over the turn: the time {} s after {} s is not later\n  help: times must "
                            "increase and stay within one period of {} s",
                            next, time[i], period));
        weight[i] += gap / (2 * period);
        weight[(i + 1) % count] += gap / (2 * period);
    }
    return weight;
}

Duty steady_duty(double force, double speed)
{
    Duty duty{{1.0}, {std::abs(force)}, {std::abs(speed)}};
    check(duty);
    return duty;
}

Duty duty_of(const CycleHistory& turn, const JointCycle& joint)
{
    check_lengths(turn, joint);
    Duty duty{turn_weights(turn.time, turn.period), magnitudes(joint.force), magnitudes(joint.sliding)};
    check(duty);
    return duty;
}

double guide_normal_force(const GuideFaces& guide, double force, double moment)
{
    const double couple = guide.length ? moment / *guide.length : 0;
    return std::max(guide.preload, std::abs(force / 2 + couple)) +
           std::max(guide.preload, std::abs(force / 2 - couple));
}

SideForces guide_side_forces(const GuideFaces& guide, double force, double moment)
{
    const double couple = guide.length ? moment / *guide.length : 0;
    SideForces sides;
    for (const double end : {force / 2 + couple, force / 2 - couple}) {
        const double pressed = std::max(guide.preload, std::abs(end));
        sides.plus += (pressed + end) / 2;
        sides.minus += (pressed - end) / 2;
    }
    return sides;
}

Duty guide_duty(const CycleHistory& turn, const JointCycle& joint, const GuideFaces& guide)
{
    require_not_negative("preload of a guide [N]", guide.preload);
    if (guide.length)
        require_positive("length of a guide [m]", *guide.length);
    Duty duty = duty_of(turn, joint);
    if (joint.moment.size() != duty.force.size())
        throw InputError(fmt::format("duty of a guide: {} forces, but {} moments; give as many of each",
                                     duty.force.size(), joint.moment.size()));
    for (std::size_t i = 0; i < duty.force.size(); ++i)
        duty.force[i] = guide_normal_force(guide, duty.force[i], joint.moment[i]);
    check(duty);
    return duty;
}

Duty duty_of(const BearingCycle& bearing, double speed)
{
    const std::size_t count = bearing.force.size();
    if (count == 0)
        throw InputError(fmt::format("duty of bearing '{}': there are no samples of its force", bearing.name));
    Duty duty{std::vector<double>(count, 1.0 / static_cast<double>(count)), magnitudes(bearing.force),
              std::vector<double>(count, std::abs(speed))};
    check(duty);
    return duty;
}

Duty measured(Duty duty, LoadMeasure measure)
{
    if (measure == LoadMeasure::peak)
        duty.force.assign(duty.force.size(), peak_force(duty));
    return duty;
}

Duty shared(Duty duty, double share)
{
    require_not_negative("share of a joint's force", share);
    for (double& force : duty.force)
        force *= share;
    return duty;
}

double duty_mean(const Duty& duty, double load_exponent, double speed_exponent)
{
    check(duty);
    require_not_negative("exponent of the load", load_exponent);
    require_not_negative("exponent of the speed", speed_exponent);
    double mean = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i)
        mean += duty.weight[i] * power(duty.force[i], load_exponent) * power(duty.speed[i], speed_exponent);
    return mean;
}

double peak_force(const Duty& duty)
{
    check(duty);
    return *std::max_element(duty.force.begin(), duty.force.end());
}

void check(const Duty& duty)
{
    const std::size_t count = duty.weight.size();
    if (count == 0 || duty.force.size() != count || duty.speed.size() != count)
        throw InputError(fmt::format("duty: {} weights, {} forces and {} speeds; give as many of each, one at least",
                                     count, duty.force.size(), duty.speed.size()));
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto wrong = [](double value) { return !(value >= 0) || !std::isfinite(value); };
        if (wrong(duty.weight[i]) || wrong(duty.force[i]) || wrong(duty.speed[i]))
            throw InputError(
                fmt::format("duty: sample {} has weight {}, force {} N and speed {}; each must be finite and "
                            "not negative",
                            i, duty.weight[i], duty.force[i], duty.speed[i]));
        sum += duty.weight[i];
    }
    if (std::abs(sum - 1) > 1e-9)
        throw InputError(fmt::format("duty: the weights add up to {}, not to one turn", sum));
}

}  // namespace deadpoint::tribology
