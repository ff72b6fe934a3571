#pragma once

#include "deadpoint/fem/fields.hpp"

#include <functional>
#include <vector>

namespace deadpoint {

struct HeatProblem;
struct DriftCauses;
struct DriftSeries;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::fem {
class Model;
}

/// Internal to study/: contributions of the heat sources to the gap (attribution).
namespace deadpoint::study {

/// Contributions at the step of the largest |E_SW|, if that is not the last one, and at the end.
/// @param model the model whose heat() has just computed the drift of this problem @param gap_at
/// the adjoint of E_SW, with the share of the crank's play that counts at a step
std::vector<DriftCauses> drift_causes(const casefile::Case& input, const HeatProblem& problem, const DriftSeries& drift,
                                      fem::Model& model, const std::function<fem::Adjoint(std::size_t row)>& gap_at);

}  // namespace deadpoint::study
