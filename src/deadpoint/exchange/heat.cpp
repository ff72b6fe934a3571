#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint {

double EnergyBalance::mismatch() const
{
    constexpr double nothing = 1e-6;  // [J]; a machine that neither warms nor cools has no balance to check
    const double scale =
        std::max({std::abs(generated), std::abs(to_air), std::abs(to_oil), std::abs(from_surfaces), std::abs(stored)});
    return scale > nothing ? std::abs(generated + from_surfaces - to_air - to_oil - stored) / scale : 0;
}

bool nothing_happens(const ThermalHistory& history, double tolerance)
{
    if (history.energy.generated != 0 || history.part_lowest.empty())
        return false;
    return std::ranges::max(history.part_highest) - std::ranges::min(history.part_lowest) <= tolerance;
}

double interpolate(const std::vector<double>& time, const Series& series, double at)
{
    if (at <= time.front())
        return series.value.front();
    if (at >= time.back())
        return series.value.back();
    const auto upper = std::upper_bound(time.begin(), time.end(), at);
    const auto k = static_cast<std::size_t>(upper - time.begin()) - 1;
    const double dt = time[k + 1] - time[k];
    const double s = (at - time[k]) / dt;
    const double from = series.value[k], to = series.value[k + 1];
    const double from_rate = dt * series.rate[k], to_rate = dt * series.rate[k + 1];
    return from * (1 + 2 * s) * (1 - s) * (1 - s) + from_rate * s * (1 - s) * (1 - s) + to * s * s * (3 - 2 * s) +
           to_rate * s * s * (s - 1);
}

}  // namespace deadpoint
