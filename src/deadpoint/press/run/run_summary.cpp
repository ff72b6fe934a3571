#include "deadpoint/press/run/run_summary.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::press {

double rise_at(const casefile::Case& input, const RunResult& result, std::size_t probe, double time)
{
    return interpolate(result.thermal.time, result.probes[probe].history, time) - input.machine.initial_temperature;
}

namespace {

std::optional<double> warm_up_time(const casefile::Case& input, const DriftSeries& drift)
{
    if (!input.chain || !(input.chain->drift_rate_limit > 0))
        return std::nullopt;
    return steady_from(drift.time, drift.gap, input.chain->drift_rate_limit);
}

}  // namespace

GapFigures gap_figures(const casefile::Case& input, const DriftSeries& drift)
{
    const auto course = summarise_course(drift.time, drift.gap);
    return {course.first_hour.change, course.range, warm_up_time(input, drift)};
}

RunSummary summarise(const casefile::Case& input, const RunResult& result)
{
    RunSummary summary;
    const auto& history = result.thermal;
    const double end = history.time.back();
    if (input.reference) {
        const double at = std::min(input.reference->time, end);
        double residual = 0, null = 0;
        for (std::size_t i = 0; i < result.probes.size(); ++i) {
            const auto found = input.reference->rises.find(result.probes[i].name);
            if (found == input.reference->rises.end())
                continue;
            const ProbeComparison row{result.probes[i].name, rise_at(input, result, i, at), found->second};
            residual += (row.rise - row.reference) * (row.rise - row.reference);
            null += row.reference * row.reference;
            summary.comparison.push_back(row);
        }
        const double count = std::max<double>(1, static_cast<double>(summary.comparison.size()));
        summary.rms_residual = std::sqrt(residual / count);
        summary.rms_null = std::sqrt(null / count);
    }
    constexpr int rise_samples = 2000;
    for (std::size_t i = 0; i < result.probes.size(); ++i) {
        std::vector<double> times, rises;
        for (int k = 0; k <= rise_samples; ++k) {
            times.push_back(end * k / rise_samples);
            rises.push_back(rise_at(input, result, i, times.back()));
        }
        summary.time_to_95.push_back(time_to_share(times, rises, 0.95));
        summary.probe_courses.push_back(summarise_course(history.time, result.probes[i].history));
    }
    if (!result.drift)
        return summary;
    const auto& drift = *result.drift;
    constexpr int samples = 5000;
    for (int k = 0; k <= samples; ++k) {
        const double time = end * k / samples;
        const double value = interpolate(drift.time, drift.gap, time);
        if (std::abs(value) > std::abs(summary.largest_gap)) {
            summary.largest_gap = value;
            summary.largest_gap_time = time;
        }
    }
    summary.final_gap = drift.gap.value.back();
    summary.gap_course = summarise_course(drift.time, drift.gap);
    summary.warm_up_time = warm_up_time(input, drift);
    return summary;
}

}  // namespace deadpoint::press
