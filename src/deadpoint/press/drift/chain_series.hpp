#pragma once

#include <cstddef>
#include <vector>

namespace deadpoint {
struct DriftSeries;
struct ThermalHistory;
}  // namespace deadpoint
namespace deadpoint::drift {
struct BearingPlay;
}

/// The dimension chain over time, from a history and a few figures. Needs no mesh.
namespace deadpoint::press {

struct ChainFigures;

/// Share of each bearing's growth that counts.
std::vector<double> play_shares(const drift::BearingPlay& play, const std::vector<double>& growths);

/// Factor of each bearing's growth in E_SW, with the shares of the growths that count.
std::vector<double> play_factors(const ChainFigures& chain, const std::vector<double>& shares);

/// Growth of each crank bearing's play at a row of a history [m].
std::vector<double> play_growths(const ChainFigures& chain, const ThermalHistory& history, std::size_t row);

/// The chain over time, from the functionals of the dimensions, which ThermalHistory::contributions
/// split.
DriftSeries drift_series(const ChainFigures& chain, const drift::BearingPlay& play, const ThermalHistory& history);

}  // namespace deadpoint::press
