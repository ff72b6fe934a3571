#pragma once

#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct RunResult;
}

/// Studies on a reduced model.
namespace deadpoint::twin {

struct ReducedPress;

/// A point of a study that ended, with what is kept of its run.
struct EndedPoint {
    PointOutcome outcome;
    std::optional<press::RunRecord> record;  ///< of a point that is done
};

/// What a study on a reduced model needs from outside.
struct ReducedSweep {
    std::function<casefile::Case(const SweepPoint&)> read;  ///< the case of a point; by any thread
    /// What is kept of a run; by any thread. The run is dropped.
    std::function<press::RunRecord(std::size_t point, const casefile::Case&, const press::RunResult&)> record;
    /// Given each point that ended, in their order, by one thread at a time.
    std::function<void(std::size_t point, EndedPoint)> take;
    int threads = 1;
};

/// Runs points on a reduced model, some at a time, and keeps none of them. Points that agree in what loads depend on
/// share them. A point that fails is recorded with its reason, and the others go on. A warning is passed on with the
/// first point that gives it. After Observer::cancelled() the others are left, and not taken.
/// @param pending  indices of the points to run, ascending
void run_points_reduced(const std::vector<SweepPoint>& points, const std::vector<std::size_t>& pending,
                        const ReducedPress& press, const ReducedSweep& sweep, Observer& observer);

}  // namespace deadpoint::twin
