#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct Case;
}

/// Studies on a reduced model.
namespace deadpoint::study {

struct PointOutcome;
struct ReducedPress;
struct RunResult;
struct SweepPoint;

/// What a study on a reduced model needs from outside.
struct ReducedSweep {
    std::function<casefile::Case(const SweepPoint&)> read;  ///< the case of a point; called by one thread
    /// Called with each result, by one thread at a time, in the order of the points.
    std::function<void(std::size_t point, const casefile::Case&, const RunResult&)> take;
    int threads = 1;
};

/// Runs points on a reduced model, some at a time, and keeps none of them. A point that fails is recorded with its
/// reason, and the others go on. A warning is passed on with the first point that gives it. After Observer::cancelled()
/// the others are left.
/// @return as the points
std::vector<PointOutcome> run_points_reduced(const std::vector<SweepPoint>& points, const ReducedPress& press,
                                             const ReducedSweep& sweep, Observer& observer);

}  // namespace deadpoint::study
