#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace deadpoint {

struct HeatCauses;
struct HeatProblem;
struct DriftCauses;
struct DriftSeries;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
struct Output;
}  // namespace deadpoint::casefile

/// Contributions of the heat sources to the gap (attribution).
namespace deadpoint::press {

/// Contributions at the step of the largest |E_SW|, if that is not the last one, and at the end.
/// @param causes_at  of E_SW at a row of the history, with the share of the crank's play that counts there
std::vector<DriftCauses> drift_causes(const casefile::Case& input, const HeatProblem& problem, const DriftSeries& drift,
                                      const std::function<HeatCauses(std::size_t row)>& causes_at);

/// True if the causes are computed on a basis of a few fields.
bool causes_on_basis(const casefile::Output& output, long long temperatures);

}  // namespace deadpoint::press
