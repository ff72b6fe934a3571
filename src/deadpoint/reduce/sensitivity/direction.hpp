#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/reduce/sensitivity/heat_scalars.hpp"

#include <memory>
#include <vector>

/// Ways in which a heat problem can change, by which a run is derived.
namespace deadpoint::reduce {

struct FreeCoefficient;

/// Two problems that differ in scalars of ScalarLayout only.
struct ProblemPair {
    HeatProblem less, more;
    double by = 1;  ///< difference of the coefficient between both
};

/// Change of a problem per unit of a coefficient.
struct Direction {
    std::vector<ScalarChanges> lasting;  ///< per segment, throughout it
    /// What changes over time or with the temperatures is read off these two; null: nothing does. Also the
    /// temperatures of the start.
    std::shared_ptr<const ProblemPair> passing;
};

/// (more - less) / by. Central differences, unless the problem is linear in the coefficient.
Direction direction_between(HeatProblem less, HeatProblem more, double by);

/// The direction of each coefficient of a box. The problem's coefficients are linear in each value of a box.
/// @param problem  without the values
std::vector<Direction> directions(const HeatProblem& problem, const std::vector<FreeCoefficient>& box,
                                  const std::vector<double>& values);

/// The direction in which a coefficient of a box changes by as much as it has in this problem: films, conductances, oil
/// and heat by a factor; oil that has no coefficient by 1 W/m2/K; temperatures of oil and ambient by 1 K throughout the
/// run. A film that follows the temperature changes by a factor on all that it gives to its air and its ambient.
Direction relative_direction(const HeatProblem& problem, const FreeCoefficient& coefficient);

}  // namespace deadpoint::reduce
