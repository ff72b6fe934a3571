#pragma once

#include "deadpoint/reduce/online/dense_terms.hpp"

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct InterfaceLaw;
}  // namespace deadpoint

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// K less that of the solids: joints by their laws, and films of constant coefficient.
/// @throws InputError if a joint turns fully that did not when its terms were made, or the reverse
TermWeights conduction_terms(const DenseTerms& terms, const HeatProblem& problem,
                             const std::vector<InterfaceLaw>& laws);

}  // namespace deadpoint::reduce
