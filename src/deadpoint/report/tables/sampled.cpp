#include "deadpoint/report/tables/sampled.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace deadpoint::report {

std::vector<double> history_times(const casefile::Case& input, const press::RunResult& result)
{
    const double end = result.thermal.time.back();
    std::vector<double> times;
    const double interval = input.output.history_interval;
    const auto count = static_cast<long long>(std::floor(end / interval * (1 + 1e-12)));
    for (long long i = 0; i <= count; ++i)
        times.push_back(static_cast<double>(i) * interval);
    if (end - times.back() > 1e-6 * interval)
        times.push_back(end);
    return times;
}

std::vector<double> sampled(const std::vector<double>& steps, const Series& series, const std::vector<double>& times,
                            double factor, double offset)
{
    std::vector<double> values;
    values.reserve(times.size());
    for (const double time : times)
        values.push_back(factor * interpolate(steps, series, time) + offset);
    return values;
}

std::vector<double> sampled_linear(const std::vector<double>& steps, const std::vector<double>& values,
                                   const std::vector<double>& times, double factor, double offset)
{
    std::vector<double> result;
    for (const double time : times) {
        const auto upper = std::upper_bound(steps.begin(), steps.end(), time);
        if (upper == steps.end()) {
            result.push_back(factor * values.back() + offset);
            continue;
        }
        const auto k = static_cast<std::size_t>(upper - steps.begin());
        const double s = k == 0 ? 0 : (time - steps[k - 1]) / (steps[k] - steps[k - 1]);
        result.push_back(factor * (k == 0 ? values[0] : (1 - s) * values[k - 1] + s * values[k]) + offset);
    }
    return result;
}

std::vector<std::pair<const char*, const Series*>> dimensions(const DriftSeries& drift)
{
    const std::array series{&drift.gap, &drift.bearing_to_ground, &drift.table_to_ground, &drift.crank_to_slide,
                            &drift.clearance};
    std::vector<std::pair<const char*, const Series*>> named;
    for (std::size_t i = 0; i < series.size(); ++i)
        named.emplace_back(schema::dimensions()[i].name, series[i]);
    return named;
}

}  // namespace deadpoint::report
