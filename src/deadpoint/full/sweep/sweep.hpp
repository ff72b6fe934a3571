#pragma once

#include <csignal>
#include <cstddef>
#include <functional>
#include <vector>

namespace deadpoint {
class Observer;
struct Machine;
}  // namespace deadpoint

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::twin {
struct PointOutcome;
struct SweepPoint;
}  // namespace deadpoint::twin

/// Running many cases that share meshes and model.
namespace deadpoint::full {

class Press;

/// Scales all cell sizes that a case states.
void scale_sizes(casefile::Case& input, double factor);

/// Runs a point on its press, whose meshes and model it shares, and writes its results. With
/// several workers it is called in a separate process: changes in memory are lost, written files
/// stay.
using PointAction = std::function<void(const twin::SweepPoint&, Press&)>;

/// Asks the process of a point to stop; whoever lets an Observer be cancelled by signals handles it quietly. A process
/// that does not is ended by it.
inline constexpr int stop_signal = SIGUSR1;

struct SweepOptions {
    int workers = 0;  ///< points at a time, on one rank; 0: as many as cores and memory hold
    /// Called when the machine of a group is meshed, before its model is prepared.
    std::function<void(const Machine&)> on_meshed;
    /// Called when a group of points is prepared, with their number and how many will run at a time.
    std::function<void(const Machine&, std::size_t points, int workers)> on_prepared;
};

/// The largest number of the pending points that share meshes and model.
std::size_t most_alike(const std::vector<casefile::Case>& cases, const std::vector<std::size_t>& pending);

/// Runs points, grouped by what they share (press::model_part): each group's machine is meshed and its model prepared
/// once; with several workers, child processes then take the points over in turn, each with the prepared memory as it
/// is.
///
/// A point whose case fails is recorded with the reason, and the others go on; so is one whose process dies. Once the
/// observer is cancelled no further point is begun; those being run stop too and count as left.
///
/// @param cases    of the points, same order
/// @param pending  indices of the points to run
/// @return as the points; those not pending are left as State::left
/// @throws IoError if a process cannot be started
std::vector<twin::PointOutcome> run_points(const std::vector<twin::SweepPoint>& points,
                                           const std::vector<casefile::Case>& cases,
                                           const std::vector<std::size_t>& pending, const SweepOptions& options,
                                           const PointAction& action, Observer& observer);

}  // namespace deadpoint::full
