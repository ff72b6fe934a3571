#include "deadpoint/press/drift/chain_series.hpp"

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/press/drift/chain_figures.hpp"
#include "deadpoint/press/drift/series_sum.hpp"

#include <algorithm>

namespace deadpoint::press {
namespace {

// What the crank's play follows of its bearings' growths.
Series mean_play(const ChainFigures& chain, const drift::BearingPlay& play, const ThermalHistory& history)
{
    const int count = chain.bearings;
    Series mean{std::vector<double>(history.time.size(), 0.0), std::vector<double>(history.time.size(), 0.0)};
    for (int b = 0; b < count; ++b) {
        const auto& growth = history.functionals[static_cast<std::size_t>(drift::dimension_count + b)];
        for (std::size_t i = 0; i < history.time.size(); ++i) {
            mean.value[i] += play.taken(growth.value[i]) / count;
            mean.rate[i] += play.slope(growth.value[i]) * growth.rate[i] / count;
        }
    }
    return mean;
}

// The gap by part: its split, and that of each bearing's growth by the share of the growth that counts.
std::vector<std::vector<double>> by_part(const ChainFigures& chain, const drift::BearingPlay& play,
                                         const ThermalHistory& history)
{
    const std::size_t parts = history.contributions.size() / static_cast<std::size_t>(1 + chain.bearings);
    std::vector<std::vector<double>> result(history.contributions.begin(),
                                            history.contributions.begin() + static_cast<std::ptrdiff_t>(parts));
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        const auto factors = play_factors(chain, play_shares(play, play_growths(chain, history, i)));
        for (std::size_t b = 0; b < factors.size(); ++b)
            for (std::size_t p = 0; p < parts; ++p)
                result[p][i] += factors[b] * history.contributions[(1 + b) * parts + p][i];
    }
    return result;
}

}  // namespace

std::vector<double> play_shares(const drift::BearingPlay& play, const std::vector<double>& growths)
{
    std::vector<double> shares;
    for (const double growth : growths)
        shares.push_back(play.share(growth));
    return shares;
}

std::vector<double> play_factors(const ChainFigures& chain, const std::vector<double>& shares)
{
    std::vector<double> factors;
    for (const double share : shares)
        factors.push_back(chain.travel_by_play / std::max(chain.bearings, 1) * share);
    return factors;
}

std::vector<double> play_growths(const ChainFigures& chain, const ThermalHistory& history, std::size_t row)
{
    std::vector<double> growths;
    for (int b = 0; b < chain.bearings; ++b)
        growths.push_back(history.functionals[static_cast<std::size_t>(drift::dimension_count + b)].value[row]);
    return growths;
}

DriftSeries drift_series(const ChainFigures& chain, const drift::BearingPlay& play, const ThermalHistory& history)
{
    const auto& f = history.functionals;
    DriftSeries drift;
    drift.time = history.time;
    drift.bearing_to_ground = f[drift::bearing_to_ground];
    drift.table_to_ground = f[drift::table_to_ground];
    const Series taken = mean_play(chain, play, history);
    drift.clearance = combined({{-chain.pressed_along_stroke, &taken}});
    drift.play = combined({{chain.travel_by_play, &taken}});
    drift.gap = combined({{1, &f[drift::gap]}, {1, &drift.play}});
    drift.crank_to_slide = combined(
        {{1, &drift.bearing_to_ground}, {-1, &drift.clearance}, {-1, &f[drift::slide_height]}, {-1, &drift.play}});
    drift.by_part = by_part(chain, play, history);
    return drift;
}

}  // namespace deadpoint::press
