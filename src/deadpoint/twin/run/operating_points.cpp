#include "deadpoint/twin/run/operating_points.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/run/quiet_observer.hpp"

namespace deadpoint::twin {
namespace {

constexpr int drawn_points = 20;
constexpr unsigned long long point_seed = 5;

struct OperatingFactors {
    double speed = 1, force = 1;
};

bool is_held(const Span& span) { return span.from == 1 && span.to == 1; }

std::vector<OperatingFactors> factors_in(const Span& speed, const Span& force)
{
    std::vector<OperatingFactors> result;
    if (is_held(speed) && is_held(force))
        return result;
    for (const double at : {speed.from, speed.to})
        for (const double with : {force.from, force.to})
            result.push_back({at, with});
    reduce::Draws draws(point_seed);
    const auto drawn = [&](const Span& span) { return span.from + (span.to - span.from) * draws.next(); };
    for (int k = 0; k < drawn_points; ++k) {
        const double at = drawn(speed);
        result.push_back({at, drawn(force)});
    }
    return result;
}

}  // namespace

std::vector<SplitProblem> other_operation(const casefile::Case& input, const Machine& machine, const FreeRanges& ranges,
                                          const Observer& observer)
{
    Silent silent(observer);  // warnings would speak of cases that nobody has written
    Stopwatch watch(silent);
    press::LoadsCache loads;
    std::vector<SplitProblem> result;
    for (const auto& [speed, force] : factors_in(ranges.speed, ranges.force)) {
        auto other = input;
        for (auto& segment : other.operation) {
            segment.speed *= speed;
            segment.force *= force;
        }
        press::RunResult unused;
        result.push_back(split_by_part(
            press::run_laws(other, machine, press::Vibration::left_out, watch, unused, silent, &loads), machine));
    }
    return result;
}

std::vector<HeatProblem> with_heat_of(const HeatProblem& problem, const std::vector<SplitProblem>& others)
{
    std::vector<HeatProblem> result{problem};
    for (const auto& other : others) {
        auto point = problem;
        for (std::size_t k = 0; k < point.segments.size(); ++k) {
            const auto& from = other.problem.segments[k];
            auto& to = point.segments[k];
            to.heat = from.heat;
            to.ring_heat = from.ring_heat;
            to.zoned_heat = from.zoned_heat;
        }
        result.push_back(std::move(point));
    }
    return result;
}

}  // namespace deadpoint::twin
