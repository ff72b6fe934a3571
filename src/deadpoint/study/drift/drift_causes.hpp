#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/fem/model.hpp"

#include <functional>
#include <vector>

/// Internal to study/: which heat has moved the gap.
namespace deadpoint::study {

/// By cause, at the step of the largest |E_SW|, where that is not the last one, and at the end.
/// @param model  whose heat() has just made the drift, of this problem
/// @param gap_at  the adjoint of E_SW, with what counts of the crank's play at a step
std::vector<DriftCauses> drift_causes(const casefile::Case& input, const HeatProblem& problem, const DriftSeries& drift,
                                      fem::Model& model, const std::function<fem::Adjoint(std::size_t row)>& gap_at);

}  // namespace deadpoint::study
