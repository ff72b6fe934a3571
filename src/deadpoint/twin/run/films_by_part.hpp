#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <cstddef>
#include <vector>

namespace deadpoint {
struct Machine;
}

/// Surface conditions part by part, as a reduced model has them.
namespace deadpoint::twin {

/// A problem whose surface conditions lie on one part each. A law of convection is then evaluated at the mean
/// temperature of a piece of the surface.
struct SplitProblem {
    HeatProblem problem;
    std::vector<std::size_t> whole;  ///< per condition: the condition of the problem that was split
};

/// Radiation among surfaces is shared among their pieces by area: the exchange of pieces p of i and q of j is
///   X_pq = X_ij A_p / A_i A_q / A_j.
SplitProblem split_by_part(const HeatProblem& problem, const Machine& machine);

/// Values per condition, summed to those of the conditions that were split. @param count of those
std::vector<double> summed(const SplitProblem& split, const std::vector<double>& by_piece, std::size_t count);

}  // namespace deadpoint::twin
