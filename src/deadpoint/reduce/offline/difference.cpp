#include "deadpoint/reduce/offline/difference.hpp"

#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace deadpoint::reduce {
void RunDifference::widen(const RunDifference& other)
{
    temperature = std::max(temperature, other.temperature);
    gap = std::max(gap, other.gap);
}

namespace {

// At the times of the other run.
RunDifference at_steps_of(const ThermalHistory& other, const ThermalHistory& run, std::size_t functional)
{
    RunDifference result;
    double segment_start = 0;
    for (std::size_t k = 0; k < other.time.size(); ++k) {
        const double time = other.time[k];
        if (k > 0 && time == other.time[k - 1])
            segment_start = time;
        const bool ends = k + 1 == other.time.size() || other.time[k + 1] == time;
        if (time < segment_start + settled_after && !ends)
            continue;
        const auto off = [&](const std::vector<Series>& these, const std::vector<Series>& those, double& largest) {
            for (std::size_t i = 0; i < those.size(); ++i)
                largest = std::max(largest, std::abs(interpolate(run.time, these[i], time) - those[i].value[k]));
        };
        off(run.probes, other.probes, result.temperature);
        off(run.interface_a, other.interface_a, result.temperature);
        off(run.interface_b, other.interface_b, result.temperature);
        if (functional < other.functionals.size())
            result.gap = std::max(result.gap, std::abs(interpolate(run.time, run.functionals[functional], time) -
                                                       other.functionals[functional].value[k]));
    }
    return result;
}

}  // namespace

RunDifference difference(const ThermalHistory& run, const ThermalHistory& other, std::size_t functional)
{
    auto result = at_steps_of(other, run, functional);
    result.widen(at_steps_of(run, other, functional));
    return result;
}

}  // namespace deadpoint::reduce
